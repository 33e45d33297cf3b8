// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/triangulate/delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace glark::surfel::test {
namespace {

using Point = Delaunay::Point;

__extension__ using Int128 = __int128;

std::int64_t cross(Point from, Point a, Point b) {
  return std::int64_t{a.x - from.x} * (b.y - from.y) - std::int64_t{a.y - from.y} * (b.x - from.x);
}

// This is the definition, in exact integers: no point is inside the circumcircle of a triangle.
bool has_empty_circles(const Delaunay& delaunay, const std::vector<Point>& points) {
  for (const Delaunay::Triangle& triangle : delaunay.triangles()) {
    if (!delaunay.finite(triangle)) continue;
    for (const Point& d : points) {
      Int128 sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Point a = points[triangle.corners[k]];
        const std::int64_t x = a.x - d.x, y = a.y - d.y;
        sum += Int128{x * x + y * y} *
               cross(d, points[triangle.corners[(k + 1) % 3]], points[triangle.corners[(k + 2) % 3]]);
      }
      if (sum > 0) return false;
    }
  }
  return true;
}

std::int64_t area(const Delaunay& delaunay, const std::vector<Point>& points) {
  std::int64_t sum = 0;
  for (const Delaunay::Triangle& triangle : delaunay.triangles()) {
    if (!delaunay.finite(triangle)) continue;
    const std::int64_t twice =
        cross(points[triangle.corners[0]], points[triangle.corners[1]], points[triangle.corners[2]]);
    EXPECT_GT(twice, 0);
    sum += twice;
  }
  return sum;
}

// Returns whether links lead back across an edge with the same ends.
bool has_consistent_links(const Delaunay& delaunay) {
  const std::span<const Delaunay::Triangle> triangles = delaunay.triangles();
  std::size_t outside = 0;
  for (std::uint32_t number = 0; number < triangles.size(); ++number) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const std::uint32_t link = triangles[number].links[side];
      if (link == Delaunay::none) {
        ++outside;
        continue;
      }
      const std::uint32_t there = Delaunay::side_of(link);
      const Delaunay::Triangle& other = triangles[Delaunay::triangle_of(link)];
      if (other.links[there] != (number << 2 | side)) return false;
      for (std::uint32_t k = 1; k < 3; ++k) {
        if (other.corners[(there + k) % 3] != triangles[number].corners[(side + 3 - k) % 3]) return false;
      }
    }
  }
  return outside == 3;
}

TEST(SurfelDelaunay, RandomPointsHaveEmptyCircumcircles) {
  std::mt19937 random(3);
  std::uniform_int_distribution<std::int32_t> any(-1000, 1000);
  Delaunay delaunay;
  for (int round = 0; round < 50; ++round) {
    std::vector<Point> points = {{-1000, -1000}, {1000, -1000}, {1000, 1000}, {-1000, 1000}};
    for (int i = 0; i < 80; ++i) points.push_back({any(random), any(random)});
    delaunay.triangulate(points);
    EXPECT_TRUE(has_empty_circles(delaunay, points));
    EXPECT_TRUE(has_consistent_links(delaunay));
    EXPECT_EQ(area(delaunay, points), 2 * 2000 * 2000);
  }
}

// All points lie on common circles and lines, and each point occurs twice.
TEST(SurfelDelaunay, GridWithDuplicatesHasEmptyCircumcircles) {
  std::vector<Point> points;
  for (std::int32_t i = 0; i < 200; ++i) points.push_back({i % 10 * 100, i / 10 % 10 * 100});
  Delaunay delaunay;
  delaunay.triangulate(points);
  EXPECT_TRUE(has_empty_circles(delaunay, points));
  EXPECT_TRUE(has_consistent_links(delaunay));
  EXPECT_EQ(area(delaunay, points), 2 * 900 * 900);
}

// Coordinates are as large as possible. In the second part, each point is slightly off the circle. Doubles can hardly
// represent this difference.
TEST(SurfelDelaunay, CocircularPointsHaveEmptyCircumcircles) {
  constexpr std::int32_t radius = 5 * 13 * 17 * 29, scale = 32;
  std::vector<Point> points;
  for (std::int32_t y = -radius; y <= radius; ++y) {
    const auto x = static_cast<std::int32_t>(std::lrint(std::sqrt(double(radius) * radius - double(y) * y)));
    if (std::int64_t{x} * x + std::int64_t{y} * y != std::int64_t{radius} * radius) continue;
    points.push_back({x * scale, y * scale});
    if (x != 0) points.push_back({-x * scale, y * scale});
  }
  ASSERT_EQ(points.size(), 324U);
  Delaunay delaunay;
  delaunay.triangulate(points);
  EXPECT_TRUE(has_empty_circles(delaunay, points));
  EXPECT_TRUE(has_consistent_links(delaunay));
  std::vector<Point> polygon = points;
  std::sort(polygon.begin(), polygon.end(),
            [](Point a, Point b) { return std::atan2(a.y, a.x) < std::atan2(b.y, b.x); });
  std::int64_t whole = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    whole += cross({0, 0}, polygon[i], polygon[(i + 1) % polygon.size()]);
  EXPECT_EQ(area(delaunay, points), whole);

  std::mt19937 random(7);
  std::uniform_int_distribution<std::int32_t> any(-1, 1);
  for (Point& point : points) point = {point.x + any(random), point.y + any(random)};
  delaunay.triangulate(points);
  EXPECT_TRUE(has_empty_circles(delaunay, points));
  EXPECT_TRUE(has_consistent_links(delaunay));
  EXPECT_GT(area(delaunay, points), whole / 1000 * 999);
}

// In doubles, these determinants are zero or have the wrong sign.
TEST(SurfelDelaunay, AlmostCocircularPointsNeedExactPredicates) {
  const std::vector<std::array<Point, 4>> all = {
      {{{-1045110, -71119}, {-175536, -1032715}, {-1020975, -234356}, {539759, 897762}}},
      {{{-440552, -950383}, {-411913, -963141}, {-1034634, -163847}, {196470, 1028882}}},
      {{{-49467, -1046359}, {-71043, -1045116}, {634455, -833535}, {-464625, 938907}}},
      {{{-1025616, 213133}, {164483, -1034533}, {180786, -1031809}, {580868, 871740}}},
      {{{259004, -1015003}, {-792595, -684914}, {-835161, -632312}, {232118, 1021445}}}};
  Delaunay delaunay;
  for (const std::array<Point, 4>& four : all) {
    std::vector<Point> points(four.begin(), four.end());
    for (int turned = 0; turned < 4; ++turned) {  // each time, another point is inserted last
      for (Point& point : points) point = {-point.y, point.x};
      delaunay.triangulate(points);
      EXPECT_TRUE(has_empty_circles(delaunay, points));
      EXPECT_TRUE(has_consistent_links(delaunay));
    }
  }
}

// The first part has a dense cluster far away from two other points. The second part has all points on a line.
TEST(SurfelDelaunay, UnevenPointsHaveEmptyCircumcircles) {
  std::mt19937 random(8);
  std::uniform_int_distribution<std::int32_t> any(0, 60);
  std::vector<Point> points = {{-Delaunay::max_coordinate, -Delaunay::max_coordinate},
                               {Delaunay::max_coordinate, -Delaunay::max_coordinate}};
  for (int i = 0; i < 400; ++i) points.push_back({any(random), any(random) / 30});
  Delaunay delaunay;
  delaunay.triangulate(points);
  EXPECT_TRUE(has_empty_circles(delaunay, points));
  EXPECT_TRUE(has_consistent_links(delaunay));
  for (Point& point : points) point.x = 5;
  delaunay.triangulate(points);
  EXPECT_EQ(area(delaunay, points), 0);
  EXPECT_TRUE(has_consistent_links(delaunay));
}

TEST(SurfelDelaunay, LargeCoordinatesAreClamped) {
  constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max(),
                         least = std::numeric_limits<std::int32_t>::min();
  Delaunay delaunay;
  delaunay.triangulate(std::vector<Point>{{least, 0}, {0, least}, {most, most}, {0, 0}, {least, least}});
  EXPECT_TRUE(has_consistent_links(delaunay));
  EXPECT_EQ(delaunay.triangles().size(), 11U);
}

TEST(SurfelDelaunay, PreferredDuplicatesGetTheTriangles) {
  constexpr std::uint32_t preferred = 60, copies = 3;
  std::mt19937 random(9);
  std::uniform_int_distribution<std::int32_t> any(-1000, 1000);
  std::vector<Point> points;
  for (std::uint32_t i = 0; i < preferred; ++i) points.push_back({any(random), any(random)});
  for (std::uint32_t i = 0; i < copies * preferred; ++i) points.push_back(points[random() % preferred]);
  points.push_back({0, 2000});  // not preferred, and without a duplicate
  Delaunay delaunay;
  delaunay.triangulate(points, preferred);
  EXPECT_TRUE(has_empty_circles(delaunay, points));
  EXPECT_TRUE(has_consistent_links(delaunay));
  std::vector<bool> has_triangles(points.size());
  for (const Delaunay::Triangle& triangle : delaunay.triangles()) {
    for (const std::uint32_t corner : triangle.corners) {
      if (corner < points.size()) has_triangles[corner] = true;
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(has_triangles[i], i < preferred || i + 1 == points.size());
}

TEST(SurfelDelaunay, FewOrCollinearPointsHaveNoTriangles) {
  Delaunay delaunay;
  const auto count = [&](const std::vector<Point>& points) {
    delaunay.triangulate(points);
    std::size_t finite = 0;
    for (const auto& triangle : delaunay.triangles()) finite += delaunay.finite(triangle) ? 1 : 0;
    return finite;
  };
  EXPECT_EQ(count({}), 0U);
  EXPECT_EQ(count({{1, 1}, {1, 1}, {5, 5}}), 0U);
  EXPECT_EQ(count({{0, 0}, {1, 1}, {2, 2}, {-7, -7}, {Delaunay::max_coordinate, Delaunay::max_coordinate}}), 0U);
  EXPECT_EQ(count({{0, 0}, {Delaunay::max_coordinate, 0}, {0, Delaunay::max_coordinate}}), 1U);
}

}  // namespace
}  // namespace glark::surfel::test
