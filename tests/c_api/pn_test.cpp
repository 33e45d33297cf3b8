// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/c/pn.h>
#include <glark/pn.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <utility>

#include "tests/c_api/shapes.h"

namespace glark::test {
namespace {

TEST(PnInC, TagsAreThoseOfCpp) {
  glark_pn_options options = glark_pn_default_options();
  options.sharpness = 0.5F;
  options.tension = 0.25F;
  const glark_pn_mesh mesh{array(octahedron), array(octahedron_triangles), {}, {}};
  glark_pn_tagged_mesh* tagged = nullptr;
  glark_error error;
  ASSERT_EQ(GLARK_SUCCESS, glark_pn_derive_tags(&mesh, &options, &tagged, &error)) << error.message;
  const pn::TaggedMesh same =
      pn::derive_tags({octahedron, octahedron_triangles}, {.sharpness = 0.5F, .tension = 0.25F});
  EXPECT_EQ(same.positions, copy(glark_pn_positions(tagged)));
  EXPECT_EQ(same.normals, copy(glark_pn_normals(tagged)));
  EXPECT_EQ(same.discontinuities, copy(glark_pn_discontinuities(tagged)));
  EXPECT_EQ(same.tags, copy(glark_pn_tags(tagged)));
  EXPECT_EQ(same.triangles, copy(glark_pn_triangles(tagged)));
  EXPECT_EQ(same.triangle_sources, copy(glark_pn_triangle_sources(tagged)));
  EXPECT_EQ(same.crease_vertices, glark_pn_crease_vertices(tagged));
  EXPECT_EQ(same.corners, glark_pn_corners(tagged));
  const std::vector<std::uint32_t> sources = copy(glark_pn_sources(tagged));
  ASSERT_EQ(2 * same.sources.size(), sources.size());
  EXPECT_EQ(same.sources.back()[1], sources.back());
  glark_pn_tagged_mesh_free(tagged);
}

TEST(PnInC, ASampleIsThatOfCpp) {
  glark_pn_corner corners[3] = {};
  std::array<pn::Corner, 3> same;
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i].position[i] = corners[i].normal[i] = 1;
    corners[i].discontinuity[3] = 1;
    corners[i].tags[0] = 0.25F;
    same.at(i) = {.position = {}, .normal = {}, .tags = {0.25F, 0, 0}};
    same.at(i).position.at(i) = same.at(i).normal.at(i) = 1;
  }
  const double middle[3] = {0.5, 0.25, 0.25};
  glark_pn_sample sample;
  ASSERT_EQ(GLARK_SUCCESS, glark_pn_evaluate(corners, middle, &sample, nullptr));
  const pn::Sample expected = pn::evaluate(same, {0.5, 0.25, 0.25});
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(expected.position.at(i), sample.position[i]);
    EXPECT_EQ(expected.normal.at(i), sample.normal[i]);
  }
}

TEST(PnInC, ASampleOfNumbersThatAreNotFiniteIsRefused) {
  glark_pn_corner corners[3] = {};
  const double middle[3] = {0.5, 0.25, 0.25};
  glark_pn_sample sample{{7, 7, 7}, {7, 7, 7}};
  glark_error error;
  const auto refused = [&](float& number, const char* said) {
    for (const float bad : {INFINITY, -INFINITY, NAN}) {
      const float before = std::exchange(number, bad);
      EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_pn_evaluate(corners, middle, &sample, &error)) << said;
      EXPECT_NE(nullptr, std::strstr(error.message, said)) << error.message;
      EXPECT_EQ(GLARK_PN_VERTEX, error.element);
      number = before;
    }
  };
  refused(corners[0].position[2], "vertex 0 has the position");
  refused(corners[1].normal[0], "vertex 1 has the normal");
  refused(corners[2].discontinuity[3], "vertex 2 has the discontinuity");
  refused(corners[2].tags[1], "vertex 2 has the tag");
  for (const double bad : {0.75, double{NAN}, double{INFINITY}}) {
    const double weights[3] = {bad, 0.25, 0.25};
    EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_pn_evaluate(corners, weights, &sample, &error));
    EXPECT_EQ(GLARK_PN_ARRAY, error.element) << error.message;
  }
  const double outside[3] = {2, -0.5, -0.5};
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_pn_evaluate(corners, outside, &sample, &error));
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_pn_evaluate(nullptr, middle, &sample, &error));
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_pn_evaluate(corners, nullptr, &sample, &error));
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_pn_evaluate(corners, middle, nullptr, &error));
  EXPECT_EQ(7, sample.position[0]);
}

TEST(PnInC, AnErrorNamesTheElement) {
  const std::vector<std::uint32_t> beyond = {0, 1, 2, 0, 1, 9};
  const glark_pn_mesh mesh{array(octahedron), array(beyond), {}, {}};
  glark_pn_tagged_mesh* tagged = nullptr;
  glark_error error;
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_pn_derive_tags(&mesh, nullptr, &tagged, &error));
  EXPECT_EQ(GLARK_PN_TRIANGLE, error.element) << error.message;
  EXPECT_EQ(1U, error.index);
  EXPECT_EQ(nullptr, tagged);
}

}  // namespace

TEST(PnInC, ANullObjectHasNothing) {
  EXPECT_EQ(0u, glark_pn_positions(nullptr).count);
  EXPECT_EQ(0u, glark_pn_sources(nullptr).count);
  EXPECT_EQ(0u, glark_pn_corners(nullptr));
}

}  // namespace glark::test
