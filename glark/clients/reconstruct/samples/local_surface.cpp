// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/samples/local_surface.h"

#include <algorithm>

namespace glark::reconstruct {
namespace {

constexpr float least_facing = 0.2F;  // least cosine between a sample's normal and the given one
constexpr float least_opposed = -0.8F;
constexpr int few = 3;              // fewer samples give no estimate
constexpr float sharpness = 0.01F;  // the least divisor of the weights
constexpr float bend = 0.6F;        // the share of the curvature that is applied
constexpr float noise_weight = 100;
constexpr float least_spread_of_samples = 1e-3F;  // relative to the squared radius: closer samples show no curvature
// The largest box that is searched as a whole, relative to the side of the finest cells.
constexpr float most_sides = 6;

struct Query {
  Float4 point, normal;
  float scale;  // 1 / radius^2
  float blur;
};

struct Sums {
  float weight = 0;
  int count = 0;
  int opposed = 0;  // the number of samples
  Float4 offset{};  // relative to the point
  Float4 normal{};
  float heights = 0;  // heights of the samples' planes above the point
  float squares = 0;  // squared distances from the point
  Float4 colour{};
};

// Sums over four samples at a time. A branch for each sample would take longer than the arithmetic.
class Lanes {
 public:
  explicit Lanes(const Query& query)
      : point_{splat<0>(query.point), splat<1>(query.point), splat<2>(query.point)},
        along_{splat<0>(query.normal), splat<1>(query.normal), splat<2>(query.normal)},
        scale_(all(query.scale)),
        blur_(all(query.blur)) {}

  template <bool with_colours>
  void add(const FourSamples& four) {
    const Float4(&n)[3] = four.normal;
    const Float4 d[3] = {four.position[0] - point_[0], four.position[1] - point_[1], four.position[2] - point_[2]};
    const Float4 square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2], t = square * scale_;
    const Float4 facing = n[0] * along_[0] + n[1] * along_[1] + n[2] * along_[2];
    const Int4 inside = t < all(1);
    const Int4 near = inside & (facing >= all(least_facing));
    opposed_ -= inside & (facing < all(least_opposed));
    count_ -= near;
    const Float4 weight = where(near, (all(1) - t) * (all(1) - t) / (t + blur_));
    weight_ += weight;
    for (int i = 0; i < 3; ++i) {
      offset_[i] += d[i] * weight;
      normal_[i] += n[i] * weight;
    }
    heights_ += (d[0] * n[0] + d[1] * n[1] + d[2] * n[2]) * weight;
    squares_ += square * weight;
    if constexpr (with_colours) {
      for (int i = 0; i < 3; ++i) colour_[i] += unpack_colour(four.colour, i) * weight;
    }
  }

  Sums sums() const {
    return {.weight = sum(weight_),
            .count = sum(count_),
            .opposed = sum(opposed_),
            .offset = Float4{sum(offset_[0]), sum(offset_[1]), sum(offset_[2]), 0},
            .normal = Float4{sum(normal_[0]), sum(normal_[1]), sum(normal_[2]), 0},
            .heights = sum(heights_),
            .squares = sum(squares_),
            .colour = Float4{sum(colour_[0]), sum(colour_[1]), sum(colour_[2]), 0}};
  }

 private:
  static Float4 all(float a) { return Float4{a, a, a, a}; }
  static float sum(Float4 a) { return (a[0] + a[1]) + (a[2] + a[3]); }
  static int sum(Int4 a) { return a[0] + a[1] + a[2] + a[3]; }
  static Float4 where(Int4 mask, Float4 a) { return std::bit_cast<Float4>(std::bit_cast<Int4>(a) & mask); }

  const Float4 point_[3], along_[3];
  const Float4 scale_, blur_;
  Int4 count_{}, opposed_{};
  Float4 weight_{}, heights_{}, squares_{};
  Float4 offset_[3]{}, normal_[3]{}, colour_[3]{};
};

// Puts the estimate on the sphere that fits the samples around a point and their normals. Meshes are flat between their
// vertices, and so lie inside the sphere. To make up for this, only a part of the curvature is applied.
// Based on: G. Guennebaud, M. Germann, M. Gross, Dynamic Sampling and Rendering of Algebraic Point Set Surfaces, 2008,
// section 3.
void fit(const Sums& sums, float radius, LocalEstimate& estimate) {
  const float share = 1 / sums.weight;
  const Float4 mean = sums.offset * share, normal = sums.normal * share;
  const float square = sums.squares * share, spread = square - dot(mean, mean);
  const float least_spread = least_spread_of_samples * radius * radius, sharpest = 0.5F / radius;
  const float quadratic =
      spread > least_spread
          ? std::clamp(bend / 2 * (sums.heights * share - dot(mean, normal)) / spread, -sharpest, sharpest)
          : 0;
  const Float4 gradient = normal - mean * (2 * quadratic);
  const float slope = std::sqrt(dot(gradient, gradient));
  if (!(slope > 0)) return;
  const float value = -(dot(gradient, mean) + quadratic * square) / slope;
  const float root = std::sqrt(std::max(0.0F, 1 - 4 * value * quadratic / slope));
  estimate.normal = gradient / slope;
  estimate.point += estimate.normal * std::clamp(-2 * value / (1 + root), -radius, radius);
  estimate.found = true;
}

}  // namespace

LocalEstimate LocalSurface::within(Float4 point, Float4 normal, float radius) {
  const Float4 reach{radius, radius, radius, 0};
  const Float4 low = point - reach, high = point + reach;
  const bool is_alone = !around_.covers(low, high);
  if (is_alone) alone_.gather(octree_, low, high);
  const float scale = 1 / (radius * radius);
  const float noise = noise_weight * octree_.noise * octree_.noise * scale;
  Lanes lanes({point, normal, scale, sharpness + noise * noise});
  const std::span<const FourSamples> samples = (is_alone ? alone_ : around_).all();
  if (octree_.has_colours) {
    for (const FourSamples& four : samples) lanes.add<true>(four);
  } else {
    for (const FourSamples& four : samples) lanes.add<false>(four);
  }
  const Sums sums = lanes.sums();
  LocalEstimate estimate;
  estimate.opposed = sums.opposed >= few && sums.count == 0;
  if (sums.count < few || !(sums.weight > 0)) return estimate;
  estimate.point = point;
  estimate.colour = sums.colour / sums.weight;
  fit(sums, radius, estimate);
  return estimate;
}

void LocalSurface::look_around(Float4 low, Float4 high) {
  const Float4 size = high - low;
  if (std::max({size[0], size[1], size[2]}) < most_sides * octree_.finest().side()) around_.gather(octree_, low, high);
}

LocalEstimate LocalSurface::near(Float4 point, Float4 normal, float radius) {
  LocalEstimate estimate = within(point, normal, radius);
  estimate.near = estimate.found;
  return estimate.found ? estimate : within(point, normal, 2 * radius);
}

}  // namespace glark::reconstruct
