// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/seams/seams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <random>
#include <vector>

namespace glark::maps::test {
namespace {

using Point = std::array<float, 2>;
using ChannelFunction = std::function<float(Point, unsigned)>;

constexpr float one_step_of_8_bits = 1.0F / 255;

// A chart that turns and scales the plane: texels = centre of the raster + turned plane * density.
struct TurnedChart {
  unsigned width, height, channels;
  float angle, density;
  std::vector<float> values;

  TurnedChart(unsigned size, unsigned channel_count, float degrees, float texels, const ChannelFunction& value)
      : width(size), height(size + 3), channels(channel_count), angle(degrees * 3.14159265F / 180), density(texels) {
    for (unsigned y = 0; y < height; ++y)
      for (unsigned x = 0; x < width; ++x)
        for (unsigned c = 0; c < channels; ++c)
          values.push_back(value(in_plane({static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F}), c));
  }
  Point middle() const { return {static_cast<float>(width) / 2, static_cast<float>(height) / 2}; }
  Point in_plane(Point texel) const {
    const float x = (texel[0] - middle()[0]) / density, y = (texel[1] - middle()[1]) / density;
    return {x * std::cos(angle) + y * std::sin(angle), y * std::cos(angle) - x * std::sin(angle)};
  }
  Point in_texels(Point p) const {
    const float x = p[0] * std::cos(angle) - p[1] * std::sin(angle),
                y = p[0] * std::sin(angle) + p[1] * std::cos(angle);
    return {x * density + middle()[0], y * density + middle()[1]};
  }
};

float smooth_function(Point p, unsigned channel) {
  return 0.5F + 0.4F * std::sin(0.3F * p[0] + static_cast<float>(channel)) * std::cos(0.25F * p[1]);
}

std::vector<ChartImage> images(std::vector<TurnedChart>& charts) {
  std::vector<ChartImage> all;
  for (TurnedChart& chart : charts) all.push_back({chart.width, chart.height, chart.values});
  return all;
}

SeamSide side_of(const std::vector<TurnedChart>& charts, std::uint32_t chart, Point from, Point to) {
  return {chart, charts[chart].in_texels(from), charts[chart].in_texels(to)};
}

Seam seam_of(const std::vector<TurnedChart>& charts, std::uint32_t a, std::uint32_t b, Point from, Point to) {
  return {side_of(charts, a, from, to), side_of(charts, b, from, to)};
}

// What is left of the differences.
SeamDifferences equalised(const std::vector<ChartImage>& charts, unsigned channels, const std::vector<Seam>& seams,
                          const SeamOptions& options = {}) {
  equalise(charts, channels, seams, options);
  return seam_jumps(charts, channels, seams);
}

float greatest(const std::vector<float>& values) { return *std::max_element(values.begin(), values.end()); }

// Adds random numbers of -most to most to all texels.
void add_noise(TurnedChart& chart, float most, unsigned seed) {
  std::mt19937 random(seed);
  for (float& value : chart.values) value += most * (static_cast<float>(random() % 2001) / 1000 - 1);
}

TEST(SeamDifferences, AreTheDifferencesOfBilinearSamples) {
  std::vector<float> a{0, 1, 2, 3}, b{5, 5, 5, 5};
  const std::vector<ChartImage> charts{{2, 2, a}, {2, 2, b}};
  // From the centre of the first texel to the centre of the third: 0 to 2 against 5.
  const std::vector<Seam> seams{{{0, {0.5F, 0.5F}, {0.5F, 1.5F}}, {1, {0.5F, 0.5F}, {0.5F, 1.5F}}}};
  const SeamDifferences jumps = seam_jumps(charts, 1, seams);
  EXPECT_FLOAT_EQ(jumps.greatest[0], 5);
  // The mean of (5 - 2 t)^2 at t = 0, 1/8 .. 1 is (225 - 90 + 4 * 204 / 64) / 9.
  EXPECT_FLOAT_EQ(jumps.root_mean_square[0], std::sqrt((225 - 90 + 12.75F) / 9));
}

TEST(SeamDifferences, SamplesOutsideHaveTheValuesOfTheBorder) {
  std::vector<float> a{0, 1, 2, 3}, b{0};
  const std::vector<ChartImage> charts{{2, 2, a}, {1, 1, b}};
  const std::vector<Seam> seams{{{0, {9, 9}, {9, 9}}, {1, {-5, 0}, {7, 1}}}};
  EXPECT_FLOAT_EQ(seam_jumps(charts, 1, seams).greatest[0], 3);
}

TEST(Equalise, TwoTexelsMeetInTheMiddle) {
  std::vector<float> a{0}, b{1};
  const std::vector<ChartImage> charts{{1, 1, a}, {1, 1, b}};
  const std::vector<Seam> seams{{{0, {0, 0.5F}, {1, 0.5F}}, {1, {0, 0.5F}, {1, 0.5F}}}};
  const SeamDifferences left = equalised(charts, 1, seams, {.fidelity = 1e-6F});
  EXPECT_NEAR(a[0], 0.5F, 1e-4F);
  EXPECT_NEAR(b[0], 0.5F, 1e-4F);
  EXPECT_NEAR(left.greatest[0], std::abs(a[0] - b[0]), 1e-6F);
}

TEST(Equalise, RotatedGridsOfSmoothDataAgreeToEightBits) {
  std::vector<TurnedChart> charts{{60, 3, 0, 1, smooth_function}, {90, 3, 30, 1.4F, smooth_function}};
  add_noise(charts[0], 0.01F, 1);
  const std::vector<Seam> seams{seam_of(charts, 0, 1, {-25, -3}, {25, 4})};
  const std::vector<ChartImage> all = images(charts);
  ASSERT_GT(greatest(seam_jumps(all, 3, seams).greatest), 2 * one_step_of_8_bits);
  const SeamDifferences left = equalised(all, 3, seams);
  EXPECT_LE(greatest(left.greatest), one_step_of_8_bits);
  EXPECT_EQ(left.greatest, seam_jumps(all, 3, seams).greatest);
}

// Offsets of charts, as different exposures of photographs give, vanish along the seam.
TEST(Equalise, OffsetOfAChartVanishesAlongTheSeam) {
  std::vector<TurnedChart> charts{{60, 2, 0, 1, smooth_function}, {70, 2, 30, 1.3F, smooth_function}};
  for (float& value : charts[1].values) value += 0.2F;
  const std::vector<Seam> seams{seam_of(charts, 0, 1, {-20, 3}, {20, 3})};
  const SeamDifferences left = equalised(images(charts), 2, seams);
  EXPECT_LE(greatest(left.greatest), one_step_of_8_bits);
}

TEST(Equalise, OnlyTexelsNextToTheSeamChange) {
  std::vector<TurnedChart> charts{{40, 1, 0, 1, smooth_function}, {40, 1, 30, 1, smooth_function}};
  add_noise(charts[1], 0.3F, 3);
  const std::vector<TurnedChart> before = charts;
  const Point from{-10, -2}, to{10, 3};
  equalise(images(charts), 1, std::vector<Seam>{seam_of(charts, 0, 1, from, to)});
  std::size_t changed = 0;
  for (unsigned k = 0; k < 2; ++k) {
    for (std::size_t i = 0; i < charts[k].values.size(); ++i) {
      if (charts[k].values[i] == before[k].values[i]) continue;
      ++changed;
      const TurnedChart& chart = charts[k];
      const std::size_t row = i / chart.width;
      const Point p = chart.in_plane({static_cast<float>(i % chart.width) + 0.5F, static_cast<float>(row) + 0.5F});
      const float t = ((p[0] + 10) * 20 + (p[1] + 2) * 5) / 425, s = std::clamp(t, 0.0F, 1.0F);
      EXPECT_LT(std::hypot(p[0] + 10 - 20 * s, p[1] + 2 - 5 * s), 1.4143F);
    }
  }
  EXPECT_GT(changed, 80U);
}

TEST(Equalise, EqualSidesStayAsTheyAre) {
  std::vector<TurnedChart> charts{{30, 2, 20, 1, smooth_function}, {30, 2, 20, 1, smooth_function}};
  const std::vector<TurnedChart> before = charts;
  const SeamDifferences left = equalised(images(charts), 2, std::vector<Seam>{seam_of(charts, 0, 1, {-9, 1}, {9, 2})});
  EXPECT_EQ(left.greatest, std::vector<float>(2, 0.0F));
  for (unsigned k = 0; k < 2; ++k) EXPECT_EQ(charts[k].values, before[k].values);
}

TEST(Equalise, ChartMayHaveASeamWithItself) {
  // A cylinder: the left and the right side of one chart are the same edge.
  std::vector<TurnedChart> charts{{33, 1, 0, 1, smooth_function}};
  const auto height = static_cast<float>(charts[0].height);
  const std::vector<Seam> seams{{{0, {1, 1}, {1, height - 1}}, {0, {32, 1}, {32, height - 1}}}};
  const std::vector<ChartImage> all = images(charts);
  ASSERT_GT(greatest(seam_jumps(all, 1, seams).greatest), 0.1F);
  EXPECT_LE(greatest(equalised(all, 1, seams).greatest), one_step_of_8_bits);
}

TEST(Equalise, SideThatIsItsOwnOtherSideChangesNothing) {
  std::vector<TurnedChart> charts{{20, 1, 0, 1, smooth_function}};
  const std::vector<TurnedChart> before = charts;
  const std::vector<Seam> seams{{{0, {3, 3}, {15, 9}}, {0, {3, 3}, {15, 9}}}};
  EXPECT_EQ(greatest(equalised(images(charts), 1, seams).greatest), 0);
  EXPECT_EQ(charts[0].values, before[0].values);
}

TEST(Equalise, ThreeChartsMeetAtAVertex) {
  std::vector<TurnedChart> charts{
      {50, 1, 0, 1, smooth_function}, {60, 1, 30, 1.2F, smooth_function}, {70, 1, 77, 1.5F, smooth_function}};
  for (float& value : charts[1].values) value += 0.1F;
  for (float& value : charts[2].values) value -= 0.1F;
  const std::vector<Seam> seams{seam_of(charts, 0, 1, {0, 0}, {15, 2}), seam_of(charts, 1, 2, {0, 0}, {-8, 12}),
                                seam_of(charts, 2, 0, {0, 0}, {-7, -13})};
  const std::vector<ChartImage> all = images(charts);
  EXPECT_LE(greatest(equalised(all, 1, seams).greatest), one_step_of_8_bits);
  // All three have the same value at the vertex.
  const std::vector<Seam> vertex{seam_of(charts, 0, 1, {0, 0}, {0, 0}), seam_of(charts, 0, 2, {0, 0}, {0, 0})};
  EXPECT_LE(greatest(seam_jumps(all, 1, vertex).greatest), one_step_of_8_bits);
}

TEST(Equalise, SeamOfLengthZeroIsOneSample) {
  std::vector<TurnedChart> charts{{9, 1, 0, 1, smooth_function}, {9, 1, 30, 1, smooth_function}};
  for (float& value : charts[1].values) value += 0.5F;
  const std::vector<Seam> seams{seam_of(charts, 0, 1, {1, 1}, {1, 1})};
  EXPECT_LE(greatest(equalised(images(charts), 1, seams, {.fidelity = 1e-4F}).greatest), one_step_of_8_bits);
}

TEST(Equalise, SeamMayTouchTheBorderOfTheRaster) {
  std::vector<TurnedChart> charts{{20, 2, 0, 1, smooth_function}, {20, 2, 0, 1.5F, smooth_function}};
  for (float& value : charts[0].values) value += 0.3F;
  const std::vector<Seam> seams{{{0, {0, 0}, {20, 0}}, {1, {0, 23}, {20, 23}}},
                                {{0, {20, 0}, {20, 23}}, {1, {0, 0}, {0, 23}}}};
  EXPECT_LE(greatest(equalised(images(charts), 2, seams).greatest), one_step_of_8_bits);
}

TEST(Equalise, WithoutSeamsNothingChanges) {
  std::vector<TurnedChart> charts{{8, 2, 0, 1, smooth_function}};
  const std::vector<TurnedChart> before = charts;
  EXPECT_EQ(equalised(images(charts), 2, {}).greatest, std::vector<float>(2, 0.0F));
  EXPECT_EQ(charts[0].values, before[0].values);
}

TEST(Equalise, ResultIsTheSameEachTime) {
  std::vector<TurnedChart> first{{40, 3, 0, 1, smooth_function}, {40, 3, 30, 1.2F, smooth_function}};
  add_noise(first[0], 0.1F, 4);
  std::vector<TurnedChart> second = first;
  const std::vector<Seam> seams{seam_of(first, 0, 1, {-15, 1}, {12, 5})};
  equalise(images(first), 3, seams);
  equalise(images(second), 3, seams);
  for (unsigned k = 0; k < 2; ++k) EXPECT_EQ(first[k].values, second[k].values);
}

// The means of blocks of texels, as a mipmap level has them.
TurnedChart level_of(const TurnedChart& chart, unsigned level) {
  TurnedChart means = chart;
  const unsigned block = 1U << level;
  means.width /= block;
  means.height /= block;
  means.values.assign(std::size_t{means.width} * means.height * chart.channels, 0);
  for (unsigned y = 0; y < means.height * block; ++y)
    for (unsigned x = 0; x < means.width * block; ++x)
      for (unsigned c = 0; c < chart.channels; ++c)
        means.values[(y / block * means.width + x / block) * chart.channels + c] +=
            chart.values[(y * chart.width + x) * chart.channels + c] / static_cast<float>(block * block);
  return means;
}

// The greatest difference in each of three levels.
std::array<float, 3> jumps_in_levels(const std::vector<TurnedChart>& charts, const Seam& seam) {
  std::array<float, 3> jumps{};
  for (unsigned level = 0; level < 3; ++level) {
    std::vector<TurnedChart> means{level_of(charts[0], level), level_of(charts[1], level)};
    std::vector<Seam> scaled{seam};
    for (SeamSide* side : {&scaled[0].a, &scaled[0].b})
      for (auto* end : {&side->from, &side->to})
        for (float& texel : *end) texel /= static_cast<float>(1U << level);
    jumps.at(level) = greatest(seam_jumps(images(means), means[0].channels, scaled).greatest);
  }
  return jumps;
}

TEST(Equalise, ThreeLevelsAgree) {
  // Heights are three more than widths; both must be multiples of four.
  std::vector<TurnedChart> charts{{61, 2, 0, 1, smooth_function}, {89, 2, 30, 1.4F, smooth_function}};
  for (TurnedChart& chart : charts) {
    std::vector<float> narrower;
    const unsigned width = chart.width / 4 * 4;
    for (std::size_t y = 0; y < chart.height; ++y) {
      const float* row = chart.values.data() + y * chart.width * chart.channels;
      narrower.insert(narrower.end(), row, row + std::size_t{width} * chart.channels);
    }
    chart.values = narrower;
    chart.width = width;
  }
  for (float& value : charts[1].values) value += 0.2F;
  add_noise(charts[0], 0.05F, 7);
  const Seam seam = seam_of(charts, 0, 1, {-20, -3}, {20, 4});
  std::vector<TurnedChart> first_level = charts;
  equalise(images(first_level), 2, std::vector<Seam>{seam});
  EXPECT_GT(jumps_in_levels(first_level, seam)[2], 0.1F);
  equalise(images(charts), 2, std::vector<Seam>{seam}, {.levels = 3});
  const std::array<float, 3> left = jumps_in_levels(charts, seam);
  EXPECT_LE(left[0], one_step_of_8_bits);
  EXPECT_LE(left[1], 0.03F);
  EXPECT_LE(left[2], 0.06F);
}

// Two charts of one flat surface whose tangents differ by an angle: a normal has other coordinates in each.
TEST(Equalise, NormalsAgreeInTheSpaceOfThePositions) {
  const float angle = 40 * 3.14159265F / 180;
  const auto tilted = [](Point p, unsigned channel) {
    const Vector n = common::unit(Vector{0.3F * std::sin(0.2F * p[0]), 0.3F * std::cos(0.3F * p[1]), 1});
    return n[channel];
  };
  const auto turned = [&](Point p, unsigned channel) {
    const float x = tilted(p, 0), y = tilted(p, 1);
    const float local[] = {x * std::cos(angle) + y * std::sin(angle), y * std::cos(angle) - x * std::sin(angle),
                           tilted(p, 2)};
    return local[channel];
  };
  std::vector<TurnedChart> charts{{60, 3, 0, 1, tilted}, {90, 3, 30, 1.4F, turned}};
  add_noise(charts[0], 0.1F, 3);
  const std::vector<Seam> seams{seam_of(charts, 0, 1, {-20, -3}, {20, 4})};
  const Vector up{0, 0, 1}, along{1, 0, 0}, other{std::cos(angle), std::sin(angle), 0};
  const std::vector<SeamFrames> frames{{{up, up}, {{{along, along}, {other, other}}}}};
  equalise(images(charts), 3, seams, {}, frames);
  // Turned back, both sides are the same.
  for (std::size_t i = 0; i < charts[1].values.size(); i += 3) {
    const float x = charts[1].values[i], y = charts[1].values[i + 1];
    charts[1].values[i] = x * std::cos(angle) - y * std::sin(angle);
    charts[1].values[i + 1] = x * std::sin(angle) + y * std::cos(angle);
  }
  EXPECT_LE(greatest(seam_jumps(images(charts), 3, seams).greatest), one_step_of_8_bits);
}

}  // namespace
}  // namespace glark::maps::test
