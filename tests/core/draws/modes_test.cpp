// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Every mode of triangles, through glBegin, client arrays, buffers and display lists.
#include "tests/core/support/modes.h"
#include "tests/core/support/programs.h"
#include "tests/core/support/scene.h"

namespace glark::core::test {
namespace {

class DrawsModes : public testing::TestWithParam<ModeShape> {
 protected:
  OsmesaContext context_{Profile::compatibility};
  SameScene expected_{.coarse_triangles = GetParam().triangles};
};

std::string name_of(const testing::TestParamInfo<ModeShape>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(All, DrawsModes, testing::ValuesIn(mode_shapes()), name_of);

TEST_P(DrawsModes, Immediate) {
  expect_same_scene(expected_, [] { draw_immediate(GetParam()); });
}

TEST_P(DrawsModes, ImmediateWithInputsRefined) {
  expected_.refinement = GL_LINEAR_INPUTS_ARK;
  expect_same_scene(expected_, [] { draw_immediate(GetParam()); });
}

TEST_P(DrawsModes, ImmediateArrayElement) {
  point_conventional_arrays(GetParam().vertices.data());
  expect_same_scene(expected_, [] {
    glBegin(GetParam().mode);
    for (std::size_t i = 0; i < GetParam().vertices.size(); ++i) glArrayElement(static_cast<GLint>(i));
    glEnd();
  });
}

TEST_P(DrawsModes, ClientArrays) {
  point_conventional_arrays(GetParam().vertices.data());
  expect_same_scene(expected_,
                    [] { glDrawArrays(GetParam().mode, 0, static_cast<GLsizei>(GetParam().vertices.size())); });
}

TEST_P(DrawsModes, InterleavedClientArraysFromTheSecondVertex) {
  std::vector<GLfloat> data(6);  // a vertex of C3F_V3F that is not drawn
  for (const ColoredVertex& v : GetParam().vertices) {
    data.insert(data.end(), {v.color[0], v.color[1], v.color[2], v.position[0], v.position[1], 0});
  }
  glInterleavedArrays(GL_C3F_V3F, 0, data.data());
  expect_same_scene(expected_,
                    [] { glDrawArrays(GetParam().mode, 1, static_cast<GLsizei>(GetParam().vertices.size())); });
}

TEST_P(DrawsModes, VertexBuffer) {
  make_buffer(GL_ARRAY_BUFFER, GetParam().vertices);
  point_conventional_arrays(nullptr);
  expect_same_scene(expected_,
                    [] { glDrawArrays(GetParam().mode, 0, static_cast<GLsizei>(GetParam().vertices.size())); });
}

TEST_P(DrawsModes, ListCompiledBeforeTheFirstDraw) {
  glARKinit(2);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  draw_immediate(GetParam());
  glEndList();
  expect_same_scene(expected_, [list] { glCallList(list); });
}

TEST_P(DrawsModes, FlatShadingUnderBothConventions) {
  glShadeModel(GL_FLAT);
  for (const GLenum convention : {GL_LAST_VERTEX_CONVENTION, GL_FIRST_VERTEX_CONVENTION}) {
    SCOPED_TRACE(convention);
    glProvokingVertex(convention);
    for (const GLenum refinement : {GL_LINEAR_OUTPUTS_ARK, GL_LINEAR_INPUTS_ARK}) {
      expected_.refinement = refinement;
      expect_same_scene(expected_, [] { draw_immediate(GetParam()); });
    }
  }
}

}  // namespace
}  // namespace glark::core::test
