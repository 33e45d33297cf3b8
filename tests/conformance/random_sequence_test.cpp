// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/random/sequence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "conformance/changes/shortest.h"

namespace glark::conformance {
namespace {

struct Place {
  WorldKind kind;
  Offer offer;
};

const std::vector<Place> places = {
    {WorldKind::stage, {Api::gl_compat, 45}},    {WorldKind::stage, {Api::gl_core, 45}},
    {WorldKind::stage, {Api::gles, 32}},         {WorldKind::curved, {Api::gl_compat, 45}},
    {WorldKind::uniforms, {Api::gl_compat, 45}}, {WorldKind::uniforms, {Api::gles, 32}},
    {WorldKind::fixed, {Api::gl_compat, 45}},    {WorldKind::polygons, {Api::gl_compat, 45}},
};

// The pairs of a row and a path that is drawn later in the same sequence.
std::set<std::pair<const Row*, const RandomPath*>> pairs_of(const std::vector<RandomSequence>& sequences) {
  std::set<std::pair<const Row*, const RandomPath*>> pairs;
  for (const RandomSequence& sequence : sequences)
    for (std::size_t i = 0; i < sequence.steps.size(); ++i)
      for (std::size_t k = i + 1; sequence.steps[i].row != nullptr && k < sequence.steps.size(); ++k)
        if (sequence.steps[k].path != nullptr) pairs.emplace(sequence.steps[i].row, sequence.steps[k].path);
  return pairs;
}

TEST(RandomSequence, EachRowComesBeforeEachPath) {
  for (const auto& [kind, offer] : places) {
    if (kind == WorldKind::curved) continue;  // its rows and paths are those of the stage
    const auto pairs = pairs_of(random_sequences(1, kind, offer));
    for (const Row* row : rows_of(kind, offer))
      for (const RandomPath* path : paths_of(kind, offer))
        EXPECT_TRUE(pairs.contains({row, path})) << static_cast<int>(kind) << ": " << row->name << ", " << path->name;
  }
}

TEST(RandomSequence, EachRowAndEachPathIsInSomeWorld) {
  std::set<const Row*> rows;
  std::set<const RandomPath*> paths;
  for (const auto& [kind, offer] : places) {
    const auto some_rows = rows_of(kind, offer);
    const auto some_paths = paths_of(kind, offer);
    rows.insert(some_rows.begin(), some_rows.end());
    paths.insert(some_paths.begin(), some_paths.end());
  }
  EXPECT_EQ(rows.size(), all_rows().size());
  EXPECT_EQ(paths.size(), all_random_paths().size());
}

TEST(RandomSequence, NoTwoRowsHaveOneName) {
  std::set<std::string> names;
  for (const Row& row : all_rows()) EXPECT_TRUE(names.insert(row.name).second) << row.name;
}

// Table 11.R of the specification, and the state of depth tags.
TEST(RandomSequence, EachParameterOfTheExtensionHasARow) {
  for (const char* name : {"ARKinit",
                           "REFINEMENT_ARK",
                           "DEPTH_SOURCE_ARK",
                           "UNIFORM_DEPTH_LEVEL_ARK",
                           "DEPTH_TAG_ATTRIBUTE_ARK",
                           "POLYGON_SPLIT_ARK",
                           "PATTERN_INTERIOR_ARK",
                           "EDGE_PIXELS_ARK",
                           "EDGE_DEGREES_ARK",
                           "SCREEN_ERROR_ARK",
                           "TRIANGLE_BUDGET_ARK",
                           "DISCONTINUITY_ATTRIBUTE_ARK",
                           "SCALAR_TAG_ATTRIBUTE_ARK",
                           "DISPLACEMENT_UNIT_ARK",
                           "DISPLACEMENT_CHANNEL_ARK",
                           "DISPLACEMENT_COORDINATE_ARK",
                           "DISPLACEMENT_SCALE_ARK",
                           "DISPLACEMENT_BIAS_ARK",
                           "GEOMORPH_ARK",
                           "WELD_ARK",
                           "PHONG_SHAPE_ARK",
                           "DepthTag1i",
                           "DepthTagPointerARK",
                           "DEPTH_TAG_ARRAY_ARK"})
    EXPECT_TRUE(std::any_of(all_rows().begin(), all_rows().end(), [name](const Row& row) {
      return std::string_view(row.name) == name;
    })) << name;
}

TEST(RandomSequence, SeedsGiveOtherSequences) {
  const Offer offer{Api::gl_compat, 45};
  const auto first = random_sequences(1, WorldKind::fixed, offer);
  EXPECT_EQ(text_of(first[0]), text_of(random_sequences(1, WorldKind::fixed, offer)[0]));
  EXPECT_NE(text_of(first[0]), text_of(random_sequences(2, WorldKind::fixed, offer)[0]));
}

TEST(RandomSequence, TextNamesRowsAndDraws) {
  const Row row{"UseProgram", "programs", Where::stage, nullptr};
  const RandomPath path{"DrawArrays", Where::stage, nullptr};
  EXPECT_EQ(text_of(RandomSequence{WorldKind::stage, {{&row, nullptr, 1, 1}, {nullptr, &path, 2, 3}}}),
            "UseProgram\ndraw: DrawArrays, 3 times");
}

TEST(RandomSequence, ShortestKeepsTheSeedsOfTheStepsThatRemain) {
  RandomSequence sequence;
  for (std::uint32_t i = 0; i < 40; ++i) sequence.steps.push_back({nullptr, nullptr, i, 1});
  const auto has = [](const RandomSequence& tried, std::uint32_t seed) {
    return std::any_of(tried.steps.begin(), tried.steps.end(),
                       [seed](const RandomStep& step) { return step.seed == seed; });
  };
  const auto fails = [&](const RandomSequence& tried) { return has(tried, 7) && has(tried, 31); };
  const RandomSequence best = shortest<RandomSequence>(sequence, fails, 200);
  ASSERT_EQ(best.steps.size(), 2U);
  EXPECT_EQ(best.steps[0].seed, 7U);
  EXPECT_EQ(best.steps[1].seed, 31U);
}

TEST(Values, NormalizedOnesReachBothEnds) {
  Values values(1);
  std::set<int> seen;
  for (int i = 0; i < 400; ++i) seen.insert(values.normalized<std::int8_t>());
  EXPECT_TRUE(seen.contains(-128));
  EXPECT_TRUE(seen.contains(127));
}

TEST(Values, NumbersAreUsualAndUnusual) {
  Values values(1);
  std::set<float> seen;
  for (int i = 0; i < 400; ++i) seen.insert(values.number());
  for (const float wanted : {0.0F, 1.0F, -1.0F, 2.0F, 3.0F, 0.001F}) EXPECT_TRUE(seen.contains(wanted)) << wanted;
}

}  // namespace
}  // namespace glark::conformance
