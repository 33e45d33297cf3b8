// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/refinement_choice.h"

namespace glark::core {
namespace {

// Returns the reason why the vertex stage may not run between the corners, if there is one.
std::optional<RefinementFallback> needs_outputs(const RefinementFacts& facts) {
  if (facts.stage.reads_vertex_id) {
    return RefinementFallback::vertex_id;
  }
  if (facts.stage.writes_cull_distance) {
    return RefinementFallback::cull_distance;
  }
  // Integers are names (bones, layers). If the corners of a triangle name different things, the stage cannot run
  // between them. A program that uses the extension is told so and gets the provoking corner's integers.
  if (facts.transparent && facts.inputs.has_integers) {
    return RefinementFallback::integer_input;
  }
  return std::nullopt;
}

}  // namespace

Refinement wanted_refinement(const ContextOptions& options, const ArkState& ark) {
  return options.transparent ? options.refinement : ark.refinement;
}

RefinementChoice choose_refinement(const RefinementFacts& facts) {
  const RefinementTraits& wanted = traits_of(facts.wanted);
  if (wanted.interpolates_outputs) {
    return {facts.wanted, std::nullopt};
  }
  if (const std::optional<RefinementFallback> fallback = needs_outputs(facts)) {
    return {Refinement::linear_outputs, fallback};
  }
  if (wanted.curves_positions && !facts.inputs.can_curve) {
    return {Refinement::linear_inputs, RefinementFallback::no_normal};
  }
  return {facts.wanted, std::nullopt};
}

}  // namespace glark::core
