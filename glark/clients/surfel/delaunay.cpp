// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/delaunay.h"

#include <cmath>
#include <utility>

namespace glark::surfel {
namespace {

using Point = Delaunay::Point;
__extension__ using Int128 = __int128;

constexpr std::int32_t far_away = 1 << 25;

// Twice the signed area: at most 2^53, exact.
std::int64_t orientation(Point a, Point b, Point c) {
  return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
}

// The determinant of the circle through a, b, c, relative to d, in integers of at most 110 bits.
bool in_circle_exactly(Point a, Point b, Point c, Point d) {
  const std::int64_t ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
  const Int128 bc = Int128{bx} * cy - Int128{by} * cx;
  const Int128 ca = Int128{cx} * ay - Int128{cy} * ax;
  const Int128 ab = Int128{ax} * by - Int128{ay} * bx;
  return (ax * ax + ay * ay) * bc + (bx * bx + by * by) * ca + (cx * cx + cy * cy) * ab > 0;
}

}  // namespace

// In doubles where their error leaves no doubt. Based on: Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997, ch. 4.
bool Delaunay::in_circle(const Triangle& triangle, Point d) const {
  const Point a = points_[triangle.corners[0]], b = points_[triangle.corners[1]], c = points_[triangle.corners[2]];
  const double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
  const double a2 = ax * ax + ay * ay, b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const double bxcy = bx * cy, bycx = by * cx, cxay = cx * ay, cyax = cy * ax, axby = ax * by, aybx = ay * bx;
  const double determinant = a2 * (bxcy - bycx) + b2 * (cxay - cyax) + c2 * (axby - aybx);
  const double permanent = a2 * (std::fabs(bxcy) + std::fabs(bycx)) + b2 * (std::fabs(cxay) + std::fabs(cyax)) +
                           c2 * (std::fabs(axby) + std::fabs(aybx));
  constexpr double error = 1.2e-15;  // (10 + 96 epsilon) epsilon, epsilon = 2^-53, rounded up
  if (std::fabs(determinant) > error * permanent) return determinant > 0;
  return in_circle_exactly(a, b, c, d);
}

void Delaunay::triangulate(std::span<const Point> points) {
  count_ = static_cast<std::uint32_t>(points.size());
  points_.assign(points.begin(), points.end());
  points_.insert(points_.end(), {{-far_away, -far_away}, {far_away, -far_away}, {0, far_away}});
  triangles_.clear();
  triangles_.push_back({{count_, count_ + 1, count_ + 2}, {none, none, none}});
  last_ = 0;
  for (std::uint32_t i = 0; i < count_; ++i) insert(i);
}

bool Delaunay::finite(const Triangle& triangle) const {
  return triangle.corners[0] < count_ && triangle.corners[1] < count_ && triangle.corners[2] < count_;
}

// A walk over edges that have the point on their other side; it ends, in a Delaunay triangulation (de Floriani et al. 1991).
std::uint32_t Delaunay::locate(Point point) const {
  std::uint32_t at = last_;
  std::uint32_t from = none;
  for (;;) {
    const Triangle& triangle = triangles_[at];
    std::uint32_t next = none;
    for (std::uint32_t i = 0; i < 3 && next == none; ++i) {
      if (triangle.neighbours[i] == from) continue;
      const Point a = points_[triangle.corners[(i + 1) % 3]], b = points_[triangle.corners[(i + 2) % 3]];
      if (orientation(a, b, point) < 0) next = triangle.neighbours[i];
    }
    if (next == none) return at;
    from = at;
    at = next;
  }
}

void Delaunay::insert(std::uint32_t index) {
  const Point point = points_[index];
  const std::uint32_t first = locate(point);
  const Triangle old = triangles_[first];
  std::array<bool, 3> on_edge;  // then the triangle with that edge has no area, and the edge is turned
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Point a = points_[old.corners[i]];
    if (a.x == point.x && a.y == point.y) {
      last_ = first;
      return;
    }
    on_edge[i] = orientation(points_[old.corners[(i + 1) % 3]], points_[old.corners[(i + 2) % 3]], point) == 0;
  }
  const auto second = static_cast<std::uint32_t>(triangles_.size());
  const std::array<std::uint32_t, 3> made = {first, second, second + 1};
  triangles_.resize(triangles_.size() + 2);
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::uint32_t next = made[(i + 1) % 3], before = made[(i + 2) % 3];
    triangles_[made[i]] = {{index, old.corners[(i + 1) % 3], old.corners[(i + 2) % 3]},
                           {old.neighbours[i], next, before}};
    if (i > 0) replace_neighbour(old.neighbours[i], first, made[i]);
  }
  last_ = first;
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (on_edge[i]) legalise(made[i], true);
  }
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (!on_edge[i]) legalise(made[i], false);
  }
}

// The point that was inserted is the first corner of all triangles that are looked at.
void Delaunay::legalise(std::uint32_t triangle, bool forced) {
  pending_.push_back(triangle);
  while (!pending_.empty()) {
    const std::uint32_t at = pending_.back();
    pending_.pop_back();
    const std::uint32_t other = triangles_[at].neighbours[0];
    if (other == none) continue;
    if (!forced && !in_circle(triangles_[at], points_[across(at, 0)])) continue;
    forced = false;
    flip(at, 0);
    pending_.push_back(at);
    pending_.push_back(other);
  }
}

void Delaunay::replace_neighbour(std::uint32_t of, std::uint32_t before, std::uint32_t now) {
  if (of == none) return;
  for (std::uint32_t& neighbour : triangles_[of].neighbours) {
    if (neighbour == before) {
      neighbour = now;
      return;
    }
  }
}

std::uint32_t Delaunay::across(std::uint32_t triangle, std::uint32_t side) const {
  const Triangle& other = triangles_[triangles_[triangle].neighbours[side]];
  if (other.neighbours[0] == triangle) return other.corners[0];
  return other.neighbours[1] == triangle ? other.corners[1] : other.corners[2];
}

bool Delaunay::can_flip(std::uint32_t triangle, std::uint32_t side) const {
  const Triangle& one = triangles_[triangle];
  const Point p = points_[one.corners[side]], d = points_[across(triangle, side)];
  const Point a = points_[one.corners[(side + 1) % 3]], b = points_[one.corners[(side + 2) % 3]];
  return orientation(p, a, d) > 0 && orientation(p, d, b) > 0;
}

void Delaunay::flip(std::uint32_t number, std::uint32_t side) {
  const Triangle one = triangles_[number];
  const std::uint32_t other_number = one.neighbours[side];
  const Triangle other = triangles_[other_number];
  std::uint32_t j = 0;
  while (other.neighbours[j] != number) ++j;
  const std::uint32_t p = one.corners[side], d = other.corners[j];
  const std::uint32_t a = one.corners[(side + 1) % 3], b = one.corners[(side + 2) % 3];
  const std::uint32_t beyond_ad = other.neighbours[(j + 1) % 3], beyond_db = other.neighbours[(j + 2) % 3];
  const std::uint32_t beyond_pa = one.neighbours[(side + 2) % 3], beyond_bp = one.neighbours[(side + 1) % 3];
  triangles_[number] = {{p, a, d}, {beyond_ad, other_number, beyond_pa}};
  triangles_[other_number] = {{p, d, b}, {beyond_db, beyond_bp, number}};
  replace_neighbour(beyond_ad, other_number, number);
  replace_neighbour(beyond_bp, number, other_number);
}

}  // namespace glark::surfel
