// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/triangulate/delaunay.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace glark::surfel {
namespace {

using Place = Delaunay::Place;
__extension__ using Int128 = __int128;

constexpr std::int32_t far_away = 1 << 25;

// Twice a signed area, and a squared length. Both are exact. Relative to an input point, coordinates slightly exceed
// 2^25 at most, and results are below 2^52. Relative to a far point, areas are at most 2^53.
template <typename Vector>
double cross(const Vector& a, const Vector& b) {
  return a.x * b.y - a.y * b.x;
}
template <typename Vector>
double lift(const Vector& a) {
  return a.x * a.x + a.y * a.y;
}

double orientation(Place a, Place b, Place c) {
  return cross(Place{b.x - a.x, b.y - a.y}, Place{c.x - a.x, c.y - a.y});
}

// The circumcircle of the triangle a, b, d. The inserted point is the origin. It lies on the other side of ab than d.
struct Circle {
  double a2, b2, d2;  // lifts
  double ab, ad, db;  // cross products
};

// This test is exact: the determinant has at most 106 bits.
bool contains_origin_exactly(const Circle& circle) {
  const auto product = [](double a, double b) {
    return Int128{static_cast<std::int64_t>(a)} * static_cast<std::int64_t>(b);
  };
  return product(circle.a2, circle.db) + product(circle.b2, circle.ad) - product(circle.d2, circle.ab) > 0;
}

// Doubles decide if their error cannot change the sign. There are three products below 2^104, each rounded at most
// three times.
bool contains_origin(const Circle& circle) {
  const double determinant = circle.a2 * circle.db + circle.b2 * circle.ad - circle.d2 * circle.ab;
  constexpr double greatest_error = 0x1p55;
  if (std::fabs(determinant) > greatest_error) return determinant > 0;
  return contains_origin_exactly(circle);
}

constexpr std::array<std::uint32_t, 3> next = {1, 2, 0}, before = {2, 0, 1};

}  // namespace

void Delaunay::triangulate(std::span<const Point> points, std::size_t preferred) {
  count_ = static_cast<std::uint32_t>(points.size());
  preferred_ = static_cast<std::uint32_t>(std::min(preferred, points.size()));
  place_points(points);
  const std::size_t most = 2 * std::size_t{count_} + 1;  // each point adds two triangles
  if (triangles_.size() < most) {
    triangles_.resize(most);
    sides_.resize(most + 3);
    vacant_.resize(most + 4);
  }
  triangles_[0] = {{count_, count_ + 1, count_ + 2}, {none, none, none}};
  made_ = 1;
  last_ = 0;
  if (count_ == 0) return;
  std::uint32_t waiting = order_[0];
  const auto insert_before = [&](std::uint32_t following) { insert(std::exchange(waiting, following), following); };
  // Every sixth point goes first. Then fewer triangles are made that are removed again.
  constexpr std::uint32_t apart = 6;
  for (std::uint32_t i = apart; i < count_; i += apart) insert_before(order_[i]);
  for (std::uint32_t i = 0; i < count_; ++i) {
    if (i % apart != 0) insert_before(order_[i]);
  }
  insert(waiting, waiting);
}

void Delaunay::place_points(std::span<const Point> points) {
  places_.resize(points.size() + 3);
  Place low = {max_coordinate, max_coordinate}, high = {-max_coordinate, -max_coordinate};
  for (std::uint32_t i = 0; i < count_; ++i) {
    const Place at = {static_cast<double>(std::clamp(points[i].x, -max_coordinate, max_coordinate)),
                      static_cast<double>(std::clamp(points[i].y, -max_coordinate, max_coordinate))};
    low = {std::min(low.x, at.x), std::min(low.y, at.y)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    places_[i] = at;
  }
  places_[count_] = {-far_away, -far_away};
  places_[count_ + 1] = {far_away, -far_away};
  places_[count_ + 2] = {0, far_away};
  sort_points(low, high);
}

// Sorts the points by rows of cells, alternately from left to right and back. So each point is near the point before
// it.
void Delaunay::sort_points(Place low, Place high) {
  constexpr double points_a_square = 3;  // in a square as high as a row
  constexpr std::uint32_t cells_a_square = 4;
  const auto rows = static_cast<std::uint32_t>(std::sqrt(count_ / points_a_square)) + 1;
  const std::uint32_t columns = cells_a_square * rows;
  const double to_column = columns / (high.x - low.x + 1), to_row = rows / (high.y - low.y + 1);
  cells_.resize(count_);
  starts_.assign(std::size_t{rows} * columns + 1, 0);
  for (std::uint32_t i = 0; i < count_; ++i) {
    const auto column = static_cast<std::uint32_t>((places_[i].x - low.x) * to_column);
    const auto row = static_cast<std::uint32_t>((places_[i].y - low.y) * to_row);
    cells_[i] = row * columns + (row % 2 == 0 ? column : columns - 1 - column);
    ++starts_[cells_[i] + 1];
  }
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  order_.resize(count_);
  for (std::uint32_t i = 0; i < count_; ++i) order_[starts_[cells_[i]]++] = i;
}

void Delaunay::insert(std::uint32_t index, std::uint32_t following) {
  last_ = locate(places_[index]);
  for (std::size_t i = 0; i < 3; ++i) {
    if (sides_[i].lift == 0) return resolve_duplicate(last_, index);
  }
  fill_cavity(last_, index, following);
}

// Walks across edges that have the point on their other side. Returns the triangle that contains the point. Its sides
// are the first sides of the cavity.
// Based on: de Floriani, Falcidieno, Nagy, Pienovi, On Sorting Triangles in a Delaunay Tessellation, 1991. They show
// that the walk ends.
std::uint32_t Delaunay::locate(Place point) {
  // The walk crosses the edge from a to b. The point lies left of the edge or on it. So does d, the next corner.
  std::uint32_t link = link_to(last_, 0);
  Corner a = corner(triangles_[last_].corners[1], point), b = corner(triangles_[last_].corners[2], point);
  double ab = cross(a, b);
  if (ab < 0) {
    link = triangles_[last_].links[0];
    std::swap(a, b);
    ab = -ab;
  }
  for (;;) {
    const Triangle& triangle = triangles_[triangle_of(link)];
    const std::uint32_t side = side_of(link);
    const Corner d = corner(triangle.corners[side], point);
    const double bd = cross(b, d), da = cross(d, a);
    if (bd < 0) {
      link = triangle.links[next[side]];
      a = d;
      ab = -bd;
    } else if (da < 0) {
      link = triangle.links[before[side]];
      b = d;
      ab = -da;
    } else {
      sides_[2] = {b, lift(b), ab, triangle.links[side]};
      sides_[1] = {d, lift(d), bd, triangle.links[next[side]]};
      sides_[0] = {a, lift(a), da, triangle.links[before[side]]};
      return triangle_of(link);
    }
  }
}

// A corner of the triangle is a duplicate of the point. The point replaces the corner if only the point is preferred.
void Delaunay::resolve_duplicate(std::uint32_t triangle, std::uint32_t index) {
  const auto is_duplicate = [&](std::uint32_t other) {
    return places_[other].x == places_[index].x && places_[other].y == places_[index].y;
  };
  const auto& corners = triangles_[triangle].corners;
  auto side = static_cast<std::uint32_t>(std::find_if(corners.begin(), corners.end(), is_duplicate) - corners.begin());
  if (index >= preferred_ || corners[side] < preferred_) return;
  for (std::uint32_t at = triangle; triangles_[at].corners[side] != index;) {  // around the corner
    triangles_[at].corners[side] = index;
    const std::uint32_t link = triangles_[at].links[next[side]];
    at = triangle_of(link);
    side = next[side_of(link)];
  }
}

// The triangle across the side joins the cavity if its circumcircle contains the point. Then its two other sides
// replace this side: the first goes to `added`, the second to `side`. The side begins at `start`.
inline bool Delaunay::grow_cavity(Side& side, Side& added, const Corner& start, double start_lift, Place point) {
  const Triangle& other = triangles_[triangle_of(side.link)];
  const std::uint32_t j = side_of(side.link);
  const Corner d = corner(other.corners[j], point);
  const Circle circle = {start_lift, side.lift, lift(d), side.cross, cross(start, d), cross(d, side.end)};
  if (!contains_origin(circle)) return false;
  side.cross = circle.db;
  side.link = other.links[before[j]];
  added = {d, circle.d2, circle.ad, other.links[next[j]]};
  return true;
}

// Grows the cavity from the sides of `triangle`, and connects each final side of the cavity with the point. There are
// always as many vacant triangles as sides, so the number of the next triangle is known. The next walk begins in the
// new triangle in the direction of the following point.
void Delaunay::fill_cavity(std::uint32_t triangle, std::uint32_t index, std::uint32_t following) {
  const Place point = places_[index];
  std::uint32_t* vacant = vacant_.data();
  vacant[0] = triangle;
  vacant[1] = made_++;
  vacant[2] = made_++;
  std::uint32_t* vacant_end = vacant + 3;
  std::uint32_t previous = triangle;
  Corner start = sides_[0].end;
  double start_lift = sides_[0].lift;
  const Corner ahead = corner(following, point);
  double start_ahead = cross(start, ahead);
  std::uint32_t towards_following = triangle;
  for (Side* end = sides_.data() + 3; end != sides_.data();) {
    Side& side = end[-1];
    const std::uint32_t link = side.link;
    if (link != none) {
      if (grow_cavity(side, *end, start, start_lift, point)) {
        *vacant_end++ = triangle_of(link);
        ++end;
        continue;
      }
      triangles_[triangle_of(link)].links[side_of(link)] = link_to(*vacant, 0);
    }
    triangles_[*vacant] = {{index, start.index, side.end.index}, {link, link_to(vacant[1], 2), link_to(previous, 1)}};
    previous = *vacant++;
    const double end_ahead = cross(side.end, ahead);
    if ((start_ahead >= 0) & (end_ahead < 0)) towards_following = previous;
    start_ahead = end_ahead;
    start = side.end;
    start_lift = side.lift;
    --end;
  }
  last_ = towards_following;
  triangles_[triangle].links[2] = link_to(previous, 1);
  triangles_[previous].links[1] = link_to(triangle, 2);
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
  const auto set_link = [&](std::uint32_t link, std::uint32_t back) {
    if (link != none) triangles_[triangle_of(link)].links[side_of(link)] = back;
  };
  set_link(beyond_ad, link_to(number, 0));
  set_link(beyond_pa, link_to(number, 2));
  set_link(beyond_db, link_to(other_number, 0));
  set_link(beyond_bp, link_to(other_number, 1));
}

}  // namespace glark::surfel
