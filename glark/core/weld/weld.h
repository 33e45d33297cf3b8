// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Welds the coarse triangles of a draw by position, on the GPU. Programs split vertices where normals or texture
// coordinates jump. The values that two triangles share there must be computed from data that both have. Positions are
// equal if their bits are (-0 is 0), or, if the plan limits edges, if they differ by rounding (cells.glsl).
// - Edges: the control points of curved PN triangles, from the normals of all sides (weld.glsl), at
//   Layout::control_offset. They stay near the edge if the plan limits them (creases.glsl). If normals are measured,
//   the side that turns most, at Layout::turn_offset.
// - Vertices: the greatest of the depth tags at a position.
// - Displacement: the texture coordinates of one side of each edge, and a normal and a texture coordinate of each
//   position, at Layout::border_offset.
#pragma once

#include <array>
#include <cstdint>
#include <iterator>
#include <span>

#include "glark/core/capture/coarse_triangles.h"
#include "glark/core/capture/layout.h"
#include "glark/core/objects/gpu_buffer.h"
#include "glark/core/objects/programs/compilation.h"
#include "glark/core/objects/programs/compute_pass.h"
#include "glark/core/weld/geometry_normals.h"
#include "glark/gl/dispatch.h"

namespace glark::weld {

inline constexpr float no_crease = 180;  // degrees: curved triangles follow the normals without limits

struct WeldPlan {
  bool on = false;             // welds edges if the layout has room for them, and tags if it has any
  bool edges_later = false;    // welds the edges of the triangles that polygons are split into
  bool makes_normals = false;  // from the positions, before anything else
  float crease = no_crease;  // degrees; edges stay straight whose faces meet at more although they share their normals

  // Returns whether curved triangles stay near their coarse ones. Tags need the words of the tables for themselves.
  bool creased(const capture::Layout& layout) const { return crease < no_crease && layout.welded() && !layout.tagged; }
};

struct WeldRequest {
  const WeldPlan* plan = nullptr;
  const capture::Layout* layout = nullptr;
  capture::CoarseTriangles triangles;
  // Words of a corner besides the position that keep vertices apart: the values that differ between instances.
  std::span<const GLint> key_words;
  bool edges = false;
  bool tags = false;
  bool normals = false;
};

inline constexpr std::size_t most_key_words = 512;  // more than all attributes have

// Bounds of loops, as uniforms: compilers would unroll loops with constants.
inline constexpr GLint ends_of_edge = 2;
inline constexpr GLint corners_of_triangle = 3;

class WeldStage {
 public:
  WeldStage(core::Compilation& compilation, capture::Language language)
      : gl_(compilation.gl()), compilation_(compilation), language_(language), normals_(compilation, language) {}

  // Returns whether the tables for `triangles` triangles fit into a storage block.
  bool can_hold(const WeldPlan& plan, const capture::Layout& layout, std::uint64_t triangles);
  bool has_room(const WeldPlan& plan, const capture::Layout& layout, std::uint32_t triangles) const;
  // Compiles the passes when they are first needed; false without memory, or if some must wait. Rare path: wrap in an ErrorScope.
  bool reserve(const WeldPlan& plan, const capture::Layout& layout, std::uint32_t triangles);
  // Writes into the records themselves. Changes the program and the storage buffer bindings 0 to 2, which the caller
  // restores. `captured_count`: holds the CountCommand of triangles that are counted on the GPU.
  void run(const WeldRequest& request, GLuint captured_count);
  void release();

 private:
  // In their order. Each is small, because the time to compile a pass grows faster than its size.
  enum class Pass { clear, place, join, rank_turns, measure_faces, look_beyond, mark, write };
  static constexpr Pass all_passes[] = {Pass::clear,         Pass::place,       Pass::join, Pass::rank_turns,
                                        Pass::measure_faces, Pass::look_beyond, Pass::mark, Pass::write};
  static bool needs(const WeldPlan& plan, const capture::Layout& layout, Pass pass);
  // What the passes can do. A pass that can do less compiles faster.
  enum class Ability { plain, displaced, creased };
  static Ability ability(const WeldPlan& plan, const capture::Layout& layout);
  core::ComputePass& pass(Ability ability, Pass pass);
  const core::ComputePass& pass(Ability ability, Pass pass) const;
  bool build(Ability ability, Pass pass);
  bool build_all(const WeldPlan& plan, const capture::Layout& layout);
  void upload_keys(const WeldRequest& request) const;
  void make_normals(const WeldRequest& request) const;
  void weld(const WeldRequest& request) const;
  void dispatch(Pass pass, const WeldRequest& request, std::uint32_t invocations) const;

  const gl::Dispatch& gl_;
  core::Compilation& compilation_;
  capture::Language language_;
  std::array<std::array<core::ComputePass, std::size(all_passes)>, 3> passes_;  // by ability
  GeometryNormals normals_;
  core::GpuBuffer tables_;
  GLint64 largest_block_ = 0;
};

}  // namespace glark::weld
