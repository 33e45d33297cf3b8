// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/cull/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/surfel/clouds.h"
#include "tests/surfel/cull/views.h"

namespace glark::surfel::test {
namespace {

// At the border of a wide view, spheres are larger than in its middle.
TEST(SurfelCamera, ProjectedDiameterIsATightUpperBound) {
  const View view{.clip_from_object = perspective(0, 0, 0, 2), .width = 400, .height = 400};
  const Camera camera(view);
  constexpr float radius = 0.01F;
  for (const float x : {0.0F, 1.0F, -1.9F}) {
    std::array<float, 2> low{1e9F, 1e9F}, high{-1e9F, -1e9F};
    const Points on_sphere = sphere(5000);
    for (std::size_t i = 0; i < on_sphere.size(); ++i) {
      const float* const d = &on_sphere.positions[3 * i];
      const std::array<float, 3> at = {x + radius * d[0], 0.5F + radius * d[1], -1 + radius * d[2]};
      const auto place = clip(view.clip_from_object, at.data());
      for (std::size_t k = 0; k < 2; ++k) {
        low[k] = std::min(low[k], 200 * place[k] / place[3]);
        high[k] = std::max(high[k], 200 * place[k] / place[3]);
      }
    }
    const float size = std::max(high[0] - low[0], high[1] - low[1]);
    const float bound = camera.projected_diameter({x, 0.5F, -1}, radius);
    EXPECT_GE(bound, size * 0.999F);
    EXPECT_LE(bound, size * 1.05F);
  }
  EXPECT_TRUE(std::isinf(camera.projected_diameter({0, 0, -0.5F * radius}, radius)));
}

}  // namespace
}  // namespace glark::surfel::test
