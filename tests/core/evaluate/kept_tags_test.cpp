// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Tags of the vertices shape kept refined vertices: depth tags choose the patterns, scalar tags the surface. After each
// change of a tag, the picture is another one.
#include <gtest/gtest.h>

#include <functional>

#include "tests/core/evaluate/kept_pictures.h"
#include "tests/core/evaluate/shape_ball.h"

namespace glark::core::test {
namespace {

constexpr int seen_pixels = 40;

class KeptTags : public testing::Test {
 protected:
  KeptTags() { refine_uniformly(4, GL_SCALAR_TAGGED_PN_ARK); }
  Picture settled() {
    return expect_same_picture([this] { ball_.draw(); });
  }
  void expect_seen(const std::function<void()>& change) {
    const Picture before = settled();
    change();
    EXPECT_GT(differing_pixels(before, settled()), seen_pixels);
  }
  void tag_depths() const {
    glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK);
    glEnable(GL_DEPTH_TAG_ARRAY_ARK);
  }

  OsmesaContext context_{Profile::compatibility};
  ShapeBall ball_;
};

TEST_F(KeptTags, DiscontinuitiesAreWritten) {
  expect_seen([this] {
    for (ShapeVertex& vertex : ball_.vertices()) vertex.discontinuity = {0, 0, 0, 1};
    ball_.write();
  });
}

TEST_F(KeptTags, ScalarTagsAreWritten) {
  expect_seen([this] {
    for (ShapeVertex& vertex : ball_.vertices()) vertex.scalars = {1, -0.8F, 0};
    ball_.write();
  });
}

TEST_F(KeptTags, CurrentTagsOfAllVertices) {
  glDisableVertexAttribArray(ShapeBall::scalar_location);
  glVertexAttrib3f(ShapeBall::scalar_location, 0, 0, 0);
  expect_seen([] { glVertexAttrib3f(ShapeBall::scalar_location, 0, 1, 0); });
}

TEST_F(KeptTags, OtherArraysAsTags) {
  expect_seen([] {
    glVertexAttribPointer(ShapeBall::scalar_location, 3, GL_FLOAT, GL_FALSE, sizeof(ShapeVertex),
                          byte_offset(offsetof(ShapeVertex, position)));
  });
}

TEST_F(KeptTags, OtherAttributesAsTags) {
  expect_seen([] { glARKParameteriARK(GL_DISCONTINUITY_ATTRIBUTE_ARK, ShapeBall::scalar_location - 1); });
}

TEST_F(KeptTags, DepthsOfEdges) {
  tag_depths();
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);  // shows the patterns
  settled();
  EXPECT_NE(generated_primitives, 8U << 6U);
  expect_seen([this] {
    for (ShapeVertex& vertex : ball_.vertices()) vertex.tag = vertex.position[2] > 0 ? 4 : 0;
    ball_.write();
  });
}

TEST_F(KeptTags, DepthsWithEachInterior) {
  glARKinit(6);
  tag_depths();
  for (ShapeVertex& vertex : ball_.vertices()) vertex.tag = vertex.position[0] > 0 ? 6 : 0;
  ball_.write();
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  expect_seen([] { glARKParameteriARK(GL_PATTERN_INTERIOR_ARK, GL_SMOOTH_INTERIOR_ARK); });
}

TEST_F(KeptTags, DepthsOfAnotherPool) {
  tag_depths();
  for (ShapeVertex& vertex : ball_.vertices()) vertex.tag = 4;
  ball_.write();
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  expect_seen([] { glARKinit(2); });
}

// The order of the triangles shows where they blend.
TEST_F(KeptTags, DepthsKeepTheOrderOfTriangles) {
  tag_depths();
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE_MINUS_DST_COLOR, GL_ONE_MINUS_SRC_COLOR);
  settled();
}

TEST_F(KeptTags, DepthsAndRestart) {
  tag_depths();
  glEnable(GL_PRIMITIVE_RESTART);
  for (const GLuint index : {3U, 17U, 60U}) {
    glPrimitiveRestartIndex(index);
    settled();
  }
}

TEST_F(KeptTags, DepthsByGeomorphing) {
  tag_depths();
  glARKParameteriARK(GL_GEOMORPH_ARK, GL_TRUE);
  settled();
}

// Levels from 9 on consist of tiles.
TEST_F(KeptTags, DeepLevels) {
  const GLuint buffer = make_buffer(GL_ARRAY_BUFFER, std::vector<GLfloat>{-1, -1, 0, 1, -1, 0.5F, 0, 1, -0.5F});
  glVertexPointer(3, GL_FLOAT, 0, nullptr);
  glDisableClientState(GL_NORMAL_ARRAY);
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  glDisable(GL_LIGHTING);
  refine_uniformly(9, GL_LINEAR_INPUTS_ARK);
  expect_same_picture([] { glDrawArrays(GL_TRIANGLES, 0, 3); });
  EXPECT_EQ(generated_primitives, 1U << 18U);
  glDeleteBuffers(1, &buffer);
}

}  // namespace
}  // namespace glark::core::test
