// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glRect and evaluator meshes: GL may refine them or not (11.R "Refined Drawing Commands"). The picture must not
// change.
#include "tests/core/support/modes.h"
#include "tests/core/support/scene.h"

namespace glark::core::test {
namespace {

class RectanglesAndMeshes : public testing::Test {
 protected:
  // The picture with GL_ARK is the picture without it, and the state is kept; the number of triangles is free.
  template <typename Draw>
  void expect_same_picture(Draw&& draw) {
    const Picture plain = picture_of(draw);
    EXPECT_GT(differing_pixels(plain, Picture(plain.size(), 0)), visible_pixels);
    refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
    EXPECT_LE(differing_pixels(plain, picture_of(draw)), tolerated_pixels);
    EXPECT_LE(differing_pixels(plain, picture_of(draw)), tolerated_pixels);
    EXPECT_EQ(pending_errors(), "");
  }
  OsmesaContext context_{Profile::compatibility};
};

TEST_F(RectanglesAndMeshes, Rectangles) {
  const GLshort a[] = {-1, 0};
  const GLshort b[] = {0, 1};
  const GLdouble c[] = {0.1, -0.9};
  const GLdouble d[] = {0.9, -0.1};
  expect_same_picture([&] {
    glColor3f(1, 0, 0);
    glRectf(-0.9F, -0.9F, -0.1F, -0.1F);
    glColor3f(0, 1, 0);
    glRectsv(a, b);
    glColor3f(0, 0, 1);
    glRectdv(c, d);
    glColor3f(1, 1, 0);
    glRecti(0, 0, 1, 1);
  });
}

void set_map() {
  GLfloat points[3][3][3];
  GLfloat colors[2][2][4] = {{{1, 0, 0, 1}, {0, 1, 0, 1}}, {{0, 0, 1, 1}, {1, 1, 1, 1}}};
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) {
      points[y][x][0] = static_cast<GLfloat>(x) - 1.0F;
      points[y][x][1] = static_cast<GLfloat>(y) - 1.0F;
      points[y][x][2] = x == 1 && y == 1 ? 0.9F : 0.0F;
    }
  }
  glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 3, 0, 1, 9, 3, &points[0][0][0]);
  glMap2f(GL_MAP2_COLOR_4, 0, 1, 4, 2, 0, 1, 8, 2, &colors[0][0][0]);
  glEnable(GL_MAP2_VERTEX_3);
  glEnable(GL_MAP2_COLOR_4);
  glMapGrid2f(8, 0, 1, 6, 0, 1);
}

TEST_F(RectanglesAndMeshes, EvaluatorMesh) {
  set_map();
  expect_same_picture([] { glEvalMesh2(GL_FILL, 0, 8, 0, 6); });
}

TEST_F(RectanglesAndMeshes, EvaluatorMeshOfLines) {
  set_map();
  expect_same_picture([] { glEvalMesh2(GL_LINE, 0, 8, 0, 6); });
}

TEST_F(RectanglesAndMeshes, EvaluatorCoordinatesInBegin) {
  set_map();
  expect_same_picture([] {
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i <= 8; ++i) {
      glEvalCoord2f(static_cast<GLfloat>(i) / 8, 0.1F);
      glEvalPoint2(i, 5);
    }
    glEnd();
  });
  EXPECT_EQ(generated_primitives, 16U * 16);
}

// Points and lines have no triangles.
TEST_F(RectanglesAndMeshes, LinesAndPointsStay) {
  glPointSize(20);
  glLineWidth(9);
  expect_same_picture([] {
    glBegin(GL_LINE_LOOP);
    for (const ColoredVertex& vertex : hexagon) emit(vertex);
    glEnd();
    glBegin(GL_POINTS);
    for (const ColoredVertex& vertex : zigzag) emit(vertex);
    glEnd();
  });
  EXPECT_EQ(generated_primitives, 12U);
}

TEST_F(RectanglesAndMeshes, WireframeShowsTheRefinement) {
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  const Picture plain = picture_of([] { draw_immediate(mode_shapes()[0]); });
  refine_uniformly(2);
  EXPECT_GT(differing_pixels(plain, picture_of([] { draw_immediate(mode_shapes()[0]); })), visible_pixels);
}

TEST_F(RectanglesAndMeshes, SelectionAndFeedbackSeeCoarseTriangles) {
  refine_uniformly(2);
  std::vector<GLfloat> buffer(4096);
  glFeedbackBuffer(static_cast<GLsizei>(buffer.size()), GL_2D, buffer.data());
  glRenderMode(GL_FEEDBACK);
  draw_immediate(mode_shapes()[0]);
  EXPECT_EQ(glRenderMode(GL_RENDER), 2 * (2 + 3 * 2));  // a token, a count, three corners
  picture_of([] { draw_immediate(mode_shapes()[0]); });
  EXPECT_EQ(generated_primitives, 2U * 16);
}

}  // namespace
}  // namespace glark::core::test
