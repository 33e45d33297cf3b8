// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/fill/diffusion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace glark::maps::test {
namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

// A raster with its memory. Texels without a sample hold numbers that nobody may read.
struct SampledChart {
  unsigned width, height, channels;
  std::vector<float> values, weights;

  SampledChart(unsigned w, unsigned h, unsigned c = 1)
      : width(w), height(h), channels(c), values(std::size_t{w} * h * c, not_a_number), weights(std::size_t{w} * h) {}
  float& at(unsigned x, unsigned y, unsigned channel = 0) { return values[(y * width + x) * channels + channel]; }
  bool is_known(unsigned x, unsigned y) const { return weights[y * width + x] > 0; }
  void set(unsigned x, unsigned y, float value) {
    weights[y * width + x] = 1;
    for (unsigned c = 0; c < channels; ++c) at(x, y, c) = value + static_cast<float>(c);
  }
  Raster raster() { return {width, height, channels, values, weights}; }
};

using Height = std::function<float(float, float)>;

void set_border(SampledChart& chart, const Height& value) {
  for (unsigned y = 0; y < chart.height; ++y)
    for (unsigned x = 0; x < chart.width; ++x)
      if (x == 0 || y == 0 || x + 1 == chart.width || y + 1 == chart.height)
        chart.set(x, y, value(static_cast<float>(x), static_cast<float>(y)));
}

SampledChart scattered(unsigned width, unsigned height, unsigned channels, double part, unsigned seed) {
  SampledChart chart(width, height, channels);
  std::mt19937 random(seed);
  const auto number = [&] { return static_cast<float>(random() % 65536) / 65536; };
  for (unsigned y = 0; y < height; ++y)
    for (unsigned x = 0; x < width; ++x)
      if (number() < part) chart.set(x, y, number());
  return chart;
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

TEST(Diffusion, SingleTexelBecomesTheMeanOfItsNeighbours) {
  SampledChart chart(3, 3);
  const float given[9] = {9, 1, 9, 2, 0, 4, 9, 5, 9};
  for (unsigned i = 0; i < 9; ++i)
    if (i != 4) chart.set(i % 3, i / 3, given[i]);
  const Diffusion done = diffuse(chart.raster());
  EXPECT_EQ(done.filled, 1U);
  EXPECT_EQ(chart.at(1, 1), 3.0F);
}

TEST(Diffusion, CornerReflectsTheBorder) {
  SampledChart chart(2, 2);
  chart.set(1, 0, 1);
  chart.set(0, 1, 4);
  chart.set(1, 1, 100);
  diffuse(chart.raster());
  EXPECT_NEAR(chart.at(0, 0), 2.5F, 1e-5F);
}

TEST(Diffusion, LineBetweenTwoSamplesIsALinearRamp) {
  for (const bool is_row : {true, false}) {
    SampledChart chart(is_row ? 11 : 1, is_row ? 1 : 11);
    chart.set(0, 0, 0);
    chart.set(chart.width - 1, chart.height - 1, 10);
    const Diffusion done = diffuse(chart.raster(), {.tolerance = 1e-5F, .max_iterations = 100});
    EXPECT_EQ(done.gradient_steps, 0U);
    for (unsigned i = 0; i < 11; ++i) EXPECT_NEAR(chart.values[i], static_cast<float>(i), 1e-2F) << i;
  }
}

TEST(Diffusion, WithoutSamplesAllValuesBecomeZero) {
  SampledChart chart(5, 4, 3);
  const Diffusion done = diffuse(chart.raster());
  EXPECT_EQ(done.filled, 0U);
  for (const float value : chart.values) EXPECT_EQ(value, 0.0F);
}

TEST(Diffusion, WithAllSamplesNothingChanges) {
  SampledChart chart = scattered(7, 5, 2, 2.0, 1);
  const std::vector<float> before = chart.values;
  EXPECT_EQ(diffuse(chart.raster()).filled, 0U);
  EXPECT_TRUE(same_bits(before, chart.values));
}

TEST(Diffusion, OneSampleFillsTheRasterWithItsValue) {
  for (const auto& [width, height] : {std::pair{1U, 9U}, {64U, 64U}, {37U, 100U}}) {
    SampledChart chart(width, height, 7);
    chart.set(width / 3, height / 2, 0.25F);
    const Diffusion done = diffuse(chart.raster());
    EXPECT_EQ(done.filled, std::size_t{width} * height - 1);
    for (unsigned i = 0; i < chart.values.size(); ++i)
      EXPECT_NEAR(chart.values[i], 0.25F + static_cast<float>(i % 7), 1e-4F) << width << " x " << height;
  }
}

TEST(Diffusion, BorderedRampIsReproduced) {
  for (const unsigned size : {3U, 16U, 33U, 64U, 100U, 257U}) {
    SampledChart chart(size, size + 3);
    const float most = 2 * static_cast<float>(size) + 3 * static_cast<float>(size + 3);
    const Height ramp = [](float x, float y) { return 2 * x + 3 * y; };
    set_border(chart, ramp);
    EXPECT_EQ(diffuse(chart.raster()).gradient_steps, 0U);
    for (unsigned y = 0; y < chart.height; ++y)
      for (unsigned x = 0; x < size; ++x)
        EXPECT_NEAR(chart.at(x, y), ramp(static_cast<float>(x), static_cast<float>(y)), 1e-3F * most) << size;
  }
}

// Properties of any solution, for many sizes, channels and parts of samples.
TEST(Diffusion, SamplesStayAndFilledValuesLieWithinTheirRange) {
  unsigned seed = 0;
  for (const auto& [width, height] : {std::pair{1U, 17U}, {31U, 1U}, {2U, 2U}, {20U, 33U}, {64U, 64U}}) {
    for (const unsigned channels : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 17U}) {
      for (const double part : {0.05, 0.3, 0.7, 0.95}) {
        SampledChart chart = scattered(width, height, channels, part, ++seed);
        const SampledChart before = chart;
        const Diffusion done = diffuse(chart.raster());
        const auto known = static_cast<std::size_t>(std::count(before.weights.begin(), before.weights.end(), 1.0F));
        if (known == 0) continue;
        EXPECT_EQ(done.filled, before.weights.size() - known);
        std::vector<float> least(channels, 1e9F), greatest(channels, -1e9F);
        for (std::size_t i = 0; i < chart.values.size(); ++i) {
          if (before.weights[i / channels] == 0) continue;
          ASSERT_EQ(chart.values[i], before.values[i]);
          least[i % channels] = std::min(least[i % channels], chart.values[i]);
          greatest[i % channels] = std::max(greatest[i % channels], chart.values[i]);
        }
        for (std::size_t i = 0; i < chart.values.size(); ++i) {
          ASSERT_GE(chart.values[i], least[i % channels] - 1e-5F) << width << " x " << height << " x " << channels;
          ASSERT_LE(chart.values[i], greatest[i % channels] + 1e-5F) << width << " x " << height << " x " << channels;
        }
      }
    }
  }
}

TEST(Diffusion, FilledValuesAreTheMeansOfTheirNeighbours) {
  SampledChart chart = scattered(50, 41, 3, 0.4, 5);
  const SampledChart before = chart;
  diffuse(chart.raster(), {.tolerance = 1e-6F, .max_iterations = 100});
  for (unsigned y = 1; y + 1 < chart.height; ++y)
    for (unsigned x = 1; x + 1 < chart.width; ++x)
      for (unsigned c = 0; c < 3 && !before.is_known(x, y); ++c)
        EXPECT_NEAR(4 * chart.at(x, y, c),
                    chart.at(x - 1, y, c) + chart.at(x + 1, y, c) + chart.at(x, y - 1, c) + chart.at(x, y + 1, c),
                    1e-4F);
}

TEST(Diffusion, ChannelsDoNotDependOnEachOther) {
  for (const unsigned channels : {2U, 3U, 5U, 7U, 8U, 11U}) {
    SampledChart chart = scattered(40, 30, channels, 0.3, channels);
    std::vector<SampledChart> single(channels, SampledChart(40, 30));
    for (unsigned c = 0; c < channels; ++c) {
      single[c].weights = chart.weights;
      for (std::size_t i = 0; i < chart.weights.size(); ++i) single[c].values[i] = chart.values[i * channels + c];
      diffuse(single[c].raster(), {.tolerance = 1e-6F, .max_iterations = 100});
    }
    diffuse(chart.raster(), {.tolerance = 1e-6F, .max_iterations = 100});
    for (unsigned i = 0; i < chart.values.size(); ++i)
      ASSERT_NEAR(chart.values[i], single[i % channels].values[i / channels], 1e-4F) << channels;
  }
}

TEST(Diffusion, SymmetricSamplesGiveSymmetricValues) {
  SampledChart chart(48, 48);
  for (unsigned i = 10; i < 38; ++i) {
    chart.set(i, 5, 1);
    chart.set(5, i, 1);
    chart.set(i, 42, 0);
    chart.set(42, i, 0);
  }
  diffuse(chart.raster(), {.tolerance = 1e-5F, .max_iterations = 100});
  for (unsigned y = 0; y < 48; ++y)
    for (unsigned x = 0; x < 48; ++x) {
      EXPECT_NEAR(chart.at(x, y), chart.at(y, x), 1e-4F);
      EXPECT_NEAR(chart.at(x, y), 1 - chart.at(47 - x, 47 - y), 1e-4F);
    }
}

TEST(Diffusion, KeptMemoryDoesNotChangeTheResult) {
  Diffuser diffuser;
  const SampledChart given = scattered(61, 45, 7, 0.3, 9);
  SampledChart first = given, second = given, third = given;
  diffuse(first.raster());
  for (SampledChart other : {scattered(100, 90, 8, 0.1, 1), scattered(3, 2, 1, 0.5, 2), SampledChart(9, 9)})
    diffuser.fill(other.raster());
  diffuser.fill(second.raster());
  diffuser.fill(third.raster());
  EXPECT_TRUE(same_bits(first.values, second.values));
  EXPECT_TRUE(same_bits(first.values, third.values));
}

TEST(Diffusion, WeightsThatAreNotAboveZeroAreNoSamples) {
  SampledChart chart(3, 1);
  chart.set(0, 0, 1);
  chart.set(1, 0, 77);
  chart.set(2, 0, 3);
  for (const float weight : {0.0F, -1.0F, not_a_number}) {
    chart.weights[1] = weight;
    EXPECT_EQ(diffuse(chart.raster()).filled, 1U);
    EXPECT_NEAR(chart.at(1, 0), 2, 1e-5F);
  }
}

// Returns the greatest difference of a filled value and the mean of its neighbours.
float worst_mean(const SampledChart& chart) {
  float worst = 0;
  for (unsigned y = 0; y < chart.height; ++y) {
    for (unsigned x = 0; x < chart.width; ++x) {
      if (chart.is_known(x, y)) continue;
      float sum = 0, count = 0;
      const auto add = [&](bool is_there, unsigned column, unsigned row) {
        if (!is_there) return;
        sum += chart.values[(std::size_t{row} * chart.width + column) * chart.channels];
        ++count;
      };
      add(x > 0, x - 1, y);
      add(x + 1 < chart.width, x + 1, y);
      add(y > 0, x, y - 1);
      add(y + 1 < chart.height, x, y + 1);
      const float value = chart.values[(std::size_t{y} * chart.width + x) * chart.channels];
      worst = std::max(worst, std::abs(sum / count - value));
    }
  }
  return worst;
}

// The coarse levels cannot see samples that lie far apart, so cycles alone make the values worse. The samples are those of
// a slope, so filled values lie near it.
TEST(Diffusion, SamplesThatLieFarApart) {
  for (const unsigned spacing : {8U, 16U, 32U, 64U}) {
    for (const unsigned seed : {1U, 2U}) {
      SampledChart chart(256, 192, 5);
      std::mt19937 random(seed);
      for (unsigned i = 0; i < 256 * 192 / (spacing * spacing); ++i) {
        const auto x = static_cast<unsigned>(random() % 256), y = static_cast<unsigned>(random() % 192);
        chart.set(x, y, static_cast<float>(x) + 0.5F * static_cast<float>(y));
      }
      diffuse(chart.raster());
      EXPECT_LT(worst_mean(chart), 0.25F) << spacing;  // the range is about 350
      double squared = 0;
      for (unsigned y = 0; y < 192; ++y)
        for (unsigned x = 0; x < 256; ++x)
          squared += std::pow(chart.at(x, y) - static_cast<float>(x) - 0.5F * static_cast<float>(y), 2) / (256.0 * 192);
      EXPECT_LT(std::sqrt(squared), 1.0 * spacing) << spacing;
    }
  }
}

TEST(Diffusion, FewCyclesAreFollowedByGradients) {
  SampledChart chart(200, 200);
  set_border(chart, [](float x, float) { return x; });
  const Diffusion done = diffuse(chart.raster(), {.tolerance = 1e-5F, .max_iterations = 2});
  EXPECT_EQ(done.iterations, 2U);
  EXPECT_GT(done.gradient_steps, 10U);
  for (unsigned x = 0; x < 200; ++x) EXPECT_NEAR(chart.at(x, 77), static_cast<float>(x), 0.02F);
}

}  // namespace
}  // namespace glark::maps::test
