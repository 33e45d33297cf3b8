// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The triangles of refined vertices: for each coarse triangle, those of a uniform pattern. All draws of a level share
// one index buffer.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "glark/core/pattern/gpu_pool.h"

namespace glark::evaluate {

// Refined vertices of one coarse triangle.
constexpr std::uint64_t lattice_points(unsigned level) {
  const std::uint64_t segments = std::uint64_t{1} << level;
  return (segments + 1) * (segments + 2) / 2;
}
// Indices of one coarse triangle.
constexpr std::uint64_t lattice_indices(unsigned level) { return std::uint64_t{3} << (2 * level); }

class GridIndices {
 public:
  struct Grid {
    GLuint indices = 0;             // a buffer of uint32; 0: there is no memory
    std::uint32_t index_count = 0;  // of one coarse triangle
    GLint first_vertex = 0;         // of the pattern in the pool
    GLsizei vertex_count = 0;
  };

  std::int64_t bytes() const { return bytes_with(0, 0); }  // of all index buffers
  // The bytes of all index buffers, once `level` has room for so many coarse triangles.
  std::int64_t bytes_with(unsigned level, std::uint32_t triangles) const;
  // `pool_number`: pools of other levels have their patterns in other places. Needs an ErrorScope.
  Grid ensure(const gl::Dispatch& gl, const pattern::GpuPool& pool, std::uint64_t pool_number, unsigned level,
              std::uint32_t triangles);
  void release(const gl::Dispatch& gl);

 private:
  struct Level {
    std::uint64_t pool_number = 0;       // of the pool that the pattern was read from; 0: it was not read
    std::vector<std::uint16_t> pattern;  // indices from first_vertex on
    GLint first_vertex = 0;
    GLsizei vertex_count = 0;
    core::GpuBuffer buffer;
    std::uint32_t triangles = 0;   // coarse ones in the buffer
    std::int64_t older_bytes = 0;  // of smaller buffers, which vertex arrays keep alive

    std::uint32_t grown(std::uint32_t wanted) const {
      return wanted <= triangles ? triangles : std::max(wanted, triangles + triangles / 2);
    }
  };
  static bool read_pattern(const gl::Dispatch& gl, const pattern::GpuPool& pool, unsigned number, Level& level);
  static bool fill(const gl::Dispatch& gl, Level& level, std::uint32_t triangles);
  static void write(const gl::Dispatch& gl, const Level& level, std::uint32_t first, std::uint32_t triangles);

  std::array<Level, pattern::deepest_uniform + 1> levels_;
};

}  // namespace glark::evaluate
