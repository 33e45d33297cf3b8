// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The pattern pool in buffer objects.
#pragma once

#include <cstdint>
#include <vector>

#include "glark/core/objects/gpu_buffer.h"
#include "glark/core/pattern/expand.h"
#include "glark/core/pattern/pool.h"

namespace glark::pattern {

class GpuPool {
 public:
  // Builds the pool of `max_level` and uploads it. False without memory: the old pool is kept. Wrap in an ErrorScope.
  bool build(const gl::Dispatch& gl, unsigned max_level, bool nested);
  void release(const gl::Dispatch& gl);

  bool built() const { return vertices_.name() != 0; }
  unsigned max_level() const { return max_level_; }
  bool nested() const { return nested_; }
  GLuint vertices() const { return vertices_.name(); }  // LatticeVertex
  GLuint indices() const { return indices_.name(); }    // uint16
  GLuint patches() const { return patches_.name(); }    // vec4: the tiles of uniform levels, see first_tile()
  // A DrawElementsIndirectCommand for each uniform piece. Only the number of instances is missing: a draw writes it there
  // if the GPU counted its triangles.
  const core::GpuBuffer& commands() const { return commands_; }
  static GLintptr command_of(unsigned uniform_level) { return static_cast<GLintptr>(uniform_level) * command_bytes; }
  const Piece& piece(int index) const { return pieces_[static_cast<std::size_t>(index)]; }
  // Reads the indices of a piece back; none if GL cannot map them. For rare paths.
  std::vector<std::uint16_t> read_indices(const gl::Dispatch& gl, const Piece& piece) const;
  std::int64_t gpu_bytes() const { return vertices_.size() + indices_.size() + patches_.size() + commands_.size(); }

  // A uniform level is drawn as tile_count(level) tiles of uniform(min(level, deepest_uniform)).
  static unsigned tile_count(unsigned level) {
    return level <= deepest_uniform ? 1U : 1U << (2 * (level - deepest_uniform));
  }
  static unsigned first_tile(unsigned level);

 private:
  static constexpr GLintptr command_bytes = 20;

  unsigned max_level_ = 0;
  bool nested_ = false;
  core::GpuBuffer vertices_;
  core::GpuBuffer indices_;
  core::GpuBuffer patches_;
  core::GpuBuffer commands_;
  PieceTable pieces_{};
};

}  // namespace glark::pattern
