// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/delaunay.h"

#include <gtest/gtest.h>

#include <random>

#include "glark/clients/surfel/strip_path.h"

namespace glark::surfel::test {
namespace {

using Point = Delaunay::Point;

// By the definition, in integers: no point is within a triangle's circle. Points are small enough for 64 bits.
bool empty_circles(const Delaunay& delaunay, const std::vector<Point>& points) {
  for (const Delaunay::Triangle& triangle : delaunay.triangles()) {
    if (!delaunay.finite(triangle)) continue;
    for (const Point& d : points) {
      std::array<std::array<std::int64_t, 2>, 3> m{};
      for (std::size_t k = 0; k < 3; ++k) {
        m[k] = {points[triangle.corners[k]].x - d.x, points[triangle.corners[k]].y - d.y};
      }
      std::int64_t sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto &a = m[k], &b = m[(k + 1) % 3], &c = m[(k + 2) % 3];
        sum += (a[0] * a[0] + a[1] * a[1]) * (b[0] * c[1] - b[1] * c[0]);
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
    const Point a = points[triangle.corners[0]], b = points[triangle.corners[1]], c = points[triangle.corners[2]];
    const std::int64_t twice = std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
    EXPECT_GT(twice, 0);
    sum += twice;
  }
  return sum;
}

TEST(Delaunay, RandomPoints) {
  std::mt19937 random(3);
  std::uniform_int_distribution<std::int32_t> any(-1000, 1000);
  Delaunay delaunay;
  for (int round = 0; round < 50; ++round) {
    std::vector<Point> points = {{-1000, -1000}, {1000, -1000}, {1000, 1000}, {-1000, 1000}};
    for (int i = 0; i < 80; ++i) points.push_back({any(random), any(random)});
    delaunay.triangulate(points);
    EXPECT_TRUE(empty_circles(delaunay, points));
    EXPECT_EQ(area(delaunay, points), 2 * 2000 * 2000);
  }
}

// All on circles and lines, and many on one another.
TEST(Delaunay, GridsWithDuplicates) {
  std::vector<Point> points;
  for (std::int32_t i = 0; i < 200; ++i) points.push_back({i % 10 * 100, i / 10 % 10 * 100});
  Delaunay delaunay;
  delaunay.triangulate(points);
  EXPECT_TRUE(empty_circles(delaunay, points));
  EXPECT_EQ(area(delaunay, points), 2 * 900 * 900);
}

TEST(Delaunay, FewPointsAndLines) {
  Delaunay delaunay;
  const auto count = [&](const std::vector<Point>& points) {
    delaunay.triangulate(points);
    std::size_t finite = 0;
    for (const auto& triangle : delaunay.triangles()) finite += delaunay.finite(triangle) ? 1 : 0;
    return finite;
  };
  EXPECT_EQ(count({}), 0U);
  EXPECT_EQ(count({{1, 1}, {1, 1}, {5, 5}}), 0U);
  EXPECT_EQ(count({{0, 0}, {1, 1}, {2, 2}, {-7, -7}, {Delaunay::greatest, Delaunay::greatest}}), 0U);
  EXPECT_EQ(count({{0, 0}, {Delaunay::greatest, 0}, {0, Delaunay::greatest}}), 1U);
}

TEST(Stripper, HasEveryTriangleOnceAsItIs) {
  std::vector<Point> points;
  std::mt19937 random(4);
  std::uniform_int_distribution<std::int32_t> any(-1000, 1000);
  for (int i = 0; i < 60; ++i) points.push_back({any(random), any(random)});
  Delaunay delaunay;
  delaunay.triangulate(points);
  std::vector<StripTriangle> triangles;
  for (const auto& triangle : delaunay.triangles()) {
    if (delaunay.finite(triangle) && random() % 4 != 0) triangles.push_back(triangle.corners);
  }
  Stripper stripper({}, false);
  const auto strip = stripper.strip(triangles);
  std::vector<StripTriangle> found;
  for (std::size_t i = 0; i + 2 < strip.size(); ++i) {
    StripTriangle t = {strip[i], strip[i + 1], strip[i + 2]};
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    if (i % 2 == 1) std::swap(t[0], t[1]);
    found.push_back(t);
  }
  for (auto* list : {&triangles, &found}) {
    for (StripTriangle& t : *list) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(list->begin(), list->end());
  }
  EXPECT_EQ(found, triangles);
  EXPECT_LT(strip.size(), triangles.size() * 2);
}

}  // namespace
}  // namespace glark::surfel::test
