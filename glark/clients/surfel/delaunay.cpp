// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/delaunay.h"

#include <algorithm>
#include <cmath>

namespace glark::surfel {
namespace {

using Place = Delaunay::Place;
__extension__ using Int128 = __int128;

constexpr std::int32_t far_away = 1 << 25;

// Twice the signed area: at most 2^53, exact.
double orientation(Place a, Place b, Place c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

// The determinant of the circle through a, b, c, relative to d, in integers of at most 110 bits.
bool in_circle_exactly(Place a, Place b, Place c, Place d) {
  const auto away = [](double from, double to) { return static_cast<std::int64_t>(to - from); };
  const std::int64_t ax = away(d.x, a.x), ay = away(d.y, a.y), bx = away(d.x, b.x), by = away(d.y, b.y);
  const std::int64_t cx = away(d.x, c.x), cy = away(d.y, c.y);
  const Int128 bc = Int128{bx} * cy - Int128{by} * cx;
  const Int128 ca = Int128{cx} * ay - Int128{cy} * ax;
  const Int128 ab = Int128{ax} * by - Int128{ay} * bx;
  return (ax * ax + ay * ay) * bc + (bx * bx + by * by) * ca + (cx * cx + cy * cy) * ab > 0;
}

// In doubles where their error leaves no doubt. Based on: Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997, ch. 4.
bool in_circle(Place a, Place b, Place c, Place d) {
  const double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
  const double a2 = ax * ax + ay * ay, b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const double bxcy = bx * cy, bycx = by * cx, cxay = cx * ay, cyax = cy * ax, axby = ax * by, aybx = ay * bx;
  const double determinant = a2 * (bxcy - bycx) + b2 * (cxay - cyax) + c2 * (axby - aybx);
  constexpr double any_error = 0x1p60;  // the one below is less for differences up to 2^26
  if (std::fabs(determinant) > any_error) return determinant > 0;
  const double permanent = a2 * (std::fabs(bxcy) + std::fabs(bycx)) + b2 * (std::fabs(cxay) + std::fabs(cyax)) +
                           c2 * (std::fabs(axby) + std::fabs(aybx));
  constexpr double error = 1.2e-15;  // (10 + 96 epsilon) epsilon, epsilon = 2^-53, rounded up
  if (std::fabs(determinant) > error * permanent) return determinant > 0;
  return in_circle_exactly(a, b, c, d);
}

constexpr std::array<std::uint32_t, 3> next = {1, 2, 0}, before = {2, 0, 1};

}  // namespace

void Delaunay::triangulate(std::span<const Point> points, std::size_t preferred) {
  count_ = static_cast<std::uint32_t>(points.size());
  places_.clear();
  for (const auto& [x, y] : points) places_.push_back({static_cast<double>(x), static_cast<double>(y)});
  places_.insert(places_.end(), {{-far_away, -far_away}, {far_away, -far_away}, {0, far_away}});
  triangles_.clear();
  triangles_.push_back({{count_, count_ + 1, count_ + 2}, {none, none, none}});
  last_ = 0;
  latest_.fill(none);
  const auto middle = static_cast<std::uint32_t>(std::min(preferred, points.size()));
  insert_some(0, middle);
  insert_some(middle, count_);
}

// Every sixteenth first, then every fourth: with points that are sorted along a line, fewer edges turn.
void Delaunay::insert_some(std::uint32_t begin, std::uint32_t end) {
  constexpr std::uint32_t widest = 16, narrower = 4;
  for (std::uint32_t step = widest; step > 0; step /= narrower) {
    for (std::uint32_t i = begin; i < end; i += step) {
      if (step == widest || (i - begin) % (narrower * step) != 0) insert(i);
    }
  }
}

// A walk over edges that have the point on their other side; it ends, in a Delaunay triangulation (de Floriani et al. 1991).
std::uint32_t Delaunay::locate(Place point, std::uint32_t at) const {
  std::uint32_t from = 3;  // the side by which it was entered
  for (;;) {
    const Triangle& triangle = triangles_[at];
    std::uint32_t link = none;
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (i == from) continue;
      const Place a = places_[triangle.corners[next[i]]], b = places_[triangle.corners[before[i]]];
      if (orientation(a, b, point) >= 0) continue;
      link = triangle.links[i];
      break;
    }
    if (link == none) return at;
    at = triangle_of(link);
    from = side_of(link);
  }
}

void Delaunay::insert(std::uint32_t index) {
  const Place point = places_[index];
  constexpr double cell = 2.0 * greatest / cells;
  const auto cell_of = [](double x) {
    return static_cast<std::uint32_t>(std::clamp((x + greatest) / cell, 0.0, cells - 1.0));
  };
  std::uint32_t& latest = latest_[cell_of(point.y) * cells + cell_of(point.x)];
  const std::uint32_t first = locate(point, latest == none ? last_ : latest);
  latest = first;
  const Triangle old = triangles_[first];
  std::array<bool, 3> on_edge;  // then the triangle with that edge has no area, and the edge is turned
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Place a = places_[old.corners[i]];
    if (a.x == point.x && a.y == point.y) {
      last_ = first;
      return;
    }
    on_edge[i] = orientation(places_[old.corners[next[i]]], places_[old.corners[before[i]]], point) == 0;
  }
  const auto second = static_cast<std::uint32_t>(triangles_.size());
  const std::array<std::uint32_t, 3> made = {first, second, second + 1};
  triangles_.resize(triangles_.size() + 2);
  for (std::uint32_t i = 0; i < 3; ++i) {
    // Across the new edges: the one after shares the edge to corner i + 2, the one before that to corner i + 1.
    triangles_[made[i]] = {{index, old.corners[next[i]], old.corners[before[i]]},
                           {old.links[i], link_to(made[next[i]], 2), link_to(made[before[i]], 1)}};
    if (i > 0 && old.links[i] != none)
      triangles_[triangle_of(old.links[i])].links[side_of(old.links[i])] = link_to(made[i], 0);
  }
  if (old.links[0] != none) triangles_[triangle_of(old.links[0])].links[side_of(old.links[0])] = link_to(first, 0);
  last_ = first;
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (on_edge[i]) legalise(made[i], true);
  }
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (!on_edge[i]) legalise(made[i], false);
  }
}

// The point that was inserted is the first corner of all triangles that are looked at.
void Delaunay::legalise(std::uint32_t number, bool forced) {
  pending_.push_back(number);
  while (!pending_.empty()) {
    const std::uint32_t at = pending_.back();
    pending_.pop_back();
    const Triangle& triangle = triangles_[at];
    const std::uint32_t link = triangle.links[0];
    if (link == none) continue;
    const std::uint32_t beyond = triangles_[triangle_of(link)].corners[side_of(link)];
    const auto& [a, b, c] = triangle.corners;
    if (!forced && !in_circle(places_[a], places_[b], places_[c], places_[beyond])) continue;
    forced = false;
    flip(at, 0);
    pending_.push_back(at);
    pending_.push_back(triangle_of(link));
  }
}

bool Delaunay::can_flip(std::uint32_t triangle, std::uint32_t side) const {
  const Triangle& one = triangles_[triangle];
  const Place p = places_[one.corners[side]], d = places_[across(triangle, side)];
  const Place a = places_[one.corners[next[side]]], b = places_[one.corners[before[side]]];
  return orientation(p, a, d) > 0 && orientation(p, d, b) > 0;
}

void Delaunay::flip(std::uint32_t number, std::uint32_t side) {
  const Triangle one = triangles_[number];
  const std::uint32_t other_number = triangle_of(one.links[side]), j = side_of(one.links[side]);
  const Triangle other = triangles_[other_number];
  const std::uint32_t p = one.corners[side], d = other.corners[j];
  const std::uint32_t a = one.corners[next[side]], b = one.corners[before[side]];
  const std::uint32_t beyond_ad = other.links[next[j]], beyond_db = other.links[before[j]];
  const std::uint32_t beyond_pa = one.links[before[side]], beyond_bp = one.links[next[side]];
  triangles_[number] = {{p, a, d}, {beyond_ad, link_to(other_number, 2), beyond_pa}};
  triangles_[other_number] = {{p, d, b}, {beyond_db, beyond_bp, link_to(number, 1)}};
  const auto tell = [&](std::uint32_t link, std::uint32_t back) {
    if (link != none) triangles_[triangle_of(link)].links[side_of(link)] = back;
  };
  tell(beyond_ad, link_to(number, 0));
  tell(beyond_pa, link_to(number, 2));
  tell(beyond_db, link_to(other_number, 0));
  tell(beyond_bp, link_to(other_number, 1));
}

}  // namespace glark::surfel
