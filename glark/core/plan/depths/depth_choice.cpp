// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/depths/depth_choice.h"

#include <algorithm>
#include <cmath>

#include "glark/core/capture/layout.h"

namespace glark::core {
namespace {

// The depth for a current value of the tag attribute: the nearest integer from 0 to the level of the pool.
unsigned nearest_depth(double value, int pool_level) {
  const double tag = std::isnan(value) ? 0.0 : value;  // a double, because a float + 0.5 may not be a float
  return static_cast<unsigned>(std::clamp(std::floor(tag + 0.5), 0.0, static_cast<double>(pool_level)));
}

depth::DepthPlan depths_by_tags(const DepthFacts& facts) {
  const ArkState& ark = facts.ark;
  depth::DepthPlan plan;
  // Uniform patterns are cut differently: a morphing draw that became uniform would pop.
  plan.adaptive = facts.tags_vary || (ark.geomorph && facts.current_tag > 0);
  plan.level = plan.adaptive ? 0 : nearest_depth(facts.current_tag, ark.pool_level);
  plan.deepest = static_cast<unsigned>(ark.pool_level);
  return plan;
}

depth::DepthPlan wanted_depths(const DepthFacts& facts) {
  const bool transparent = facts.options.transparent;
  depth::DepthPlan plan;
  if (facts.measurable) {
    plan.adaptive = plan.measured = plan.budget.counted = true;
    plan.measure = edge_measure(facts.options, facts.ark);
    plan.deepest = transparent ? facts.options.max_level : static_cast<unsigned>(std::max(facts.ark.pool_level, 0));
    return plan;
  }
  if (takes_tags(facts)) {
    return depths_by_tags(facts);
  }
  plan.level = transparent ? facts.options.level : facts.ark.uniform_level;
  return plan;
}

}  // namespace

EdgeMeasure edge_measure(const ContextOptions& options, const ArkState& ark) {
  if (options.transparent) {
    return options.measure;
  }
  return ark.depth_source == DepthSource::measured ? ark.measure : EdgeMeasure{};
}

// If there is a geometry shader, the vertex stage may not know where its vertices are on the screen.
bool measures_screen(const EdgeMeasure& wanted, const Program& program, const PipelineObject* pipeline) {
  const bool has_geometry = pipeline != nullptr ? pipeline->geometry() != 0 : program.has_stage(GL_GEOMETRY_SHADER);
  return (wanted.pixels > 0 || wanted.error > 0) && !has_geometry;
}

bool can_measure(const EdgeMeasure& wanted, const Program& program, const PipelineObject* pipeline, bool subroutines) {
  // The program of the corners would have to choose the same subroutines.
  return !subroutines && (measures_screen(wanted, program, pipeline) ||
                          (wanted.degrees > 0 && capture::normal_offset(program.fields) >= 0));
}

bool has_cubic_edges(const Program& program, const DerivedProgram& derived) {
  if (traits_of(derived.refinement).interpolates_outputs) {
    return true;
  }
  const refine::OutputVariation* const position = program.traits.variation.position();
  return program.refinement_source.empty() && derived.height_map < 0 &&
         (position == nullptr || position->variation <= refine::Variation::affine);
}

bool takes_tags(const DepthFacts& facts) {
  return !facts.measurable && !facts.options.transparent && facts.ark.depth_source == DepthSource::tag;
}

depth::DepthPlan choose_depths(const DepthFacts& facts) {
  depth::DepthPlan plan = wanted_depths(facts);
  plan.coarse = facts.coarse;
  if (plan.coarse) {
    plan.level = plan.deepest = 0;
  }
  plan.morphing = plan.adaptive && geomorphs(facts.options, facts.ark);
  plan.interior = plan.morphing               ? pattern::Interior::morphing
                  : facts.ark.smooth_interior ? pattern::Interior::smooth
                                              : pattern::Interior::minimum;
  return plan;
}

}  // namespace glark::core
