// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/refinement_choice.h"

#include <gtest/gtest.h>

namespace glark::core {
namespace {

class RefinementChoices : public testing::Test {
 protected:
  RefinementChoice choice(Refinement wanted) const {
    return choose_refinement({wanted, transparent, stage, stage.variation, inputs, false});
  }
  void expect(Refinement wanted, Refinement refinement, std::optional<RefinementFallback> fallback) const {
    EXPECT_EQ(choice(wanted).refinement, refinement);
    EXPECT_EQ(choice(wanted).fallback, fallback);
  }

  bool transparent = true;
  refine::VertexStageTraits stage;
  void vary(refine::Variation variation) { stage.variation.outputs = {{"gl_Position", variation, {}}}; }

  refine::VertexInputTraits inputs{.can_curve = true};
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

TEST_F(RefinementChoices, SmoothDoesNotOverruleAnApplicationThatAsksItself) {
  ContextOptions options{.transparent = true, .refinement = Refinement::pn, .smooth = true};
  ArkState ark;
  ark.refinement = Refinement::linear_inputs;
  EXPECT_EQ(wanted_refinement(options, ark), Refinement::pn);
  ark.enabled = true;
  EXPECT_EQ(wanted_refinement(options, ark), Refinement::linear_inputs);
  options.smooth = false;
  EXPECT_EQ(wanted_refinement(options, ark), Refinement::pn);
}

TEST_F(RefinementChoices, APlainStageGetsEveryRefinement) {
  for (const RefinementTraits& row : refinements) {
    expect(row.refinement, row.refinement, std::nullopt);
  }
}

TEST_F(RefinementChoices, NothingIsCurvedThatIsShadedFlat) {
  RefinementFacts facts{
      .wanted = Refinement::pn, .transparent = true, .stage = stage, .variation = stage.variation, .inputs = inputs};
  EXPECT_FALSE(choose_refinement(facts).fallback);
  facts.flat_shaded = true;
  EXPECT_EQ(choose_refinement(facts).fallback, RefinementFallback::flat_shading);
  EXPECT_EQ(choose_refinement(facts).refinement, Refinement::linear_inputs);
  facts.wanted = Refinement::linear_inputs;
  EXPECT_FALSE(choose_refinement(facts).fallback);
}

TEST_F(RefinementChoices, AVertexNumberNeedsOutputsIfTheProgramUsesTheExtension) {
  stage.reads_vertex_id = true;
  expect(Refinement::linear_inputs, Refinement::linear_inputs, std::nullopt);  // it does not reach the position
  transparent = false;
  expect(Refinement::linear_inputs, Refinement::linear_outputs, RefinementFallback::vertex_id);
  expect(Refinement::linear_outputs, Refinement::linear_outputs, std::nullopt);
  expect(Refinement::pn, Refinement::linear_outputs, RefinementFallback::vertex_id);
}

TEST_F(RefinementChoices, ACullDistanceNeedsOutputs) {
  stage.writes_cull_distance = true;
  expect(Refinement::phong, Refinement::linear_outputs, RefinementFallback::cull_distance);
}

TEST_F(RefinementChoices, AnUnsoundPositionNeedsOutputsUnlessTheProgramUsesTheExtension) {
  for (const refine::Variation variation : {refine::Variation::switched, refine::Variation::undefined}) {
    vary(variation);
    transparent = true;
    expect(Refinement::linear_inputs, Refinement::linear_outputs, RefinementFallback::unsound_stage);
    expect(Refinement::pn, Refinement::linear_outputs, RefinementFallback::unsound_stage);
    transparent = false;
    expect(Refinement::pn, Refinement::pn, std::nullopt);
  }
}

TEST_F(RefinementChoices, ABentPositionNeedsANormal) {
  vary(refine::Variation::continuous);
  expect(Refinement::linear_inputs, Refinement::linear_inputs, std::nullopt);
  expect(Refinement::phong, Refinement::phong, std::nullopt);
  inputs.can_curve = false;
  expect(Refinement::linear_inputs, Refinement::linear_outputs, RefinementFallback::bent_unknowing);
  expect(Refinement::phong, Refinement::linear_outputs, RefinementFallback::bent_unknowing);
  vary(refine::Variation::affine);
  expect(Refinement::linear_inputs, Refinement::linear_inputs, std::nullopt);
}

// It tells no surface from an impostor.
TEST_F(RefinementChoices, ANormalFromPositionsDoesNotMakeABentPositionSound) {
  vary(refine::Variation::continuous);
  const RefinementFacts facts{.wanted = Refinement::pn,
                              .transparent = true,
                              .stage = stage,
                              .variation = stage.variation,
                              .inputs = inputs,
                              .made_normal = true};
  EXPECT_EQ(choose_refinement(facts).fallback, RefinementFallback::bent_unknowing);
  vary(refine::Variation::affine);
  EXPECT_FALSE(choose_refinement(facts).fallback);
}

TEST_F(RefinementChoices, OtherOutputsDoNotDecide) {
  stage.variation.outputs = {{"uv", refine::Variation::undefined, {}}, {"gl_Position", refine::Variation::affine, {}}};
  expect(Refinement::pn, Refinement::pn, std::nullopt);
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
