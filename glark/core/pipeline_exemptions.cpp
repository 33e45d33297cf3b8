// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws that transparent refinement leaves as they are: user interfaces, full-screen passes, and what the user names.
//
// A draw that neither reads nor writes depth cannot meet another one by its depth values, so leaving it alone cannot part the
// passes of a program that draws the same triangles twice. That is the condition of every rule that holds by default, but for
// drawings in the plane, which are left by their matrices alone: all passes of them or none.
#include "glark/core/context.h"
#include "glark/core/pipeline.h"

namespace glark::core {
namespace {

bool ignores_depth(const Bindings& b) { return !b.depth_test || (b.depth_function == GL_ALWAYS && !b.depth_writes); }

}  // namespace

bool Pipeline::leaves_draws() const {
  return context_.options().transparent && !context_.ark().enabled &&
         (context_.options().left_draws != 0 || !context_.options().left_shaders.empty());
}

Cause Pipeline::exemption(const Program& program, std::uint64_t triangles) {
  namespace left = left_draws;
  const Bindings& b = context_.state().bindings();
  const unsigned rules = context_.options().left_draws;
  if (program.left_alone) {
    return Cause::left_shader;
  }
  if ((rules & left::blended) != 0 && b.blend) {
    return Cause::blended;
  }
  if ((rules & left::no_depth_test) != 0 && !b.depth_test) {
    return Cause::no_depth_test;
  }
  if ((rules & left::no_depth_writes) != 0 && (!b.depth_test || !b.depth_writes)) {
    return Cause::no_depth_writes;
  }
  // What is drawn in perspective is neither a user interface nor a full-screen pass.
  const bool conventional = program.conventional_projection && context_.is_compatibility();
  const bool ignored = ignores_depth(b);
  if (ignored && (!conventional || (rules & left::by_default) == 0 || context_.state().matrices().traits(gl_).affine)) {
    if ((rules & left::screen_quads) != 0 && triangles > 0 && triangles <= 2) {
      return Cause::screen_quad;
    }
    if ((rules & left::overlays) != 0 && b.blend) {
      return Cause::overlay;
    }
  }
  if (conventional && (rules & left::orthographic) != 0) {
    const MatrixTraits& traits = context_.state().matrices().traits(gl_);
    if ((ignored && traits.affine) || (traits.projects_plane && traits.moves_in_plane)) {
      return Cause::orthographic;
    }
  }
  return Cause::count_;
}

}  // namespace glark::core
