// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/patch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "glark/clients/surfel/turning.h"

namespace glark::surfel {
namespace {

constexpr std::size_t most_turned = 256;  // edges
constexpr std::array<std::uint32_t, 3> next = {1, 2, 0}, before = {2, 0, 1};
// A cotangent of edges that stay, whatever is across: a triangle without area may have angles below any number.
constexpr float none_better = std::numeric_limits<float>::infinity();

// The sum of the cotangents of the angles opposite to edge ab in triangles abp and abd: negative where Delaunay's criterion fails.
float cotangents(Vector a, Vector b, Vector p, Vector d) {
  const auto cotangent = [&](Vector at) {
    const Vector s = a - at, t = b - at;
    return dot(s, t) / std::max(length(cross(s, t)), std::numeric_limits<float>::min());
  };
  return cotangent(p) + cotangent(d);
}

}  // namespace

float spacing_of(float a, float b, float c) {
  const float middle = std::max(std::min(a, b), std::min(std::max(a, b), c));
  constexpr float sparser = 3;  // two isolated points have no triangle with one that is none
  return std::min(middle, sparser * std::min({a, b, c}));
}

// By the four points' positions alone, so that all leaves choose alike; of diagonals that are equal, the one of the first point.
bool Patcher::prefers_other_diagonal(std::uint32_t number, std::uint32_t side) const {
  const auto& corners = delaunay_.triangles()[number].corners;
  const Inflation::Member* p = &member(corners[side]);
  const Inflation::Member* d = &member(delaunay_.across(number, side));
  const Inflation::Member* a = &member(corners[(side + 1) % 3]);
  const Inflation::Member* b = &member(corners[(side + 2) % 3]);
  if (a->index > b->index) std::swap(a, b);
  if (p->index > d->index) std::swap(p, d);
  const float now = cotangents(a->position, b->position, p->position, d->position);
  const float other = cotangents(p->position, d->position, a->position, b->position);
  return other > now || (other == now && p->index < a->index);
}

void Patcher::measure(std::uint32_t number) {
  const auto [a, b, c] = delaunay_.triangles()[number].corners;
  Facet& facet = facets_[number];
  if (std::max({a, b, c}) >= inflation_.members.size()) {
    facet.cotangents.fill(none_better);
    return;
  }
  const Vector p = member(a).position, q = member(b).position, r = member(c).position;
  const Vector pq = q - p, qr = r - q, rp = p - r;
  const Vector across = cross(pq, qr);
  const float per_area = 1 / std::max(length(across), std::numeric_limits<float>::min());
  facet.cotangents = {-dot(pq, rp) * per_area, -dot(qr, pq) * per_area, -dot(rp, qr) * per_area};
  facet.sizes = {dot(qr, qr), dot(rp, rp), dot(pq, pq)};
  facet.normal = across * per_area;
}

bool Patcher::is_interior(const Delaunay::Triangle& triangle) const {
  return std::max({triangle.corners[0], triangle.corners[1], triangle.corners[2]}) < inflation_.own;
}

bool Patcher::is_inner(const Delaunay::Triangle& triangle) const {
  return std::min({triangle.corners[0], triangle.corners[1], triangle.corners[2]}) < inflation_.own;
}

// Whether Delaunay's criterion does not hold by far; if it does, there is no better diagonal. The more the edge is bent, the smaller are
// the four angles of the other diagonal.
bool Patcher::may_turn(std::uint32_t number, std::uint32_t side) const {
  const std::uint32_t link = delaunay_.triangles()[number].links[side];
  if (link == Delaunay::none) return false;
  const Facet& one = facets_[number];
  const Facet& other = facets_[Delaunay::triangle_of(link)];
  constexpr float by_far = 0.7F, straight = 0.02F, bent = 2.5F;
  const float sum = one.cotangents[side] + other.cotangents[Delaunay::side_of(link)];
  return sum < straight || (sum < by_far && sum < straight + bent * (1 - dot(one.normal, other.normal)));
}

void Patcher::turn(std::uint32_t number, std::uint32_t side) {
  const Delaunay::Triangle& triangle = delaunay_.triangles()[number];
  // What is two triangles away from the leaf's points is of no use to it.
  if (!is_inner(triangle) && delaunay_.across(number, side) >= inflation_.own) return;
  const std::uint32_t other = Delaunay::triangle_of(triangle.links[side]);
  if (!prefers_other_diagonal(number, side) || !delaunay_.can_flip(number, side)) return;
  pending_.push_back(number);
  pending_.push_back(other);
  delaunay_.flip(number, side);
  measure(number);
  measure(other);
}

// Delaunay's criterion once more, for the triangles in space: planes of neighbouring leaves differ, the points do not.
void Patcher::relax() {
  pending_.clear();
  const auto count = static_cast<std::uint32_t>(delaunay_.triangles().size());
  facets_.resize(count);
  for (std::uint32_t number = 0; number < count; ++number) measure(number);
  for (std::uint32_t number = 0; number < count; ++number) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const std::uint32_t link = delaunay_.triangles()[number].links[side];
      if (Delaunay::triangle_of(link) > number && may_turn(number, side)) turn(number, side);
    }
  }
  // Around those that were turned; in space edges could turn for ever.
  for (std::size_t i = 0; i < pending_.size() && pending_.size() < most_turned; ++i) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      if (may_turn(pending_[i], side)) turn(pending_[i], side);
    }
  }
}

// At sharp creases a triangle can be the wrong way round in the leaf's plane: the points' normals know better.
bool Patcher::faces_away(std::uint32_t number) const {
  const auto [a, b, c] = delaunay_.triangles()[number].corners;
  return dot(facets_[number].normal, member(a).normal + member(b).normal + member(c).normal) < 0;
}

// Of a triangle that reaches beyond all points, the edge that does not, if it is one of the leaf's points.
void Patcher::collect_rim(const Delaunay::Triangle& triangle) {
  std::array<std::uint32_t, 2> ends{};
  std::size_t count = 0;
  for (const std::uint32_t corner : triangle.corners) {
    if (corner < inflation_.members.size() && count < 2) ends[count++] = corner;
  }
  if (count < 2 || std::min(ends[0], ends[1]) >= inflation_.own) return;
  const auto [low, high] = std::minmax(member(ends[0]).index, member(ends[1]).index);
  candidates.push_back({{low, high, high}, false, false, State::rim});
}

// Of a triangle that no other leaf can have, all is known.
State Patcher::state_of_interior(std::uint32_t number, bool away) const {
  const auto [a, b, c] = delaunay_.triangles()[number].corners;
  const float most = reach_ * spacing_of(spacings[a], spacings[b], spacings[c]);
  const auto& sizes = facets_[number].sizes;
  if (std::max({sizes[0], sizes[1], sizes[2]}) > most * most) return State::out_of_reach;
  return away ? State::rejected : State::agreed;
}

bool Patcher::is_agreed(std::uint32_t number) const {
  return state_of_interior(number, faces_away(number)) == State::agreed;
}

bool Patcher::even(std::uint32_t number, std::uint32_t side) {
  const auto corners = delaunay_.triangles()[number].corners;
  const std::uint32_t other = Delaunay::triangle_of(delaunay_.triangles()[number].links[side]);
  const std::uint32_t p = corners[side], d = delaunay_.across(number, side);
  const std::uint32_t a = corners[(side + 1) % 3], b = corners[(side + 2) % 3];
  if (dot(facets_[number].normal, facets_[other].normal) < flat) return false;
  if (!may_turn_edge(member(p).position, member(a).position, member(d).position, member(b).position)) return false;
  if (!delaunay_.can_flip(number, side) || !is_agreed(number) || !is_agreed(other)) return false;
  const auto flip = [&](std::uint32_t at) {
    delaunay_.flip(number, at);
    measure(number);
    measure(other);
  };
  flip(side);
  if (!is_agreed(number) || !is_agreed(other)) {
    flip(1);  // back
    return false;
  }
  constexpr std::array<std::uint8_t, 3> more = {1, 2, 0}, fewer = {2, 0, 1};
  for (const std::uint32_t corner : {p, d}) valences_[corner] = more[valences_[corner]];
  for (const std::uint32_t corner : {a, b}) valences_[corner] = fewer[valences_[corner]];
  return true;
}

// Modulo three.
void Patcher::find_valences() {
  valences_.assign(inflation_.members.size(), 0);
  constexpr std::array<std::uint8_t, 3> more = {1, 2, 0};
  for (const Delaunay::Triangle& triangle : delaunay_.triangles()) {
    if (!delaunay_.finite(triangle)) continue;
    for (const std::uint32_t corner : triangle.corners) valences_[corner] = more[valences_[corner]];
  }
}

// A strip passes a point along three of its triangles: where points have three or six it need not turn. Edges turn where the four points
// come nearer to that; no other leaf has their triangles.
void Patcher::even_valences() {
  turned = 0;
  if (!turn_edges_) return;
  find_valences();
  const std::span<const Delaunay::Triangle> triangles = delaunay_.triangles();
  // By how many turns less a point of that valence costs with a triangle more or less.
  constexpr std::array<int, 3> with_more = {-1, 0, 1}, with_less = {-1, 1, 0};
  for (std::uint32_t number = 0; number < triangles.size(); ++number) {
    const auto& [corners, links] = triangles[number];
    for (std::uint32_t side = 0; side < 3 && is_interior(triangles[number]); ++side) {
      const int here = with_more[valences_[corners[side]]] + with_less[valences_[corners[next[side]]]] +
                       with_less[valences_[corners[before[side]]]];
      if (here < 0 || Delaunay::triangle_of(links[side]) < number) continue;
      const std::uint32_t across = delaunay_.across(number, side);
      if (across >= inflation_.own || here + with_more[valences_[across]] <= 0) continue;
      turned += even(number, side) ? 1 : 0;
    }
  }
}

Candidate Patcher::candidate_of(std::uint32_t number) const {
  const auto [i, j, k] = delaunay_.triangles()[number].corners;
  const std::uint32_t a = member(i).index, b = member(j).index, c = member(k).index;
  const std::uint32_t low = std::min({a, b, c}), high = std::max({a, b, c});
  const bool reversed = ((a > b) != (b > c)) != (a > c);  // an odd number of exchanges sorts them
  return {{low, a ^ b ^ c ^ low ^ high, high}, reversed, faces_away(number), State::contested};
}

void Patcher::collect() {
  candidates.clear();
  interior_.clear();
  outer = 0;
  for (std::uint32_t number = 0; number < delaunay_.triangles().size(); ++number) {
    const Delaunay::Triangle& triangle = delaunay_.triangles()[number];
    const auto [a, b, c] = triangle.corners;
    if (!delaunay_.finite(triangle)) {
      collect_rim(triangle);
    } else if (!is_inner(triangle)) {
      ++outer;
    } else if (std::max({a, b, c}) >= inflation_.own) {
      candidates.push_back(candidate_of(number));
    } else {
      Candidate& candidate = interior_.emplace_back(candidate_of(number));
      candidate.state = state_of_interior(number, candidate.away);
    }
  }
  shared = static_cast<std::uint32_t>(candidates.size());
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return is_before(a.corners, b.corners); });
  candidates.insert(candidates.end(), interior_.begin(), interior_.end());
}

// The third shortest edge: of points on scan lines, that to the next line.
void Patcher::measure_spacings() {
  constexpr float far = std::numeric_limits<float>::infinity();
  const std::size_t own = inflation_.own;
  shortest_.assign(own + 1, {far, far, far});  // and one for all others
  for (std::uint32_t number = 0; number < delaunay_.triangles().size(); ++number) {
    const Delaunay::Triangle& triangle = delaunay_.triangles()[number];
    if (!is_inner(triangle) || !delaunay_.finite(triangle)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      auto& [first, second, third] = shortest_[std::min<std::size_t>(triangle.corners[k], own)];
      const float size = facets_[number].sizes[(k + 2) % 3];
      third = std::min(third, std::max(size, second));
      second = std::min(second, std::max(size, first));
      first = std::min(first, size);
    }
  }
  spacings.clear();
  for (const auto& [first, second, third] : std::span(shortest_).first(own)) {
    constexpr float most = 25;  // squared: a gap around two or three points is not their distance
    const float few = second < far ? second : first < far ? first : 0;
    spacings.push_back(std::sqrt(std::min(third, most * few)));
  }
}

void Patcher::make(std::uint32_t leaf) {
  inflation_.make(leaf);
  delaunay_.triangulate(inflation_.places, inflation_.own);
  relax();
  measure_spacings();
  even_valences();
  collect();
}

}  // namespace glark::surfel
