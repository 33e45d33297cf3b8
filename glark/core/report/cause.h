// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace glark::core {

// The reason why a draw stays unrefined. A function that decides returns std::optional<Cause>; an empty one means that
// the draw may be refined.
enum class Cause {
  not_triangles,        // points, lines, patches, adjacency
  level_zero,           // uniform level 0 with a built-in refinement: the original is the refined draw
  no_program,           // nothing bound that could be refined
  program_not_derived,  // the derived program could not be built
  program_pipeline,     // a pipeline without a vertex program that glark knows
  program_gone,         // deleted, or not linked again
  program_binary,       // a program binary or SPIR-V: there is no source to derive from
  assembly_program,     // ARB vertex program
  tessellation,         // the application has tessellation stages
  too_many_attributes,  // the coarse record does not fit
  primitive_id,         // a later stage counts the triangles
  cull_distance,        // a later stage reads gl_CullDistance, which refined triangles need otherwise
  materials_vary,       // glMaterial between the vertices of a list whose first ones inherit a material
  geometry_shader,      // a geometry shader whose triangles do not depend on the corners
  side_effects,         // vertex stage writes buffers, images or atomics
  transform_feedback,   // the application captures
  primitive_query,      // the application counts primitives
  polygon_mode,         // lines or points asked for
  render_mode,          // select or feedback
  rasterizer_discard,   // nothing would be visible
  indirect_unbounded,   // a count that only the GPU knows and that cannot be bounded
  invalid_draw,         // GL will raise an error
  out_of_memory,        // no room for the capture
  left_shader,          // the user named its shader program
  rule,                 // a rule of the configuration file
  screen_quad,  // transparent refinement leaves user interfaces and full-screen passes alone: plan/unrefined/exemptions.h
  overlay,
  orthographic,
  blended,  // the user asked for these three
  no_depth_test,
  no_depth_writes,
  no_surface,       // smooth: nothing says how the mesh curves
  mesh_waits,       // smooth curves a mesh from its third frame on: meshes/mesh_table.h
  mesh_flat,        // smooth: another pass over the mesh cannot be curved
  unknown_partner,  // smooth: a pass that cannot be curved must meet an unknown mesh
  compiling,        // the programs of the draw are compiled in the next frames: objects/compilation.h
  budget,           // depth would not show, and a budget is set: plan/depths/budget_choice.h
};
inline constexpr unsigned cause_count = static_cast<unsigned>(Cause::budget) + 1;

// `key` names the cause in the statistics file; `remedy` completes the log line.
struct CauseText {
  std::string_view key;
  std::string_view explanation;
  std::string_view remedy;
};
const CauseText& text_of(Cause cause);

}  // namespace glark::core
