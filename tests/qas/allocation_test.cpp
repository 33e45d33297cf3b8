// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A frame allocates nothing.
#include <gtest/gtest.h>

#include "tests/common/allocations.h"
#include "tests/qas/meshes.h"

namespace glark::qas::test {
namespace {

TEST(Allocation, NoneInAFrame) {
  const ControlMesh mesh = densified(blocks(), 3);
  for (const unsigned threads : {1U, 2U}) {
    for (const unsigned which : {0U, 1U, 2U, 3U}) {
      const unsigned splits = which % 2;
      const Scheme scheme = which < 2 ? Scheme::loop : Scheme::modified_butterfly;
      const int before_all = glark::test::allocations();
      Surface surface(mesh.view(), {.scheme = scheme, .splits = splits, .threads = threads});
      EXPECT_GT(glark::test::allocations(), before_all) << "allocations are not counted";
      std::vector<Corner> corners(surface.corner_count());
      std::vector<QuarticCorner> quartic_corners(surface.quartic_corner_count());
      surface.update(mesh.positions);
      surface.write_corners(corners);
      const int before = glark::test::allocations();
      surface.update(mesh.positions);
      surface.write_corners(corners);
      surface.write_quartic_corners(quartic_corners);
      EXPECT_EQ(glark::test::allocations(), before) << "threads " << threads << " splits " << splits;
    }
  }
}

}  // namespace
}  // namespace glark::qas::test
