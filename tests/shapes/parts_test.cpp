// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The generated meshes are what their names say.
#include "tests/shapes/parts.h"

#include <gtest/gtest.h>

#include <map>

namespace glark::shapes {
namespace {

struct Edges {
  std::size_t borders = 0, wrong = 0;  // of one triangle; of more than two, or of two with different orientation
};

Edges edges_of(const Part& part) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> edges;  // uses upwards and downwards
  for (std::size_t i = 0; i < part.triangles.size(); ++i) {
    const std::uint32_t a = part.triangles[i], b = part.triangles[i % 3 == 2 ? i - 2 : i + 1];
    ++(a < b ? edges[{a, b}].first : edges[{b, a}].second);
  }
  Edges result;
  for (const auto& [edge, uses] : edges) {
    if (uses.first + uses.second == 1) {
      ++result.borders;
    } else if (uses.first != 1 || uses.second != 1) {
      ++result.wrong;
    }
  }
  return result;
}

double volume_of(const Part& part) {
  double sum = 0;
  for (std::size_t t = 0; t < part.triangles.size(); t += 3) {
    const auto at = [&](std::size_t i, std::size_t k) {
      return static_cast<double>(part.positions[3 * part.triangles[t + i] + k]);
    };
    for (std::size_t k = 0; k < 3; ++k)
      sum += at(0, k) * (at(1, (k + 1) % 3) * at(2, (k + 2) % 3) - at(1, (k + 2) % 3) * at(2, (k + 1) % 3)) / 6;
  }
  return sum;
}

TEST(Parts, MachinePartsAreClosedAndFaceOutwards) {
  for (const NamedPart& named : machine_parts) {
    for (unsigned seed = 1; seed < 5; ++seed) {
      SCOPED_TRACE(std::string(named.name) + ", seed " + std::to_string(seed));
      const Part part = named.make(seed, 1);
      const Edges edges = edges_of(part);
      EXPECT_EQ(edges.borders, 0U);
      EXPECT_EQ(edges.wrong, 0U);
      EXPECT_GT(volume_of(part), 0.01);
    }
  }
}

TEST(Parts, ABlobIsClosed) {
  const Part part = blob(7, 1);
  EXPECT_EQ(edges_of(part).borders + edges_of(part).wrong, 0U);
  EXPECT_GT(volume_of(part), 1);
}

TEST(Parts, ACoverHasAnOutlineAndTwelveHoles) {
  const Part part = cover(3, 1);
  const Edges edges = edges_of(part);
  EXPECT_EQ(edges.wrong, 0U);
  EXPECT_EQ(edges.borders, 12U * 40U + 14U * 10U);
}

TEST(Parts, PartsOfAnAssemblyShareNoVertices) {
  const Part part = assembly(5, 1);
  EXPECT_EQ(edges_of(part).borders + edges_of(part).wrong, 0U);
}

TEST(Parts, SeedsDiffer) { EXPECT_NE(gear(1, 1).positions, gear(2, 1).positions); }

}  // namespace
}  // namespace glark::shapes
