// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <random>

#include <glark/depth.h>

#include "glark/core/pattern/expand.h"
#include "glark/core/pattern/pool.h"
#include "tests/depth/meshes.h"

namespace glark::depth {
namespace {

std::uint64_t drawn(int e0, int e1, int e2, pattern::Interior interior) {
  static const pattern::Pool pools[] = {pattern::build_pool(8), pattern::build_pool(8, true)};
  const pattern::Pool& pool = pools[interior == pattern::Interior::morphing ? 1 : 0];
  std::uint64_t sum = 0;
  for (const pattern::Instance& instance : pattern::expand(e0, e1, e2, interior)) {
    sum += pool.pieces[static_cast<std::size_t>(instance.piece)].index_count / 3;
  }
  return sum;
}

constexpr std::uint32_t triangle[] = {0, 1, 2};

TEST(Budget, CountsWhatThePatternsHave) {
  const Tagger tagger(3, triangle, 8);
  for (int a = 0; a <= 8; ++a) {
    for (int b = 0; b <= 8; ++b) {
      for (int c = 0; c <= 8; ++c) {
        const float tags[] = {static_cast<float>(a), static_cast<float>(b), static_cast<float>(c)};
        EXPECT_EQ(tagger.refined_triangles(tags),
                  drawn((a + b) >> 1, (b + c) >> 1, (c + a) >> 1, pattern::Interior::minimum))
            << a << b << c;
        EXPECT_EQ(tagger.refined_triangles(tags, EdgeRule::geomorph),
                  drawn((a + b + 1) >> 1, (b + c + 1) >> 1, (c + a + 1) >> 1, pattern::Interior::morphing))
            << a << b << c;
      }
    }
  }
}

TEST(Budget, TagsAreRoundedAsTheExtensionDoes) {
  const Tagger tagger(3, triangle, 8);
  const float below[] = {2.49F, 2.49F, 2.49F};
  const float above[] = {2.5F, 2.5F, 2.5F};
  EXPECT_EQ(tagger.refined_triangles(below), 16U);
  EXPECT_EQ(tagger.refined_triangles(above), 64U);
  EXPECT_EQ(tagger.refined_triangles(below, EdgeRule::geomorph), 64U);
}

TEST(Budget, TakesAsLittleAsKeepsIt) {
  const testing::Mesh mesh = testing::make_torus(3, 1, 16);
  const Tagger tagger(mesh.vertices(), mesh.triangles, 8);
  std::mt19937 random(1);
  std::vector<float> tags(mesh.vertices());
  for (const EdgeRule rule : {EdgeRule::rounded, EdgeRule::geomorph}) {
    for (const std::uint64_t most : {1000ULL, 20000ULL, 1000000ULL}) {
      for (float& tag : tags) tag = static_cast<float>(random() % 800) / 100;
      std::vector<float> kept = tags;
      const Budget budget = tagger.keep_budget(most, kept, rule);
      EXPECT_TRUE(budget.kept);
      EXPECT_EQ(budget.triangles, tagger.refined_triangles(kept, rule));
      EXPECT_LE(budget.triangles, most);
      if (budget.bias > 0) {
        for (std::size_t i = 0; i < tags.size(); ++i) kept[i] = std::max(tags[i] - budget.bias + 1.0F / 256, 0.0F);
        EXPECT_GT(tagger.refined_triangles(kept, rule), most);
      }
    }
  }
}

TEST(Budget, LeavesTagsThatKeepIt) {
  const Tagger tagger(3, triangle, 8);
  std::vector<float> tags = {3, 3, 3};
  const Budget budget = tagger.keep_budget(64, tags);
  EXPECT_EQ(budget.bias, 0.0F);
  EXPECT_EQ(budget.triangles, 64U);
  EXPECT_EQ(tags, (std::vector<float>{3, 3, 3}));
}

TEST(Budget, BelowTheCoarseMeshIsNotKept) {
  const testing::Mesh mesh = testing::make_torus(3, 1, 4);
  const Tagger tagger(mesh.vertices(), mesh.triangles, 8);
  std::vector<float> tags(mesh.vertices(), 8.0F);
  const Budget budget = tagger.keep_budget(31, tags);
  EXPECT_FALSE(budget.kept);
  EXPECT_EQ(budget.triangles, 32U);
  for (float tag : tags) EXPECT_EQ(tag, 0.0F);
}

}  // namespace
}  // namespace glark::depth
