// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The samples near a point.
#include "glark/clients/reconstruct/samples/near_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "glark/clients/reconstruct/samples/local_surface.h"
#include "tests/vstree/shapes.h"

namespace glark::reconstruct::test {

using namespace vstree;
using namespace vstree::test;
namespace {

class Near : public testing::Test {
 protected:
  float number() { return static_cast<float>(random_() % 65536) / 65536; }
  Float4 point() { return Float4{number(), number(), number(), 0}; }

  const Shape shape_ = sphere(20000);
  const Octree octree_ = octree_of(shape_.points(), sort_by_cells(shape_.points(), Workers(1)), {}, Workers(1));

 private:
  std::mt19937 random_{5};
};

std::size_t count_within(const NearSamples& samples, Float4 low, Float4 high) {
  std::size_t count = 0;
  for (const FourSamples& four : samples.all()) {
    for (int lane = 0; lane < 4; ++lane) {
      bool inside = true;
      for (int k = 0; k < 3; ++k) inside &= four.position[k][lane] >= low[k] && four.position[k][lane] <= high[k];
      count += inside ? 1 : 0;
    }
  }
  return count;
}

TEST_F(Near, SamplesOfABoxAreAllThereAndNoMore) {
  NearSamples samples;
  std::size_t all = 0;
  for (int i = 0; i < 2000; ++i) {
    const Float4 middle = point(), half = point() * (i % 10 == 0 ? 0.5F : 0.05F);
    const Float4 low = middle - half, high = middle + half;
    std::size_t expected = 0;
    for (const Record& record : octree_.records) {
      bool inside = true;
      for (int k = 0; k < 3; ++k) inside &= record.position[k] >= low[k] && record.position[k] <= high[k];
      expected += inside ? 1 : 0;
    }
    samples.gather(octree_, low, high);
    ASSERT_EQ(count_within(samples, low, high), expected);
    ASSERT_EQ(samples.all().size(), (expected + 3) / 4);
    all += expected;
  }
  EXPECT_GT(all, 100000U);
}

TEST_F(Near, EachCellOfABoxComesOnce) {
  for (const Level& level : octree_.levels) {
    const std::int32_t last = (1 << level.level) - 1;
    std::vector<std::uint32_t> seen(octree_.records.size());
    level.blocks.each({{0, 0, 0}, {last, last, last}}, [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = begin; i < end; ++i) ++seen[i];
    });
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1U), static_cast<std::ptrdiff_t>(seen.size()));
    for (std::size_t i = 0; i < level.keys.size(); i += 7) {
      const CellIndex cell = cell_of_key(level.keys[i]);
      std::uint32_t from = 0, to = 0;
      level.blocks.each({cell, cell}, [&](std::uint32_t begin, std::uint32_t end) {
        from = begin;
        to = end;
      });
      EXPECT_EQ(from, level.begins[i]);
      EXPECT_EQ(to, level.begins[i + 1]);
    }
  }
}

TEST_F(Near, WhatWasLookedAtChangesNoEstimate) {
  const float side = octree_.finest().side();
  LocalSurface one(octree_), other(octree_);
  const Float4 around = Float4{1, 1, 1, 0} * side;
  for (const Record& record : octree_.records) {
    const Float4 place = record.position + record.normal * (0.1F * side);
    const LocalEstimate alone = one.near(place, record.normal, 0.5F * side);
    other.look_around(place - around, place + around * (number() < 0.5F ? 1.0F : 0.3F));
    const LocalEstimate estimate = other.near(place, record.normal, 0.5F * side);
    ASSERT_EQ(estimate.found, alone.found);
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(estimate.point[k], alone.point[k], 1e-4F * side);
  }
}

}  // namespace
}  // namespace glark::reconstruct::test
