// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/vertex_keeping.h"

#include <gtest/gtest.h>

namespace glark::core {
namespace {

class VertexKeeping : public testing::Test {
 protected:
  VertexKeeping() {
    plan.program = &program;
    plan.derived = std::make_shared<DerivedProgram>();
    plan.depth.level = 2;
  }
  bool keeps(bool captures = false) const { return keeps_vertices(plan, options, captures); }

  Program program;
  DrawPlan plan;
  ContextOptions options;
};

TEST_F(VertexKeeping, KeepsAUniformLevelOfInputs) {
  for (const RefinementTraits& row : refinements) {
    plan.derived->refinement = row.refinement;
    EXPECT_EQ(keeps(), !row.interpolates_outputs) << row.word;
  }
}

TEST_F(VertexKeeping, NeedsALevel) {
  plan.depth.level = 0;
  EXPECT_FALSE(keeps());
}

TEST_F(VertexKeeping, KeepsTilesOfADeepLevel) {
  plan.depth.level = 9;
  plan.placed = true;
  EXPECT_TRUE(keeps());
}

TEST_F(VertexKeeping, KeepsDepthsThatDoNotChange) {
  plan.depth.level = 0;
  plan.depth.adaptive = plan.placed = true;
  EXPECT_TRUE(keeps());
  plan.depth.measured = true;
  EXPECT_TRUE(keeps()) << "while the view stays";
  plan.depth.measure.budget = 1000;
  EXPECT_FALSE(keeps()) << "the depths depend on other draws";
  plan.depth.measured = false;
  plan.depth.coarse = true;
  EXPECT_FALSE(keeps());
}

// Vertices that move between levels have mixed outputs.
TEST_F(VertexKeeping, NeedsVerticesThatDoNotMove) {
  plan.depth.adaptive = plan.depth.morphing = true;
  EXPECT_FALSE(keeps());
}

TEST_F(VertexKeeping, NeedsWholeTriangles) {
  plan.polygons.emplace();
  EXPECT_FALSE(keeps());
}

// Whether something behind them changes unseen is known later.
TEST_F(VertexKeeping, KeepsDisplacementAndRefinementShaders) {
  program.refinement_source = "void refine() {}";
  plan.derived->height_map = 3;
  EXPECT_TRUE(keeps());
}

TEST_F(VertexKeeping, NeedsTheOutputsOfTheOwnProgram) {
  plan.derived->corner_outputs = true;
  EXPECT_FALSE(keeps());
  plan.derived->corner_outputs = false;
  program.counts_primitives = true;
  EXPECT_FALSE(keeps());
  program.counts_primitives = false;
  EXPECT_FALSE(keeps(true));
  EXPECT_TRUE(keeps());
}

TEST_F(VertexKeeping, CanBeSwitchedOff) {
  options.kept_vertex_bytes = 0;
  EXPECT_FALSE(keeps());
}

}  // namespace
}  // namespace glark::core
