// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/common/mesh/rounded_places.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace glark::common::test {
namespace {

// A closed cylinder without lids: the last column of points is the first one again, with other rounding errors. The
// radius is `radius`, the height 1.
struct Cylinder {
  std::vector<float> positions;
  std::vector<std::uint32_t> triangles;

  Cylinder(std::uint32_t columns, float radius, double angle_at_seam) {
    for (std::uint32_t i = 0; i <= columns; ++i) {
      const double angle = angle_at_seam + 6.283185307179586 * i / columns;
      for (const float height : {0.0F, 1.0F})
        positions.insert(positions.end(), {radius * static_cast<float>(std::cos(angle)),
                                           radius * static_cast<float>(std::sin(angle)), height});
      if (i == columns) continue;
      const std::uint32_t a = 2 * i;
      triangles.insert(triangles.end(), {a, a + 2, a + 3, a, a + 3, a + 1});
    }
  }

  bool is_closed() const { return std::equal(positions.begin(), positions.begin() + 6, positions.end() - 6); }
};

TEST(RoundedPlaces, SeamsClose) {
  for (const double angle : {0.0, 0.3, 1.0, 1.5707963267948966, 2.5, 4.0, 5.5}) {
    for (const float radius : {0.3F, 1.0F, 1000.0F}) {
      Cylinder cylinder(24, radius, angle);
      cylinder.positions[3 * 48] = std::nextafter(cylinder.positions[0], 2 * radius);
      cylinder.positions[3 * 49 + 1] = std::nextafter(cylinder.positions[4], -2 * radius);
      EXPECT_FALSE(cylinder.is_closed());
      EXPECT_GE(join_rounded_places(cylinder.positions, cylinder.triangles), 1U);
      EXPECT_TRUE(cylinder.is_closed()) << angle << ' ' << radius;
    }
  }
}

// Boundaries that are as near as the scans of a wide site have them stay apart, and so do points within the surface.
TEST(RoundedPlaces, OtherPointsStay) {
  Cylinder open(24, 1, 0.3);
  for (std::size_t i = 0; i < 6; ++i) open.positions[open.positions.size() - 6 + i] += 4e-6F;
  const std::vector<float> before = open.positions;
  EXPECT_EQ(join_rounded_places(open.positions, open.triangles), 0U);
  EXPECT_EQ(open.positions, before);
  // A tetrahedron with a corner that is split by 1e-8: no edge is at the boundary.
  std::vector<float> closed = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1e-8F};
  const std::vector<float> same = closed;
  EXPECT_EQ(join_rounded_places(closed, std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}), 0U);
  EXPECT_EQ(closed, same);
}

TEST(RoundedPlaces, NothingToJoin) {
  std::vector<float> none;
  EXPECT_EQ(join_rounded_places(none, {}), 0U);
  std::vector<float> one_place(9, 2.0F);
  EXPECT_EQ(join_rounded_places(one_place, std::vector<std::uint32_t>{0, 1, 2}), 0U);
}

}  // namespace
}  // namespace glark::common::test
