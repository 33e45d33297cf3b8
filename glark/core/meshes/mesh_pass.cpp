// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/meshes/mesh_pass.h"

namespace glark::core {
namespace {

// The draw reaches no framebuffer, or would look the same curved.
bool draws_no_surface(Cause cause) {
  return cause == Cause::render_mode || cause == Cause::rasterizer_discard || cause == Cause::invalid_draw ||
         cause == Cause::level_zero;
}

bool is_user_interface(Cause cause) {
  return cause == Cause::screen_quad || cause == Cause::overlay || cause == Cause::orthographic;
}

// A quad that sets the depth of all its pixels, whatever lies there, clears depth or copies it from a texture.
bool sets_depth_of_screen(const Bindings& b, std::uint64_t triangles) {
  return triangles > 0 && triangles <= 2 && b.depth_function == GL_ALWAYS && !b.stencil_test;
}

}  // namespace

std::optional<MeshPass> mesh_pass(const MeshPassFacts& facts, std::optional<Cause> cause) {
  const Bindings& b = facts.bindings;
  const bool tests = b.depth_test && facts.depth_buffer;
  if (cause && (draws_no_surface(*cause) || is_user_interface(*cause))) {
    return std::nullopt;
  }
  const bool shows = b.color_writes && facts.color_buffer;
  if (cause == Cause::no_surface && !shows && sets_depth_of_screen(b, facts.triangles)) {
    return std::nullopt;
  }
  MeshPass pass;
  pass.curves = !cause;
  pass.compiles = cause == Cause::compiling;
  pass.uses_depth = tests && (b.depth_function != GL_ALWAYS || b.depth_writes);
  pass.writes_depth = tests && b.depth_writes;
  pass.equal = tests && b.depth_function == GL_EQUAL;
  pass.shows = shows;
  pass.marks = b.stencil_test;
  pass.behind = cause == Cause::budget;
  // Lines and points are drawn near a surface, not on it to the bit.
  if (cause == Cause::not_triangles) {
    pass.equal = pass.marks = false;
  }
  return pass;
}

}  // namespace glark::core
