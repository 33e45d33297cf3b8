// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/meshes/mesh_pass.h"

#include <algorithm>

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

// A quad that sets the depth of all its pixels, whatever lies there, clears depth or copies it from a texture. So does one
// whose fragment stage computes the depth, perhaps into a shadow map that was just cleared.
bool sets_depth_of_screen(const MeshPassFacts& facts) {
  const Bindings& b = facts.bindings;
  const bool sets = b.depth_function == GL_ALWAYS || (facts.fragment_depth && b.depth_function != GL_EQUAL);
  return facts.triangles > 0 && facts.triangles <= 2 && sets && !b.stencil_test;
}

// Draws that compare strictly never lie on an earlier one, unless an offset moves one of them.
bool may_lie_on_others(const Bindings& b) {
  switch (b.depth_function) {
    case GL_ALWAYS:
    case GL_NEVER: return false;
    case GL_LESS:
    case GL_GREATER: return b.polygon_offset;
    default: return true;
  }
}

std::uint64_t target_of(GLuint framebuffer, const std::array<float, 2>& viewport) {
  static constexpr float longest = 65535;
  const auto side = [](float length) { return static_cast<std::uint64_t>(std::clamp(length, 0.F, longest)); };
  return (std::uint64_t{framebuffer} + 1) << 32U | side(viewport[0]) << 16U | side(viewport[1]);
}

}  // namespace

std::optional<MeshPass> mesh_pass(const MeshPassFacts& facts, std::optional<Cause> cause) {
  const Bindings& b = facts.bindings;
  const bool tests = b.depth_test && facts.depth_buffer;
  if (cause && (draws_no_surface(*cause) || is_user_interface(*cause))) {
    return std::nullopt;
  }
  const bool shows = b.color_writes && facts.color_buffer;
  if (cause == Cause::no_surface && !shows && sets_depth_of_screen(facts)) {
    return std::nullopt;
  }
  MeshPass pass;
  pass.curves = !cause;
  pass.compiles = cause == Cause::compiling;
  pass.uses_depth = tests && (b.depth_function != GL_ALWAYS || b.depth_writes);
  pass.writes_depth = tests && b.depth_writes;
  pass.equal = tests && b.depth_function == GL_EQUAL;
  pass.meets_depth = tests && may_lie_on_others(b);
  pass.shows = shows;
  pass.marks = b.stencil_test && facts.stencil != 0;
  pass.behind = cause == Cause::budget;
  pass.stencil = facts.stencil;
  pass.target = target_of(facts.framebuffer, b.viewport);
  if (cause == Cause::not_triangles) {
    pass.lines = true;
    pass.equal = pass.meets_depth = false;
  }
  return pass;
}

}  // namespace glark::core
