// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/triangulate/space_triangulation.h"

#include <cmath>
#include <limits>
#include <utility>

namespace glark::surfel {
namespace {

constexpr std::size_t most_pending = 256;  // a limit, because in space edges could flip forever
// The cotangent of triangles at far points, so that their edges are never flipped. It is infinite, because the
// cotangents of degenerate triangles have no limit.
constexpr float never_flip = std::numeric_limits<float>::infinity();

// Returns the sum of the cotangents of the angles opposite to edge ab, in the triangles abp and abd. The sum is
// negative if edge ab is not Delaunay.
float cotangent_sum(Vector a, Vector b, Vector p, Vector d) {
  const auto cotangent = [&](Vector at) {
    const Vector s = a - at, t = b - at;
    return dot(s, t) / std::max(length(cross(s, t)), std::numeric_limits<float>::min());
  };
  return cotangent(p) + cotangent(d);
}

}  // namespace

void SpaceTriangulation::measure(std::uint32_t number) {
  const auto [a, b, c] = delaunay_.triangles()[number].corners;
  Facet& facet = facets_[number];
  if (std::max({a, b, c}) >= member_count()) {
    facet.cotangents.fill(never_flip);
    return;
  }
  const Vector p = member(a).position, q = member(b).position, r = member(c).position;
  const Vector pq = q - p, qr = r - q, rp = p - r;
  const Vector normal = cross(pq, qr);
  const float per_area = 1 / std::max(length(normal), std::numeric_limits<float>::min());
  facet.cotangents = {-dot(pq, rp) * per_area, -dot(qr, pq) * per_area, -dot(rp, qr) * per_area};
  facet.squared_lengths = {dot(qr, qr), dot(rp, rp), dot(pq, pq)};
  facet.normal = normal * per_area;
}

// The criterion uses only the positions of the four points. So all leaves choose the same diagonal. Among equal
// diagonals, the criterion chooses the one at the first point.
bool SpaceTriangulation::prefers_other_diagonal(std::uint32_t number, std::uint32_t side) const {
  const auto& corners = delaunay_.triangles()[number].corners;
  const LeafInflation::Member* p = &member(corners[side]);
  const LeafInflation::Member* d = &member(delaunay_.across(number, side));
  const LeafInflation::Member* a = &member(corners[(side + 1) % 3]);
  const LeafInflation::Member* b = &member(corners[(side + 2) % 3]);
  if (a->index > b->index) std::swap(a, b);
  if (p->index > d->index) std::swap(p, d);
  const float current = cotangent_sum(a->position, b->position, p->position, d->position);
  const float other = cotangent_sum(p->position, d->position, a->position, b->position);
  return other > current || (other == current && p->index < a->index);
}

// A fast test. It returns false only if the other diagonal cannot be better. The more the edge is bent, the smaller are
// the four angles at the other diagonal.
bool SpaceTriangulation::may_violate_delaunay(std::uint32_t number, std::uint32_t side) const {
  const std::uint32_t link = delaunay_.triangles()[number].links[side];
  if (link == Delaunay::none) return false;
  const Facet& one = facets_[number];
  const Facet& other = facets_[Delaunay::triangle_of(link)];
  constexpr float enough = 0.7F, enough_if_flat = 0.02F, slope = 2.5F;
  const float sum = one.cotangents[side] + other.cotangents[Delaunay::side_of(link)];
  return sum < enough_if_flat || (sum < enough && sum < enough_if_flat + slope * (1 - dot(one.normal, other.normal)));
}

void SpaceTriangulation::flip(std::uint32_t number, std::uint32_t side) {
  const std::uint32_t other = Delaunay::triangle_of(delaunay_.triangles()[number].links[side]);
  delaunay_.flip(number, side);
  measure(number);
  measure(other);
}

void SpaceTriangulation::flip_if_better(std::uint32_t number, std::uint32_t side) {
  const Delaunay::Triangle& triangle = delaunay_.triangles()[number];
  // Triangles farther away from the leaf's own points are not used.
  if (!is_inner(triangle) && delaunay_.across(number, side) >= own_count()) return;
  const std::uint32_t other = Delaunay::triangle_of(triangle.links[side]);
  if (!prefers_other_diagonal(number, side) || !delaunay_.can_flip(number, side)) return;
  pending_.push_back(number);
  pending_.push_back(other);
  flip(number, side);
}

// The planes of neighbouring leaves differ, but the positions of their points in space are the same. So leaves agree on
// more triangles after these flips.
void SpaceTriangulation::flip_for_delaunay() {
  pending_.clear();
  const auto count = static_cast<std::uint32_t>(delaunay_.triangles().size());
  facets_.resize(count);
  for (std::uint32_t number = 0; number < count; ++number) measure(number);
  for (std::uint32_t number = 0; number < count; ++number) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const std::uint32_t link = delaunay_.triangles()[number].links[side];
      if (Delaunay::triangle_of(link) > number && may_violate_delaunay(number, side)) flip_if_better(number, side);
    }
  }
  // Each flip changes the angles opposite to the edges around it.
  for (std::size_t i = 0; i < pending_.size() && pending_.size() < most_pending; ++i) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      if (may_violate_delaunay(pending_[i], side)) flip_if_better(pending_[i], side);
    }
  }
}

void SpaceTriangulation::triangulate(std::uint32_t leaf) {
  inflation_.inflate(leaf);
  delaunay_.triangulate(inflation_.plane_points(), own_count());
  flip_for_delaunay();
}

}  // namespace glark::surfel
