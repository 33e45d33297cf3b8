// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/refinement_choice.h"

#include <gtest/gtest.h>

namespace glark::core {
namespace {

class RefinementChoices : public testing::Test {
 protected:
  RefinementChoice choice(Refinement wanted) const { return choose_refinement({wanted, transparent, stage, inputs}); }
  void expect(Refinement wanted, Refinement refinement, std::optional<RefinementFallback> fallback) const {
    EXPECT_EQ(choice(wanted).refinement, refinement);
    EXPECT_EQ(choice(wanted).fallback, fallback);
  }

  bool transparent = true;
  refine::VertexStageTraits stage;
  refine::VertexInputTraits inputs{.can_curve = true, .has_integers = false};
};

TEST_F(RefinementChoices, TheUserChoosesInTransparentRefinementElseTheApplication) {
  ContextOptions options;
  ArkState ark;
  options.refinement = Refinement::pn;
  ark.refinement = Refinement::phong;
  EXPECT_EQ(wanted_refinement(options, ark), Refinement::phong);
  options.transparent = true;
  EXPECT_EQ(wanted_refinement(options, ark), Refinement::pn);
}

TEST_F(RefinementChoices, APlainStageGetsEveryRefinement) {
  for (const RefinementTraits& row : refinements) {
    expect(row.refinement, row.refinement, std::nullopt);
  }
}

TEST_F(RefinementChoices, AVertexNumberNeedsOutputs) {
  stage.reads_vertex_id = true;
  expect(Refinement::linear_inputs, Refinement::linear_outputs, RefinementFallback::vertex_id);
  expect(Refinement::linear_outputs, Refinement::linear_outputs, std::nullopt);
  transparent = false;
  expect(Refinement::pn, Refinement::linear_outputs, RefinementFallback::vertex_id);
}

TEST_F(RefinementChoices, ACullDistanceNeedsOutputs) {
  stage.writes_cull_distance = true;
  expect(Refinement::phong, Refinement::linear_outputs, RefinementFallback::cull_distance);
}

TEST_F(RefinementChoices, IntegersNeedOutputsUnlessTheProgramUsesTheExtension) {
  inputs.has_integers = true;
  expect(Refinement::linear_inputs, Refinement::linear_outputs, RefinementFallback::integer_input);
  transparent = false;
  expect(Refinement::linear_inputs, Refinement::linear_inputs, std::nullopt);
}

TEST_F(RefinementChoices, ACurveNeedsANormal) {
  inputs.can_curve = false;
  for (const Refinement curved : {Refinement::pn, Refinement::scalar_tagged_pn, Refinement::phong}) {
    expect(curved, Refinement::linear_inputs, RefinementFallback::no_normal);
  }
  expect(Refinement::linear_inputs, Refinement::linear_inputs, std::nullopt);
}

TEST_F(RefinementChoices, EveryFallbackHasATextWithARemedy) {
  for (unsigned i = 0; i < refinement_fallback_count; ++i) {
    const FallbackText& text = text_of(static_cast<RefinementFallback>(i));
    EXPECT_FALSE(text.key.empty() || text.explanation.empty() || text.remedy.empty()) << i;
  }
}

}  // namespace
}  // namespace glark::core
