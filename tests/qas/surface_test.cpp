// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "tests/qas/meshes.h"

namespace glark::qas::test {
namespace {

TEST(Surface, OfARegularTetrahedronIsSymmetric) {
  const ControlMesh mesh{
      "tetrahedron", {1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1}, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}};
  Surface surface(mesh.view());
  surface.update(mesh.positions);
  // Valence 3: beta = 3/16, the limit weighs a neighbour 1/5.
  EXPECT_NEAR(surface.limit_positions()[0].x, 0.4F - 0.2F, 1e-6);
  EXPECT_NEAR(surface.limit_normals()[surface.patches()[0].normals[0]].x, std::sqrt(1.0F / 3), 1e-6);
}

}  // namespace
}  // namespace glark::qas::test
