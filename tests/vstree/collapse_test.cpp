// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Simplification by collapses of edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "glark/clients/common/vector.h"
#include "tests/shapes/parts.h"
#include "tests/vstree/shapes.h"

namespace glark::vstree::test {
namespace {

constexpr SimplifyOptions to(std::size_t target, Method method = Method::collapse) {
  return {.target = target, .threads = 1, .method = method};
}

// A cube with n times n squares on each face. Each face has its own points, with its own normal.
Shape cube(std::uint32_t n) {
  Shape shape;
  for (std::size_t face = 0; face < 6; ++face) {
    const std::size_t axis = face / 2;
    const float side = face % 2 == 0 ? 1.0F : -1.0F;
    const auto first = static_cast<std::uint32_t>(shape.size());
    for (std::uint32_t i = 0; i < (n + 1) * (n + 1); ++i) {
      float point[3] = {}, normal[3] = {};
      const std::uint32_t column = i % (n + 1), row = i / (n + 1);
      point[axis] = normal[axis] = side;
      point[(axis + 1) % 3] = side * (2 * static_cast<float>(column) / static_cast<float>(n) - 1);
      point[(axis + 2) % 3] = 2 * static_cast<float>(row) / static_cast<float>(n) - 1;
      shape.positions.insert(shape.positions.end(), point, point + 3);
      shape.normals.insert(shape.normals.end(), normal, normal + 3);
      if (column == n || row == n) continue;
      const std::uint32_t a = first + i, b = a + 1, c = a + n + 2, d = a + n + 1;
      shape.triangles.insert(shape.triangles.end(), {a, b, c, a, c, d});
    }
  }
  return shape;
}

// Returns twice the area of all triangles of the unit square.
double area_of(const Simplified& few) {
  double sum = 0;
  for (std::size_t t = 0; t < few.triangles.size(); t += 3) {
    const float* const a = &few.positions[3 * few.triangles[t]];
    const float* const b = &few.positions[3 * few.triangles[t + 1]];
    const float* const c = &few.positions[3 * few.triangles[t + 2]];
    sum += (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }
  return sum;
}

Shape square(std::uint32_t n) {
  Shape shape;
  for (std::uint32_t i = 0; i < n * n; ++i) {
    const auto last = static_cast<float>(n - 1);
    const std::uint32_t row = i / n;
    shape.positions.insert(shape.positions.end(),
                           {static_cast<float>(i % n) / last, static_cast<float>(row) / last, 0});
    if (i % n < n - 1 && row < n - 1)
      shape.triangles.insert(shape.triangles.end(), {i, i + 1, i + n + 1, i, i + n + 1, i + n});
  }
  return shape;
}

// The last row and column of a torus are the first ones again, with other rounding errors.
Shape torus_with_seams(std::uint32_t n) {
  const Shape closed = torus(n);
  Shape shape;
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t k = 0; k <= n; ++k) {
      const std::size_t from = i % n * n + k % n;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const float x = closed.positions[3 * from + axis];
        shape.positions.push_back(i == n || k == n ? std::nextafter(x, axis == 0 ? 9.0F : -9.0F) : x);
        shape.normals.push_back(closed.normals[3 * from + axis]);
      }
      if (i == n || k == n) continue;
      const std::uint32_t a = i * (n + 1) + k, b = a + n + 1;
      shape.triangles.insert(shape.triangles.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
  }
  return shape;
}

// No hole is wider than the rounding errors of the surface.
TEST(Collapse, SeamsThatAreOpenByRoundingStayClosed) {
  const Shape shape = torus_with_seams(60);
  const Simplified few = simplify(shape.mesh(), to(600));
  EXPECT_LE(few.triangles.size() / 3, 600U);
  std::map<std::array<long, 3>, std::uint32_t> places;
  std::vector<std::uint32_t> triangles;
  for (const std::uint32_t i : few.triangles) {
    std::array<long, 3> place{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      place[axis] = std::lround(std::floor(1e4F * few.positions[3 * i + axis] + 0.123F));
    triangles.push_back(places.emplace(place, static_cast<std::uint32_t>(places.size())).first->second);
  }
  const EdgeFaults faults = edge_faults(triangles);
  EXPECT_EQ(faults.boundary, 0U);
  EXPECT_EQ(faults.non_manifold, 0U);
}

TEST(Collapsed, ReachesTheTargetAndStaysClosed) {
  const Shape shape = torus(100);
  for (const std::size_t target : {200U, 2000U, 10000U}) {
    const Simplified few = simplify(shape.mesh(), to(target));
    EXPECT_LE(few.triangles.size() / 3, target);
    EXPECT_GE(few.triangles.size() / 3, target - 4);
    EXPECT_EQ(edge_faults(few.triangles).boundary, 0U);
    EXPECT_EQ(few.method, Method::collapse);
    EXPECT_GT(few.error, 0);
  }
}

TEST(Collapsed, HasPointsOfTheInputWithTheirAttributes) {
  Shape shape = torus(60);
  for (std::size_t i = 0; i < shape.size(); ++i)
    shape.colours.insert(shape.colours.end(), {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i >> 8), 3});
  const PointSet points{.positions = shape.positions, .normals = shape.normals, .colours = shape.colours};
  const Simplified few = simplify({points, shape.triangles}, to(500));
  ASSERT_EQ(few.representatives.size(), shape.size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const std::uint32_t r = few.representatives[i];
    if (r == none) continue;
    ++kept;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(few.positions[3 * r + k], shape.positions[3 * i + k]);
      EXPECT_EQ(few.colours[3 * r + k], shape.colours[3 * i + k]);
      EXPECT_NEAR(few.normals[3 * r + k], shape.normals[3 * i + k], 1e-3);
    }
  }
  EXPECT_EQ(kept, few.positions.size() / 3);
}

TEST(Collapsed, ACubeKeepsItsEdgesAndTheirNormals) {
  const Shape shape = cube(8);  // coordinates without rounding, so that the faces meet
  const Simplified few = simplify(shape.mesh(), to(12));
  EXPECT_EQ(few.triangles.size() / 3, 12U);
  EXPECT_EQ(few.positions.size() / 3, 24U);  // three normals at each corner
  for (std::size_t i = 0; i < few.positions.size(); ++i) EXPECT_EQ(std::abs(few.positions[i]), 1);
  for (std::size_t t = 0; t < few.triangles.size(); t += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(few.normals[3 * few.triangles[t] + k], few.normals[3 * few.triangles[t + 1] + k]);
      EXPECT_EQ(few.normals[3 * few.triangles[t] + k], few.normals[3 * few.triangles[t + 2] + k]);
    }
  }
}

TEST(Collapsed, ASquareKeepsItsBoundary) {
  const Shape shape = square(30);
  const Simplified few = simplify({{.positions = shape.positions}, shape.triangles}, to(2));
  EXPECT_EQ(few.triangles.size() / 3, 2U);
  EXPECT_NEAR(area_of(few), 2, 1e-6);
}

// The left half of the square has another chart of the texture.
TEST(Collapsed, ASeamKeepsBothSides) {
  const Shape left = square(21);
  Shape both = left;
  const auto count = static_cast<std::uint32_t>(left.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    both.positions.insert(both.positions.end(), {left.positions[3 * i] + 1, left.positions[3 * i + 1], 0});
    both.texcoords.insert(both.texcoords.end(), {left.positions[3 * i], left.positions[3 * i + 1]});
  }
  for (std::size_t i = 0; i < left.size(); ++i)
    both.texcoords.insert(both.texcoords.end(), {left.positions[3 * i] + 10, left.positions[3 * i + 1]});
  for (const std::uint32_t i : left.triangles) both.triangles.push_back(count + i);
  const Simplified few =
      simplify({{.positions = both.positions, .texcoords = both.texcoords}, both.triangles}, to(100));
  EXPECT_LE(few.triangles.size() / 3, 100U);
  EXPECT_NEAR(area_of(few), 4, 1e-5);
  std::map<float, std::size_t> on_seam;  // by height
  for (std::size_t i = 0; i < few.positions.size() / 3; ++i) {
    const float x = few.positions[3 * i], u = few.texcoords[2 * i];
    EXPECT_TRUE(std::abs(u - x) < 1e-5 || std::abs(u - 9 - x) < 1e-5) << x << " has " << u;
    if (x == 1) ++on_seam[few.positions[3 * i + 1]];
  }
  EXPECT_GE(on_seam.size(), 2U);
  for (const auto& [height, points] : on_seam) EXPECT_EQ(points, 2U) << height;
}

TEST(Collapsed, StopsAtTheMostError) {
  const Shape shape = torus(100);
  std::size_t last = shape.triangles.size();
  for (const float most : {1e-4F, 1e-3F, 1e-2F}) {
    const Simplified few = simplify(shape.mesh(), {.method = Method::automatic, .max_error = most});
    EXPECT_EQ(few.method, Method::collapse);
    EXPECT_LE(few.error, most);
    EXPECT_LT(few.triangles.size(), last);
    last = few.triangles.size();
    // Without a target and a most error, the threshold limits the error.
    EXPECT_EQ(simplify(shape.mesh(), {.threshold = most, .method = Method::collapse}).triangles.size(), last);
  }
  EXPECT_GT(last / 3, 20U);
  const Simplified stopped = simplify(shape.mesh(), {.target = 20, .method = Method::collapse, .max_error = 1e-2F});
  EXPECT_LE(stopped.error, 1e-2F);
  EXPECT_GT(stopped.triangles.size() / 3, 100U);
}

TEST(Collapsed, WithATargetAboveTheInputIsTheInput) {
  const Shape shape = cube(3);
  const Simplified all = simplify(shape.mesh(), to(shape.triangles.size()));
  EXPECT_EQ(all.triangles, shape.triangles);
  EXPECT_EQ(all.positions, shape.positions);
}

TEST(Collapsed, ByTheAutomaticMethodOnlyIfSmall) {
  const Shape small = torus(100), large = torus(320);
  EXPECT_EQ(simplify(small.mesh(), to(1000, Method::automatic)).method, Method::collapse);
  EXPECT_EQ(simplify(large.mesh(), to(1000, Method::automatic)).method, Method::cluster);
  EXPECT_EQ(simplify(small.mesh(), to(1000, Method::cluster)).method, Method::cluster);
  EXPECT_EQ(simplify(small.mesh(), {.method = Method::automatic}).method, Method::cluster);
  EXPECT_EQ(simplify({small.points()}, to(1000)).positions.size() / 3, 1000U);  // points have no edges
}

// The same triangles, each with corners of its own.
shapes::Part soup_of(std::span<const float> positions, std::span<const std::uint32_t> triangles) {
  shapes::Part soup;
  for (const std::uint32_t i : triangles) {
    soup.triangles.push_back(static_cast<std::uint32_t>(soup.triangles.size()));
    soup.positions.insert(soup.positions.end(), &positions[3 * std::size_t{i}], &positions[3 * std::size_t{i}] + 3);
  }
  return soup;
}

TEST(Collapsed, ByTheAutomaticMethodIfClustersTearAWall) {
  for (unsigned seed = 1; seed < 4; ++seed) {
    const shapes::Part pipe = shapes::pipe(seed, 8);
    ASSERT_GT(pipe.triangle_count(), 200000U);
    for (const shapes::Part& part : {pipe, soup_of(pipe.positions, pipe.triangles)}) {
      const Simplified few =
          simplify({{.positions = part.positions}, part.triangles}, to(pipe.triangle_count() / 100, Method::automatic));
      EXPECT_EQ(few.method, Method::collapse);
      EXPECT_LE(few.triangles.size() / 3, pipe.triangle_count() / 100);
    }
  }
  const Shape thick = torus(320);
  const shapes::Part soup = soup_of(thick.positions, thick.triangles);
  EXPECT_EQ(simplify({{.positions = soup.positions}, soup.triangles}, to(1000, Method::automatic)).method,
            Method::cluster);
}

TEST(Collapsed, ByTheAutomaticMethodIfClustersJoinParts) {
  const Shape shape = nested_tori(200);
  const Simplified few = simplify({{.positions = shape.positions}, shape.triangles}, to(5000, Method::automatic));
  EXPECT_EQ(few.method, Method::collapse);
  EXPECT_EQ(parts_of(few), 3U);
  EXPECT_EQ(edge_faults(few.triangles).boundary, 0U);
}

double area_of(std::span<const float> positions, std::span<const std::uint32_t> triangles) {
  const auto point = [&](std::uint32_t i) { return common::vector_at(positions, i); };
  double area = 0;
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const common::Vector3f origin = point(triangles[t]);
    const common::Vector3f a = point(triangles[t + 1]) - origin, b = point(triangles[t + 2]) - origin;
    area += common::length(common::cross(a, b)) / 2;
  }
  return area;
}

// A plate with square windows. Each side has n times n squares, whose corners have whole numbers as coordinates.
Shape plate_with_windows(std::uint32_t n, float thickness) {
  Shape plate;
  const auto is_solid = [n](std::uint32_t x, std::uint32_t y) { return x < n && y < n && !(x % 8 > 3 && y % 8 > 3); };
  const auto corner = [&](std::uint32_t x, std::uint32_t y, bool top) { return 2 * (x * (n + 1) + y) + (top ? 1 : 0); };
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    plate.triangles.insert(plate.triangles.end(), {a, b, c, a, c, d});
  };
  for (std::uint32_t x = 0; x <= n; ++x)
    for (std::uint32_t y = 0; y <= n; ++y)
      for (const float z : {0.0F, thickness})
        plate.positions.insert(plate.positions.end(), {static_cast<float>(x), static_cast<float>(y), z});
  for (std::uint32_t x = 0; x < n; ++x)
    for (std::uint32_t y = 0; y < n; ++y) {
      if (!is_solid(x, y)) continue;
      quad(corner(x, y, true), corner(x + 1, y, true), corner(x + 1, y + 1, true), corner(x, y + 1, true));
      quad(corner(x, y, false), corner(x, y + 1, false), corner(x + 1, y + 1, false), corner(x + 1, y, false));
      const auto wall = [&](std::uint32_t x0, std::uint32_t y0, std::uint32_t x1, std::uint32_t y1) {
        quad(corner(x0, y0, false), corner(x1, y1, false), corner(x1, y1, true), corner(x0, y0, true));
      };
      if (!is_solid(x, y - 1)) wall(x, y, x + 1, y);
      if (!is_solid(x + 1, y)) wall(x + 1, y, x + 1, y + 1);
      if (!is_solid(x, y + 1)) wall(x + 1, y + 1, x, y + 1);
      if (!is_solid(x - 1, y)) wall(x, y + 1, x, y);
    }
  return plate;
}

// A triangle that turns over in a flat face covers another one, or a window.
TEST(Collapsed, FlatFacesWithWindowsKeepTheirArea) {
  for (const float thickness : {0.5F, 2.0F, 5.0F}) {
    const Shape plate = plate_with_windows(52, thickness);
    const double area = area_of(plate.positions, plate.triangles);
    for (const std::size_t part : {2, 4, 8}) {
      const Simplified few =
          simplify({{.positions = plate.positions}, plate.triangles}, to(plate.triangles.size() / 3 / part));
      EXPECT_NEAR(area_of(few.positions, few.triangles) / area, 1, 1e-3) << thickness << " to 1 of " << part;
    }
  }
}

// With four triangles for a plate, its two sides meet. Both stay.
TEST(Collapsed, PlatesWhoseSidesMeetStay) {
  Shape plates;
  constexpr std::uint32_t count = 20;
  for (std::uint32_t k = 0; k < count; ++k) {
    const auto first = static_cast<std::uint32_t>(plates.size());
    for (const float x : {0.0F, 4.0F})
      for (const float y : {0.0F, 3.0F})
        for (const float z : {0.0F, 0.001F})
          plates.positions.insert(plates.positions.end(), {x, y, static_cast<float>(k) + z});
    for (const std::uint32_t i :
         {0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3, 0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1, 2, 3, 7, 2, 7, 6})
      plates.triangles.push_back(first + i);
  }
  const double area = area_of(plates.positions, plates.triangles);
  const Simplified few = simplify({{.positions = plates.positions}, plates.triangles}, to(std::size_t{4} * count));
  EXPECT_GE(few.triangles.size() / 3, std::size_t{4} * count);
  EXPECT_NEAR(area_of(few.positions, few.triangles) / area, 1, 0.01);
}

TEST(Collapsed, RejectsAMostErrorThatClustersCannotKeep) {
  const Shape shape = torus(10);
  EXPECT_THROW(simplify(shape.mesh(), {.method = Method::cluster, .max_error = 0.1F}), Error);
  EXPECT_THROW(simplify(shape.mesh(), {.method = Method::collapse, .max_error = -1}), Error);
}

}  // namespace
}  // namespace glark::vstree::test
