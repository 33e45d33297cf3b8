// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Sheets with two sides that are about as thick as the distance between samples.
#include <gtest/gtest.h>

#include <string>

#include "tests/reconstruct/meshes.h"
#include "tests/reconstruct/thin_shapes.h"

namespace glark::reconstruct::test {
namespace {

struct Case {
  unsigned seed;
  Rotation rotation;
  double shift;
};

// Each case has other grids, another rotation, or both.
std::vector<Case> cases() {
  std::vector<Case> result{{1, upright, 0}, {2, upright, 0.3}};
  for (unsigned seed = 11; seed < 13; ++seed) result.push_back({seed, random_rotation(seed), seed % 2 == 0 ? 0 : 0.3});
  return result;
}

struct Measures {
  double rms = 0;            // of the vertices' heights over the sheet
  double areas[2] = {0, 0};  // of the lower and upper side, over the plane of the sheet
};

// Returns how much longer the way down to the sheet is than the way to its nearest point.
double steepness(const ThinSheet& sheet, double x, double y) {
  constexpr double step = 1e-3;
  const double u = (sheet.height(x + step, y) - sheet.height(x - step, y)) / (2 * step);
  const double v = (sheet.height(x, y + step) - sheet.height(x, y - step)) / (2 * step);
  return std::sqrt(1 + u * u + v * v);
}

Measures measures_of(const Reconstructed& mesh, const ThinSheet& sheet, const Rotation& rotation) {
  Measures result;
  std::vector<std::array<double, 3>> points;
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
    points.push_back(turned_back(rotation, &mesh.positions[i]));
    const auto [x, y, z] = points.back();
    const double off = (std::abs(z) - sheet.height(x, y)) / steepness(sheet, x, y);
    result.rms += off * off / (static_cast<double>(mesh.positions.size()) / 3);
  }
  result.rms = std::sqrt(result.rms);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const auto& a = points[mesh.triangles[t]];
    const auto& b = points[mesh.triangles[t + 1]];
    const auto& c = points[mesh.triangles[t + 2]];
    const double area = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    result.areas[area > 0 ? 1 : 0] += std::abs(area);
  }
  return result;
}

// Expects both sides, within .3 spacings. `area` is that of one side. It may lack a band of 2.5 spacings along its border.
void expect_both_sides(const Reconstructed& mesh, const ThinSheet& sheet, const Case& one, double area) {
  expect_manifold(mesh);
  const Measures measures = measures_of(mesh, sheet, one.rotation);
  EXPECT_LE(measures.rms, 0.3);
  for (const double side : measures.areas) {
    EXPECT_GT(side, area - 5 * (sheet.width + sheet.depth));
    EXPECT_LT(side, area + 5 * (sheet.width + sheet.depth));
  }
}

TEST(ThinSheets, PlatesHaveTwoSidesAtAnyDistance) {
  constexpr double side = 50;
  for (const double apart : {0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 10.0}) {
    for (const Case& one : cases()) {
      SCOPED_TRACE(std::to_string(apart) + " apart, seed " + std::to_string(one.seed));
      const ThinSheet sheet = plates(side, apart);
      const Reconstructed mesh = reconstruct(samples_of(sheet, one.rotation, one.seed, one.shift).points());
      expect_both_sides(mesh, sheet, one, side * side);
      EXPECT_EQ(topology_of(mesh).parts, 2U);
      EXPECT_LT(mesh.noise, 1e-3F);
    }
  }
}

TEST(ThinSheets, EllipsoidsAreClosed) {
  constexpr double width = 70, depth = 50;
  for (const double thickness : {1.0, 2.0, 3.0, 4.0}) {
    for (const Case& one : cases()) {
      SCOPED_TRACE(std::to_string(thickness) + " thick, seed " + std::to_string(one.seed));
      const ThinSheet sheet = ellipsoid(width, depth, thickness);
      const Reconstructed mesh = reconstruct(samples_of(sheet, one.rotation, one.seed, one.shift).points());
      expect_both_sides(mesh, sheet, one, 3.14159 / 4 * width * depth);
      EXPECT_EQ(topology_of(mesh).parts, 1U);
      if (thickness > 1) {
        EXPECT_EQ(topology_of(mesh).boundary, 0U);
      }
    }
  }
}

TEST(ThinSheets, WingsAreOnePart) {
  constexpr double chord = 30, span = 90;
  for (const double thickness : {2.0, 3.0, 4.0}) {
    for (const Case& one : cases()) {
      SCOPED_TRACE(std::to_string(thickness) + " thick, seed " + std::to_string(one.seed));
      const ThinSheet sheet = wing(chord, span, thickness);
      const Reconstructed mesh = reconstruct(samples_of(sheet, one.rotation, one.seed, one.shift).points());
      expect_both_sides(mesh, sheet, one, 3.14159 / 4 * chord * span);
      EXPECT_EQ(topology_of(mesh).parts, 1U);
    }
  }
}

// The gap between two blocks is as narrow as a plate is thin. It must stay open.
TEST(ThinSheets, NarrowGapsStayOpen) {
  constexpr double side = 50;
  for (const double apart : {0.5, 1.0, 2.0}) {
    for (const Case& one : cases()) {
      SCOPED_TRACE(std::to_string(apart) + " apart, seed " + std::to_string(one.seed));
      const ThinSheet sheet = plates(side, apart);
      Shape shape = samples_of(sheet, one.rotation, one.seed, one.shift);
      for (float& number : shape.normals) number = -number;
      const Reconstructed mesh = reconstruct(shape.points());
      expect_both_sides(mesh, sheet, one, side * side);
      EXPECT_EQ(topology_of(mesh).parts, 2U);
    }
  }
}

TEST(ThinSheets, DependOnNoThreads) {
  const Shape shape = samples_of(wing(40, 80, 2), random_rotation(5), 5, 0.3);
  const Reconstructed one = reconstruct(shape.points(), {.threads = 1});
  const Reconstructed several = reconstruct(shape.points(), {.threads = 4});
  EXPECT_EQ(one.positions, several.positions);
  EXPECT_EQ(one.triangles, several.triangles);
}

}  // namespace
}  // namespace glark::reconstruct::test
