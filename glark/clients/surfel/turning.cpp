// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/turning.h"

#include <algorithm>
#include <limits>

namespace glark::surfel {
namespace {

constexpr std::size_t most_turned = 8;  // edges for one or two indices
// Of the sum of the cotangents of the angles opposite to the new edge, which is not negative where it fulfils Delaunay's criterion: what
// two angles of 130 degrees have.
constexpr float least_cotangents = -1.68F;

}  // namespace

bool may_turn_edge(Vector p, Vector a, Vector d, Vector b) {
  const Vector pa = a - p, pb = b - p, pd = d - p, da = a - d, db = b - d;
  const Vector at_a = cross(pa, pd), at_b = cross(pd, pb);
  const float size_a = length(at_a), size_b = length(at_b);
  const float smallest = std::numeric_limits<float>::min();
  if (dot(pa, da) / std::max(size_a, smallest) + dot(pb, db) / std::max(size_b, smallest) < least_cotangents)
    return false;
  const Vector now = cross(pa, pb), beyond = cross(db, da);
  const float size = length(now), size_beyond = length(beyond);
  return dot(now, beyond) > flat * size * size_beyond && dot(at_a, at_b) > flat * size_a * size_b &&
         dot(now, at_a) > flat * size * size_a && dot(now, at_b) > flat * size * size_b;
}

bool has(const StripTriangle& triangle, std::uint32_t point) {
  return triangle[0] == point || triangle[1] == point || triangle[2] == point;
}

std::uint32_t corner_off(const StripTriangle& triangle, const StripTriangle& other) {
  return !has(other, triangle[0]) ? 0 : !has(other, triangle[1]) ? 1 : 2;
}

std::uint32_t common_point(const StripTriangle& a, const StripTriangle& b, const StripTriangle& c) {
  for (const std::uint32_t point : b) {
    if (has(a, point) && has(c, point)) return point;
  }
  return b[0];
}

// The edge to the next.
bool Turning::can_turn(const StripTriangle& one, const StripTriangle& other) const {
  const std::uint32_t k = corner_off(one, other);
  return may_turn_edge(positions_[one[k]], positions_[one[(k + 1) % 3]], positions_[other[corner_off(other, one)]],
                       positions_[one[(k + 2) % 3]]);
}

// Of every other edge.
bool Turning::can_turn_all(std::span<const StripTriangle> triangles, std::size_t first, std::size_t last) const {
  if ((last - first) / 2 + 1 > most_turned) return false;
  for (std::size_t at = first; at <= last; at += 2) {
    if (!can_turn(triangles[at], triangles[at + 1])) return false;
  }
  return true;
}

// That between a triangle and the next, but where what is before or after is folded on the two, in noise, and has the other diagonal
// already. The first of the new ones has the edge to the one before.
bool Turning::turn(std::span<StripTriangle> triangles, std::size_t at) const {
  const StripTriangle one = triangles[at], other = triangles[at + 1];
  const std::uint32_t k = corner_off(one, other);
  const std::uint32_t p = one[k], a = one[(k + 1) % 3], b = one[(k + 2) % 3];
  const std::uint32_t d = other[corner_off(other, one)];
  const auto has_both = [&](const StripTriangle& beside) { return has(beside, p) && has(beside, d); };
  if ((at > 0 && has_both(triangles[at - 1])) || (at + 2 < triangles.size() && has_both(triangles[at + 2])))
    return false;
  const bool a_first = at > 0 ? has(triangles[at - 1], a) && has(triangles[at - 1], p)
                              : !(has(triangles[at + 2], a) && has(triangles[at + 2], d));
  triangles[at] = a_first ? StripTriangle{p, a, d} : StripTriangle{p, d, b};
  triangles[at + 1] = a_first ? StripTriangle{p, d, b} : StripTriangle{p, a, d};
  return true;
}

void Turning::turn_all(std::span<StripTriangle> triangles, std::size_t first, std::size_t last) {
  for (std::size_t at = first; at <= last; at += 2) turned_ += turn(triangles, at) ? 1 : 0;
}

std::size_t Turning::run(std::span<StripTriangle> triangles) {
  turned_ = 0;
  const std::size_t count = triangles.size();
  if (count < 4) return 0;
  sides_.assign(count, 0);
  doubled_.clear();
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const std::uint32_t pivot = common_point(triangles[i - 1], triangles[i], triangles[i + 1]);
    const std::uint32_t tip = corner_off(triangles[i], triangles[i - 1]);
    sides_[i] = triangles[i][(tip + 1) % 3] == pivot ? 1 : 0;
    if (i > 1 && sides_[i] == sides_[i - 1]) doubled_.push_back(i - 1);
  }
  if (doubled_.empty()) return 0;
  std::size_t next = 0;
  const std::size_t first = doubled_.front();
  if (can_turn_all(triangles, (first - 1) % 2, first - 1)) {
    turn_all(triangles, (first - 1) % 2, first - 1);
    ++next;
  }
  for (; next + 1 < doubled_.size(); ++next) {
    const std::size_t one = doubled_[next], other = doubled_[next + 1];
    if (sides_[one] == sides_[other] || !can_turn_all(triangles, one + 1, other - 1)) continue;
    turn_all(triangles, one + 1, other - 1);
    ++next;
  }
  if (next < doubled_.size()) {
    const std::size_t last = doubled_.back() + 1;
    const std::size_t end = last + (count - 2 - last) / 2 * 2;
    if (can_turn_all(triangles, last, end)) turn_all(triangles, last, end);
  }
  return turned_;
}

}  // namespace glark::surfel
