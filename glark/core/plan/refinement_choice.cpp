// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/refinement_choice.h"

namespace glark::core {
namespace {

// Returns the reason why positions may not be computed from interpolated inputs, if there is one.
std::optional<RefinementFallback> unsound_position(const RefinementFacts& facts) {
  const refine::OutputVariation* const position = facts.variation.position();
  const refine::Variation variation = position != nullptr ? position->variation : refine::Variation::constant;
  if (variation >= refine::Variation::switched) {
    return RefinementFallback::unsound_stage;
  }
  if (variation == refine::Variation::continuous && (!facts.inputs.can_curve || facts.made_normal)) {
    return RefinementFallback::bent_unknowing;
  }
  return std::nullopt;
}

// Returns the reason why the vertex stage may not run between the corners, if there is one. A program that uses the
// extension gets what the extension's text says: it has said itself what is a surface.
std::optional<RefinementFallback> needs_outputs(const RefinementFacts& facts) {
  if (facts.stage.writes_cull_distance) {
    return RefinementFallback::cull_distance;
  }
  if (facts.transparent) {
    return unsound_position(facts);
  }
  return facts.stage.reads_vertex_id ? std::optional(RefinementFallback::vertex_id) : std::nullopt;
}

}  // namespace

Refinement wanted_refinement(const ContextOptions& options, const ArkState& ark) {
  // A program that calls the extension has said what it wants; smooth does not overrule it.
  const bool asks_itself = !options.transparent || (options.smooth && ark.enabled);
  return asks_itself ? ark.refinement : options.refinement;
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
  if (wanted.curves_positions && facts.flat_shaded) {
    return {Refinement::linear_inputs, RefinementFallback::flat_shading};
  }
  return {facts.wanted, std::nullopt};
}

}  // namespace glark::core
