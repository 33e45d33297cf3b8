// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Simplification makes no edge of more than two triangles, where vertices at one position count as one.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/bench_points/measure/mesh_quality.h"
#include "tests/shapes/parts.h"
#include "tests/vstree/shapes.h"

namespace glark::vstree::test {
namespace {

std::size_t crowded_edges(std::span<const float> positions, std::span<const std::uint32_t> triangles) {
  return bench::non_manifold_by_position({positions, triangles});
}

TEST(TouchingParts, GetNoEdgesOfMoreTriangles) {
  for (const Method method : {Method::cluster, Method::collapse}) {
    for (unsigned seed = 1; seed < 4; ++seed) {
      for (const auto make : {shapes::assembly, shapes::cup, shapes::gear, shapes::bracket}) {
        const shapes::Part part = make(seed, 1);
        const Simplified few = simplify({{.positions = part.positions}, part.triangles},
                                        {.target = part.triangle_count() / 10, .method = method});
        EXPECT_LE(crowded_edges(few.positions, few.triangles), crowded_edges(part.positions, part.triangles));
        EXPECT_LE(few.triangles.size() / 3, part.triangle_count() / 10);
      }
    }
  }
}

// A square that stands on the middle line of another one: three triangles meet at each edge of the line.
TEST(TouchingParts, EdgesOfThreeTrianglesStayJoined) {
  Shape shape;
  constexpr std::uint32_t n = 20;
  const auto add = [&](auto&& at) {
    const auto first = static_cast<std::uint32_t>(shape.size());
    for (std::uint32_t i = 0; i <= n; ++i) {
      for (std::uint32_t k = 0; k <= n; ++k) {
        const std::array<float, 3> point = at(static_cast<float>(i), static_cast<float>(k));
        shape.positions.insert(shape.positions.end(), point.begin(), point.end());
        if (i == n || k == n) continue;
        const std::uint32_t a = first + i * (n + 1) + k;
        shape.triangles.insert(shape.triangles.end(), {a, a + n + 1, a + n + 2, a, a + n + 2, a + 1});
      }
    }
  };
  add([](float x, float y) { return std::array<float, 3>{x, y, 0}; });
  add([](float x, float z) { return std::array<float, 3>{x, 10, z}; });  // n / 2
  const Simplified few = simplify({{.positions = shape.positions}, shape.triangles},
                                  {.target = shape.triangles.size() / 12, .method = Method::collapse});
  for (std::size_t i = 0; i < few.positions.size(); i += 3)
    EXPECT_TRUE(few.positions[i + 2] == 0 || few.positions[i + 1] == 10) << "a vertex left the squares";
}

// Pages that meet in a spine: sheets that touch, and edges of many triangles that stay.
Shape book(unsigned seed) {
  const std::uint32_t pages = 5 + seed % 4, n = 24;
  Shape shape;
  for (std::uint32_t i = 0; i <= n; ++i) shape.positions.insert(shape.positions.end(), {0, 0, static_cast<float>(i)});
  for (std::uint32_t page = 0; page < pages; ++page) {
    const double turn = 6.28318 * (page + 0.1 * seed) / pages;
    const auto first = static_cast<std::uint32_t>(shape.size());
    const auto at = [&](std::uint32_t row, std::uint32_t i) { return row == 0 ? i : first + (row - 1) * (n + 1) + i; };
    for (std::uint32_t row = 0; row <= n; ++row) {
      for (std::uint32_t i = 0; i <= n; ++i) {
        const double bend = turn + 0.3 * std::sin(0.2 * row + 0.3 * i + seed);
        if (row > 0)
          shape.positions.insert(shape.positions.end(),
                                 {static_cast<float>(row * std::cos(bend)), static_cast<float>(row * std::sin(bend)),
                                  static_cast<float>(i)});
        if (row == n || i == n) continue;
        const std::uint32_t a = at(row, i), b = at(row + 1, i), c = at(row + 1, i + 1), d = at(row, i + 1);
        shape.triangles.insert(shape.triangles.end(), {a, b, c, a, c, d});
      }
    }
  }
  return shape;
}

TEST(TouchingParts, PagesOfABookGetNoMoreEdgesOfManyTriangles) {
  for (unsigned seed = 1; seed < 9; ++seed) {
    const Shape shape = book(seed);
    for (const std::size_t part : {4U, 6U, 8U, 10U}) {
      const Simplified few = simplify({{.positions = shape.positions}, shape.triangles},
                                      {.target = shape.triangles.size() / 3 / part, .method = Method::automatic});
      EXPECT_LE(crowded_edges(few.positions, few.triangles), crowded_edges(shape.positions, shape.triangles))
          << seed << " " << part;
    }
  }
}

}  // namespace
}  // namespace glark::vstree::test
