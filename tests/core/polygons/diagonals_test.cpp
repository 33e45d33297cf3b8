// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A quad whose four colours are not linear shows along which diagonal it was cut. A refined quad is cut along the
// diagonal along which GL draws it: with and without indices, in lists, under both conventions, smooth and flat.
//
// Plan: the picture without refinement is the control. The two diagonals differ in most pixels of the quad.
#include "tests/core/support/modes.h"
#include "tests/core/support/scene.h"
#include "tests/core/support/state_snapshot.h"

namespace glark::core::test {
namespace {

constexpr GLfloat side = 0.8F;
const ModeShape quads{
    "quads",
    GL_QUADS,
    2,
    {{{-side, -side}, {1, 0, 0}}, {{side, -side}, {0, 1, 0}}, {{side, side}, {1, 0, 1}}, {{-side, side}, {0, 1, 1}}}};
const ModeShape strip{
    "strip", GL_QUAD_STRIP, 2, {quads.vertices[0], quads.vertices[1], quads.vertices[3], quads.vertices[2]}};

struct Drawing {
  const char* name;
  void (*draw)(const ModeShape&);
};

void draw_arrays(const ModeShape& shape) {
  point_conventional_arrays(shape.vertices.data());
  glDrawArrays(shape.mode, 0, 4);
}

void draw_elements(const ModeShape& shape) {
  const GLubyte numbers[] = {0, 1, 2, 3};
  point_conventional_arrays(shape.vertices.data());
  glDrawElements(shape.mode, 4, GL_UNSIGNED_BYTE, numbers);
}

void draw_list(const ModeShape& shape) {
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  draw_immediate(shape);
  glEndList();
  glCallList(list);
  glDeleteLists(list, 1);
}

const Drawing drawings[] = {
    {"immediate", draw_immediate}, {"arrays", draw_arrays}, {"elements", draw_elements}, {"list", draw_list}};

std::ostream& operator<<(std::ostream& out, const Drawing& drawing) { return out << drawing.name; }

class Diagonals : public testing::TestWithParam<Drawing> {
 protected:
  static Picture picture(const ModeShape& shape) {
    glClear(GL_COLOR_BUFFER_BIT);
    GetParam().draw(shape);
    return read_picture();
  }
  static void expect_same(const ModeShape& shape) {
    glDisable(GL_ARK);
    const Picture plain = picture(shape);
    refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
    EXPECT_LE(differing_pixels(plain, picture(shape)), tolerated_pixels) << shape.name;
    EXPECT_EQ(pending_errors(), "");
  }

  OsmesaContext context_{Profile::compatibility};
};

std::string name_of(const testing::TestParamInfo<Drawing>& drawing) { return drawing.param.name; }
INSTANTIATE_TEST_SUITE_P(All, Diagonals, testing::ValuesIn(drawings), name_of);

TEST_P(Diagonals, AreThoseThatGlDraws) {
  for (const GLenum convention : {GL_LAST_VERTEX_CONVENTION, GL_FIRST_VERTEX_CONVENTION}) {
    SCOPED_TRACE(convention);
    glProvokingVertex(convention);
    for (const GLenum shading : {GL_SMOOTH, GL_FLAT, GL_SMOOTH}) {
      SCOPED_TRACE(shading);
      glShadeModel(shading);
      expect_same(quads);
      expect_same(strip);
    }
  }
}

TEST_P(Diagonals, DoNotDependOnTheStateOfTheFirstDraw) {
  glViewport(7, 9, 100, 90);
  glScissor(30, 30, 60, 60);
  glEnable(GL_SCISSOR_TEST);
  glEnable(GL_CLIP_PLANE2);
  const GLdouble right_half[] = {1, 0, 0, 0};
  glClipPlane(GL_CLIP_PLANE2, right_half);
  glDepthFunc(GL_NEVER);
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  glEnable(GL_DEPTH_TEST);
  picture(quads);  // the first draw of its kind
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CLIP_PLANE2);
  expect_same(quads);
}

TEST_P(Diagonals, AreFoundWithoutATrace) {
  const StateSnapshot::Names names = StateSnapshot::find_names();
  glARKinit(2);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glEnable(GL_DEPTH_TEST);
  GLuint samples = 0;
  glGenQueries(1, &samples);
  const auto counted = [&] {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBeginQuery(GL_SAMPLES_PASSED, samples);
    GetParam().draw(quads);
    glEndQuery(GL_SAMPLES_PASSED);
    GLuint count = 0;
    glGetQueryObjectuiv(samples, GL_QUERY_RESULT, &count);
    return count;
  };
  const GLuint plain = counted();
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  const StateSnapshot before = StateSnapshot::take(names);
  EXPECT_EQ(counted(), plain);
  EXPECT_EQ(StateSnapshot::take(names).difference(before), "");
  EXPECT_EQ(pending_errors(), "");
}

}  // namespace
}  // namespace glark::core::test
