// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/unrefined/exemptions.h"

#include "glark/core/context_options.h"

namespace glark::core {
namespace {

bool tests_depth(const ExemptionFacts& facts) { return facts.bindings.depth_test && facts.depth_buffer; }

bool ignores_depth(const ExemptionFacts& facts) {
  return !tests_depth(facts) || (facts.bindings.depth_function == GL_ALWAYS && !facts.bindings.depth_writes);
}

// Rules that the user has asked for.
std::optional<Cause> named_exemption(const ExemptionFacts& facts) {
  const Bindings& b = facts.bindings;
  if (facts.left_alone) {
    return Cause::left_shader;
  }
  if ((facts.rules & left_draws::blended) != 0 && b.blend) {
    return Cause::blended;
  }
  if ((facts.rules & left_draws::no_depth_test) != 0 && !tests_depth(facts)) {
    return Cause::no_depth_test;
  }
  if ((facts.rules & left_draws::no_depth_writes) != 0 && (!tests_depth(facts) || !b.depth_writes)) {
    return Cause::no_depth_writes;
  }
  return std::nullopt;
}

}  // namespace

bool needs_matrices(const ExemptionFacts& facts) {
  const bool asks = (facts.rules & left_draws::orthographic) != 0 ||
                    (ignores_depth(facts) && (facts.rules & left_draws::by_default) != 0);
  return facts.conventional && asks && !named_exemption(facts);
}

std::optional<Cause> exemption(const ExemptionFacts& facts) {
  if (const std::optional<Cause> cause = named_exemption(facts)) {
    return cause;
  }
  const MatrixTraits& matrices = facts.matrices;
  const bool ignored = ignores_depth(facts);
  // Neither a user interface nor a full-screen pass is drawn in perspective.
  if (ignored && (!facts.conventional || (facts.rules & left_draws::by_default) == 0 || matrices.affine)) {
    if ((facts.rules & left_draws::screen_quads) != 0 && facts.triangles > 0 && facts.triangles <= 2) {
      return Cause::screen_quad;
    }
    if ((facts.rules & left_draws::overlays) != 0 && facts.bindings.blend) {
      return Cause::overlay;
    }
  }
  const bool plane = matrices.projects_plane && matrices.moves_in_plane;
  if (facts.conventional && (facts.rules & left_draws::orthographic) != 0 && ((ignored && matrices.affine) || plane)) {
    return Cause::orthographic;
  }
  return std::nullopt;
}

}  // namespace glark::core
