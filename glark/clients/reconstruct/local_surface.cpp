// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/local_surface.h"

#include <algorithm>
#include <cmath>

namespace glark::vstree {
namespace {

constexpr float least_facing = 0.2F;  // of a sample's normal and the one looked along
constexpr float least_opposed = -0.8F;
constexpr float few = 3;            // samples
constexpr float sharpness = 0.01F;  // the least of what weights fall with
constexpr float planes = 0.25F;     // share of the samples' planes in a height
constexpr float noise_weight = 100;

struct Sums {
  float weight = 0;
  float count = 0;
  float opposed = 0;  // samples
  Float4 offset{};    // from the point
  Float4 normal{};
  float heights = 0;  // above the point, of the samples' planes
};

void add(const Record* begin, const Record* end, Float4 point, Float4 normal, float scale, float blur, Sums& sums) {
  for (const Record* record = begin; record != end; ++record) {
    const Float4 d = without_fourth(record->position - point);
    const float t = dot(d, d) * scale;
    if (t >= 1) continue;
    const float facing = dot(record->normal, normal);
    if (facing < least_facing) {
      sums.opposed += facing < least_opposed ? 1.0F : 0.0F;
      continue;
    }
    const float weight = (1 - t) * (1 - t) / (t + blur);
    sums.weight += weight;
    sums.count += 1;
    sums.offset += d * weight;
    sums.normal += record->normal * weight;
    sums.heights += dot(d, record->normal) * weight;
  }
}

}  // namespace

// The mean height of samples that a curved surface has around a point is as far on one side of it as that of their tangent planes on the
// other; so half the sum has no error of second order, and no system of equations has to be solved.
LocalEstimate LocalSurface::within(Float4 point, Float4 normal, float radius) const {
  std::size_t depth = 0;
  while (depth + 1 < octree_.levels.size() && octree_.levels[depth].side() < 2 * radius) ++depth;
  const Level& level = octree_.levels[depth];
  const auto cells = static_cast<float>(1U << level.level);
  CellIndex low{};
  for (int i = 0; i < 3; ++i)
    low[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(std::floor(point[i] * cells - 0.5F));
  Sums sums;
  const float scale = 1 / (radius * radius);
  const float noise = noise_weight * octree_.noise * octree_.noise * scale;
  const float blur = sharpness + noise * noise;
  for (std::int32_t which = 0; which < 8; ++which) {
    const auto [begin, end] = level.records({low[0] + (which & 1), low[1] + ((which >> 1) & 1), low[2] + (which >> 2)});
    add(octree_.records.data() + begin, octree_.records.data() + end, point, normal, scale, blur, sums);
  }
  LocalEstimate estimate;
  estimate.opposed = sums.opposed >= few && sums.count == 0;
  if (sums.count < few) return estimate;
  estimate.normal = unit(without_fourth(sums.normal));
  const float height = (dot(sums.offset, estimate.normal) * (1 - planes) + sums.heights * planes) / sums.weight;
  estimate.point = point + estimate.normal * height;
  estimate.found = true;
  return estimate;
}

LocalEstimate LocalSurface::near(Float4 point, Float4 normal, float radius) const {
  LocalEstimate estimate = within(point, normal, radius);
  estimate.near = estimate.found;
  return estimate.found ? estimate : within(point, normal, 2 * radius);
}

}  // namespace glark::vstree
