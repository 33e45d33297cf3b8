// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/space/spatial_order.h"

#include <algorithm>
#include <array>
#include <limits>

#include "glark/clients/stream/space/morton.h"

namespace glark::stream {
namespace {

using common::Vector3f;

constexpr unsigned digit = 8, digits = 3;
constexpr float cubes = 256;

struct Keyed {
  std::uint32_t key, index;
};

// One pass of a radix sort.
void sort_by_digit(const std::vector<Keyed>& from, unsigned shift, std::vector<Keyed>& to) {
  std::array<std::uint32_t, (1U << digit) + 1> begins{};
  const auto digit_of = [&](const Keyed& keyed) { return (keyed.key >> shift) & ((1U << digit) - 1); };
  for (const Keyed& keyed : from) ++begins[digit_of(keyed) + 1];
  for (std::size_t i = 1; i < begins.size(); ++i) begins[i] += begins[i - 1];
  for (const Keyed& keyed : from) to[begins[digit_of(keyed)]++] = keyed;
}

}  // namespace

std::vector<std::uint32_t> spatial_order(std::span<const Vector3f> points) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Vector3f low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  for (const Vector3f& p : points) {
    if (!(p.x + p.y + p.z - p.x - p.y - p.z < infinity)) continue;
    low = common::least(low, p);
    high = common::greatest(high, p);
  }
  const float side = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  const float scale = side > 0 && side < infinity ? cubes / side : 0;
  const auto place = [&](float x, float from) {  // NaN and what lies outside count as 0
    const float at = (x - from) * scale;
    return at > 0 ? static_cast<std::uint32_t>(std::min(at, cubes - 1)) : 0U;
  };
  std::vector<Keyed> keyed(points.size()), sorted(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const std::array<std::uint32_t, 3> cube{place(points[i].x, low.x), place(points[i].y, low.y),
                                            place(points[i].z, low.z)};
    keyed[i] = {static_cast<std::uint32_t>(morton_code(cube)), i};
  }
  for (unsigned pass = 0; pass < digits; ++pass) {
    sort_by_digit(keyed, digit * pass, sorted);
    keyed.swap(sorted);
  }
  std::vector<std::uint32_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = keyed[i].index;
  return order;
}

}  // namespace glark::stream
