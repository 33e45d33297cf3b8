// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/budget_choice.h"

namespace glark::core {

bool spends_on_curves(const ContextOptions& options, const ArkState& ark, Refinement wanted,
                      const depth::DepthPlan& depth) {
  return options.transparent && !ark.enabled && depth.measured && depth.measure.budget > 0 &&
         traits_of(wanted).curves_positions;
}

// A draw that must meet another one is no background, though it may write no depth itself: the other one has written it.
bool is_background(const VisibilityFacts& facts) {
  const Bindings& b = facts.bindings;
  const bool tests = b.depth_test && facts.depth_buffer;
  if (b.blend || (tests && b.depth_writes) || !facts.others_write_depth || !draws_colors(facts)) {
    return false;
  }
  const bool meets_nothing = !tests || b.depth_function == GL_ALWAYS;
  return meets_nothing || (b.depth_function != GL_EQUAL && !facts.mesh_writes_depth);
}

bool draws_colors(const VisibilityFacts& facts) { return facts.bindings.color_writes && facts.color_buffer; }

}  // namespace glark::core
