// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/triangulate/valence_flipper.h"

#include <array>
#include <span>

#include "glark/clients/surfel/level/flip_criterion.h"

namespace glark::surfel {
namespace {

constexpr std::array<std::uint32_t, 3> next = {1, 2, 0}, before = {2, 0, 1};
constexpr std::array<std::uint8_t, 3> one_more = {1, 2, 0}, one_less = {2, 0, 1};  // valences modulo three
// The number of swaps saved at a point of each valence, if the point gains or loses a triangle.
constexpr std::array<int, 3> saved_by_more = {-1, 0, 1}, saved_by_less = {-1, 1, 0};

}  // namespace

void ValenceFlipper::count_valences() {
  valences_.assign(triangulation_.member_count(), 0);
  for (const Delaunay::Triangle& triangle : triangulation_.triangles()) {
    if (!triangulation_.delaunay().finite(triangle)) continue;
    for (const std::uint32_t corner : triangle.corners) valences_[corner] = one_more[valences_[corner]];
  }
}

bool ValenceFlipper::flip_if_flat(std::uint32_t number, std::uint32_t side, const InteriorClassifier& classifier) {
  const Delaunay& delaunay = triangulation_.delaunay();
  const auto [corners, links] = delaunay.triangles()[number];
  const std::uint32_t other = Delaunay::triangle_of(links[side]);
  const std::uint32_t p = corners[side], d = delaunay.across(number, side);
  const std::uint32_t a = corners[next[side]], b = corners[before[side]];
  const auto position = [&](std::uint32_t corner) { return triangulation_.member(corner).position; };
  if (dot(triangulation_.facet(number).normal, triangulation_.facet(other).normal) < least_flat_cosine) return false;
  if (!may_flip_edge(position(p), position(a), position(d), position(b))) return false;
  const auto both_agreed = [&] { return classifier.is_agreed(number) && classifier.is_agreed(other); };
  if (!delaunay.can_flip(number, side) || !both_agreed()) return false;
  triangulation_.flip(number, side);
  if (!both_agreed()) {
    triangulation_.flip(number, 1);  // undoes the flip
    return false;
  }
  for (const std::uint32_t corner : {p, d}) valences_[corner] = one_more[valences_[corner]];
  for (const std::uint32_t corner : {a, b}) valences_[corner] = one_less[valences_[corner]];
  return true;
}

std::size_t ValenceFlipper::flip_for_valence(const InteriorClassifier& classifier) {
  count_valences();
  std::size_t flipped = 0;
  const std::span<const Delaunay::Triangle> triangles = triangulation_.triangles();
  for (std::uint32_t number = 0; number < triangles.size(); ++number) {
    const auto& [corners, links] = triangles[number];
    for (std::uint32_t side = 0; side < 3 && triangulation_.is_interior(triangles[number]); ++side) {
      const int saved_here = saved_by_more[valences_[corners[side]]] + saved_by_less[valences_[corners[next[side]]]] +
                             saved_by_less[valences_[corners[before[side]]]];
      if (saved_here < 0 || Delaunay::triangle_of(links[side]) < number) continue;
      const std::uint32_t across = triangulation_.delaunay().across(number, side);
      if (across >= triangulation_.own_count() || saved_here + saved_by_more[valences_[across]] <= 0) continue;
      flipped += flip_if_flat(number, side, classifier) ? 1 : 0;
    }
  }
  return flipped;
}

}  // namespace glark::surfel
