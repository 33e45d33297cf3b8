// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/normals/upright.h"

#include <cmath>
#include <tuple>

namespace glark::vstree {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFF;
constexpr float trusted = 0.9F;    // near an edge, a normal may be wrong
constexpr float level = 0.5F;      // the least cosine between the vertical and the normal of a level place
constexpr float one_sided = 0.5F;  // the share of an open sheet that faces one way rather than the other

// Returns for each part the sample that decides: a given one, or else the highest of those that are trusted and level.
std::vector<std::uint32_t> leaders_of_parts(SignedParts& parts, std::span<const Float4> points,
                                            std::span<const Float4> normals, std::span<const float> trust,
                                            const std::vector<bool>& given) {
  const auto rank = [&](std::uint32_t i) {
    const bool is_level = trust[i] > trusted && std::abs(normals[i][2]) > level;
    return std::tuple(given[i] ? 2 : (is_level ? 1 : 0), static_cast<float>(points[i][2]));
  };
  std::vector<std::uint32_t> leaders(points.size(), none);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::uint32_t& best = leaders[parts.find(i).root];
    if (best == none || rank(i) > rank(best)) best = i;
  }
  return leaders;
}

}  // namespace

std::vector<bool> reversed_parts(SignedParts& parts, std::span<const Float4> points, std::span<const Float4> normals,
                                 std::span<const float> trust, const std::vector<bool>& given) {
  std::vector<float> ups(points.size()), sizes(points.size());  // sums over the parts
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const SignedParts::Place place = parts.find(i);
    const float up = normals[i][2];
    ups[place.root] += place.reversed ? -up : up;
    sizes[place.root] += std::abs(up);
  }
  const std::vector<std::uint32_t> leaders = leaders_of_parts(parts, points, normals, trust, given);
  std::vector<bool> result(points.size());
  for (std::uint32_t root = 0; root < points.size(); ++root) {
    const std::uint32_t leader = leaders[root];
    if (leader == none) continue;
    const bool is_sheet = std::abs(ups[root]) > one_sided * sizes[root];
    const bool is_up = given[leader] || normals[leader][2] >= 0;
    result[root] = is_sheet && !given[leader] ? ups[root] < 0 : parts.find(leader).reversed == is_up;
  }
  return result;
}

}  // namespace glark::vstree
