// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// GL_POLYGON_CENTROID_ARK in the picture: planar polygons look the same, and polygons that cannot be split stay
// triangles.
#include <algorithm>
#include <cmath>

#include "tests/core/support/modes.h"
#include "tests/core/support/programs.h"
#include "tests/core/support/scene.h"
#include "tests/core/support/state_snapshot.h"

namespace glark::core::test {
namespace {

struct PolygonScene {
  const char* name;
  GLuint sides;  // of all polygons
  ModeShape shape;
};

std::ostream& operator<<(std::ostream& out, const PolygonScene& scene) { return out << scene.name; }

std::string name_of(const testing::TestParamInfo<PolygonScene>& scene) { return scene.param.name; }

ModeShape planar(ModeShape shape) {
  std::transform(shape.vertices.begin(), shape.vertices.end(), shape.vertices.begin(), affine);
  return shape;
}

PolygonScene quads() { return {"quads", 8, mode_shapes()[3]}; }
PolygonScene quad_strip() { return {"quad_strip", 8, mode_shapes()[4]}; }
PolygonScene polygon() { return {"polygon", 6, planar(mode_shapes()[5])}; }

class CentroidPictures : public testing::TestWithParam<PolygonScene> {
 protected:
  CentroidPictures() { glARKParameteriARK(GL_POLYGON_SPLIT_ARK, GL_POLYGON_CENTROID_ARK); }
  // Calls expect_same_scene() for so many triangles about centroids.
  template <typename Draw>
  void expect_split(GLuint sides, Draw&& draw) {
    for (const GLenum refinement : {GL_LINEAR_INPUTS_ARK, GL_LINEAR_OUTPUTS_ARK}) {
      expect_same_scene({sides, refinement, 0}, draw);
      expect_same_scene({sides, refinement, 2}, draw);
    }
  }
  template <typename Draw>
  void expect_triangles(GLuint triangles, Draw&& draw) {
    expect_same_scene({triangles, GL_LINEAR_INPUTS_ARK, 1}, draw);
  }
  OsmesaContext context_{Profile::compatibility};
};

INSTANTIATE_TEST_SUITE_P(All, CentroidPictures, testing::Values(quads(), quad_strip(), polygon()), name_of);

class CentroidDraws : public CentroidPictures {};
INSTANTIATE_TEST_SUITE_P(All, CentroidDraws, testing::Values(quads()), name_of);

TEST_P(CentroidPictures, Immediate) {
  const ModeShape& shape = GetParam().shape;
  expect_split(GetParam().sides, [&] { draw_immediate(shape); });
  glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
  expect_split(GetParam().sides, [&] { draw_immediate(shape); });
}

TEST_P(CentroidPictures, ClientArrays) {
  const ModeShape& shape = GetParam().shape;
  point_conventional_arrays(shape.vertices.data());
  expect_split(GetParam().sides, [&] { glDrawArrays(shape.mode, 0, static_cast<GLsizei>(shape.vertices.size())); });
}

// Kept captures: the third draw of the same buffer reads what the second one captured.
TEST_P(CentroidPictures, BufferThatIsKept) {
  const ModeShape& shape = GetParam().shape;
  make_buffer(GL_ARRAY_BUFFER, shape.vertices);
  point_conventional_arrays(nullptr);
  for (int i = 0; i < 3; ++i) {
    expect_split(GetParam().sides, [&] { glDrawArrays(shape.mode, 0, static_cast<GLsizei>(shape.vertices.size())); });
  }
}

TEST_P(CentroidPictures, DisplayListOfArraysAndImmediate) {
  const ModeShape& shape = GetParam().shape;
  glARKinit(2);
  point_conventional_arrays(shape.vertices.data());
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  draw_immediate(shape);
  glScalef(0.5F, 0.5F, 1);
  glDrawArrays(shape.mode, 0, static_cast<GLsizei>(shape.vertices.size()));
  glScalef(2, 2, 1);
  glEndList();
  expect_split(2 * GetParam().sides, [&] { glCallList(list); });
}

TEST_P(CentroidPictures, CurrentTag) {
  const ModeShape& shape = GetParam().shape;
  glARKinit(3);
  glEnable(GL_ARK);
  for (const GLuint tag : {0U, 1U, 3U}) {
    glDepthTag1i(tag);
    picture_of([&] { draw_immediate(shape); });
    EXPECT_EQ(generated_primitives, GetParam().sides << (2 * tag));
    point_conventional_arrays(shape.vertices.data());
    picture_of([&] { glDrawArrays(shape.mode, 0, static_cast<GLsizei>(shape.vertices.size())); });
    EXPECT_EQ(generated_primitives, GetParam().sides << (2 * tag));
  }
}

// The count of a draw that may restart is on the GPU.
TEST_P(CentroidPictures, Restart) {
  const ModeShape& shape = GetParam().shape;
  std::vector<GLushort> indices;
  for (GLushort i = 0; i < shape.vertices.size(); ++i) {
    if (i == 4) indices.push_back(0xFFFF);
    indices.push_back(i == 4 && shape.mode == GL_QUAD_STRIP ? GLushort{2} : i);
    if (i == 4 && shape.mode == GL_QUAD_STRIP) indices.insert(indices.end(), {GLushort{3}, i});
  }
  point_conventional_arrays(shape.vertices.data());
  glEnable(GL_PRIMITIVE_RESTART);
  glPrimitiveRestartIndex(0xFFFF);
  const auto draw = [&] {
    glDrawElements(shape.mode, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_SHORT, indices.data());
  };
  if (shape.mode == GL_POLYGON) {
    expect_triangles(2, draw);  // the polygons between restarts cannot be told apart
  } else {
    expect_split(GetParam().sides, draw);
  }
}

TEST_P(CentroidPictures, RestartWithTags) {
  const ModeShape& shape = GetParam().shape;
  const std::vector<GLubyte> tags(shape.vertices.size(), 2);
  const std::vector<GLushort> indices = {0, 1, 2, 3, 0xFFFF, 2, 3, 4, 5, 0xFFFF, 0, 1};
  point_conventional_arrays(shape.vertices.data());
  glARKinit(3);
  glDepthTagPointerARK(GL_UNSIGNED_BYTE, 0, tags.data());
  glEnable(GL_DEPTH_TAG_ARRAY_ARK);
  glEnable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
  glEnable(GL_ARK);
  picture_of(
      [&] { glDrawElements(shape.mode, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_SHORT, indices.data()); });
  EXPECT_EQ(generated_primitives, (shape.mode == GL_POLYGON ? 4U : 8U) * 16);
}

TEST_P(CentroidPictures, StateIsKept) {
  const ModeShape& shape = GetParam().shape;
  glARKinit(2);
  const StateSnapshot::Names names = StateSnapshot::find_names();
  for (GLuint i = 0; i < 5; ++i)
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, make_buffer(GL_COPY_WRITE_BUFFER, std::vector<GLubyte>(64)));
  make_buffer(GL_ARRAY_BUFFER, shape.vertices);
  point_conventional_arrays(nullptr);
  make_buffer(GL_ARRAY_BUFFER, std::vector<GLubyte>(shape.vertices.size(), 1));
  glDepthTagPointerARK(GL_UNSIGNED_BYTE, 0, nullptr);
  glEnable(GL_DEPTH_TAG_ARRAY_ARK);
  for (const GLenum convention : {GL_LAST_VERTEX_CONVENTION, GL_FIRST_VERTEX_CONVENTION}) {
    glProvokingVertex(convention);
    const auto draw = [&] { glDrawArrays(shape.mode, 0, static_cast<GLsizei>(shape.vertices.size())); };
    const StateSnapshot before_plain = StateSnapshot::take(names);
    draw();
    const std::vector<std::string> own = StateSnapshot::take(names).differing_names(before_plain);
    glEnable(GL_ARK);
    const StateSnapshot before = StateSnapshot::take(names);
    draw();  // finds out how GL decomposes
    EXPECT_EQ(before.difference(StateSnapshot::take(names), own), "");
    glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
    const StateSnapshot before_uniform = StateSnapshot::take(names);
    draw();
    EXPECT_EQ(before_uniform.difference(StateSnapshot::take(names), own), "");
    glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK);
    glDisable(GL_ARK);
  }
  EXPECT_EQ(pending_errors(), "");
}

TEST_P(CentroidPictures, FlatColorsStayTriangles) {
  glShadeModel(GL_FLAT);
  expect_triangles(GetParam().shape.triangles, [&] { draw_immediate(GetParam().shape); });
  glShadeModel(GL_SMOOTH);
  expect_triangles(GetParam().sides, [&] { draw_immediate(GetParam().shape); });
}

TEST_P(CentroidPictures, FlatOutputsStayTriangles) {
  glUseProgram(link_program(
      {.vertex = "#version 130\nflat out vec4 tint; void main() { gl_Position = gl_Vertex; tint = gl_Color; }\n",
       .fragment = "#version 130\nflat in vec4 tint; void main() { gl_FragColor = tint; }\n"}));
  expect_triangles(GetParam().shape.triangles, [&] { draw_immediate(GetParam().shape); });
}

TEST_P(CentroidPictures, VertexNumbersStayTriangles) {
  glUseProgram(link_program({.vertex = "#version 130\nuniform vec2 places[8]; out vec4 tint;\n"
                                       "void main() { gl_Position = vec4(places[gl_VertexID], 0.0, 1.0) + 0.0 * "
                                       "gl_Vertex; tint = vec4(gl_Position.xy + 1.0, 1.0, 1.0); }\n",
                             .fragment = "#version 130\nin vec4 tint; void main() { gl_FragColor = tint; }\n"}));
  GLint program = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &program);
  const ModeShape& shape = GetParam().shape;
  for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
    glUniform2fv(glGetUniformLocation(static_cast<GLuint>(program), ("places[" + std::to_string(i) + "]").c_str()), 1,
                 shape.vertices[i].position.data());
  }
  make_buffer(GL_ARRAY_BUFFER, shape.vertices);
  point_conventional_arrays(nullptr);
  expect_triangles(shape.triangles, [&] { glDrawArrays(shape.mode, 0, static_cast<GLsizei>(shape.vertices.size())); });
}

TEST_P(CentroidPictures, InstancesAreSplit) {
  glUseProgram(
      link_program({.vertex = "#version 140\n#extension GL_ARB_compatibility : enable\nout vec4 tint;\n"
                              "void main() { gl_Position = vec4(0.5 * gl_Vertex.xy + vec2(float(gl_InstanceID) - 0.5), "
                              "0.0, 1.0); tint = gl_Color; }\n",
                    .fragment = "#version 140\nin vec4 tint; out vec4 color; void main() { color = tint; }\n"}));
  const ModeShape& shape = GetParam().shape;
  make_buffer(GL_ARRAY_BUFFER, shape.vertices);
  point_conventional_arrays(nullptr);
  const auto count = static_cast<GLsizei>(shape.vertices.size());
  expect_triangles(2 * GetParam().sides, [=] { glDrawArraysInstanced(shape.mode, 0, count, 2); });
  expect_triangles(GetParam().sides, [=] { glDrawArraysInstanced(shape.mode, 0, count, 1); });
}

TEST_P(CentroidPictures, MultiDrawsAreSplit) {
  const ModeShape& shape = GetParam().shape;
  point_conventional_arrays(shape.vertices.data());
  const GLint first[] = {0, 2};
  const GLsizei count[] = {static_cast<GLsizei>(shape.vertices.size()), 4};
  expect_triangles(GetParam().sides + 4, [=] { glMultiDrawArrays(shape.mode, first, count, 2); });
  expect_triangles(GetParam().sides, [=] { glMultiDrawArrays(shape.mode, first, count, 1); });
}

TEST_P(CentroidPictures, MultiDrawsInAList) {
  const ModeShape& shape = GetParam().shape;
  glARKinit(2);
  point_conventional_arrays(shape.vertices.data());
  const GLint first[] = {0, 2};
  const GLsizei count[] = {static_cast<GLsizei>(shape.vertices.size()), 4};
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glMultiDrawArrays(shape.mode, first, count, 2);
  glEndList();
  expect_split(GetParam().sides + 4, [=] { glCallList(list); });
}

TEST_P(CentroidPictures, IndirectDraws) {
  const ModeShape& shape = GetParam().shape;
  make_buffer(GL_ARRAY_BUFFER, shape.vertices);
  point_conventional_arrays(nullptr);
  const auto count = static_cast<GLuint>(shape.vertices.size());
  make_buffer(GL_DRAW_INDIRECT_BUFFER, std::vector<GLuint>{count, 1, 0, 0, 4, 1, 2, 0});
  expect_triangles(GetParam().sides, [&] { glDrawArraysIndirect(shape.mode, nullptr); });
  expect_triangles(GetParam().sides + 4, [&] { glMultiDrawArraysIndirect(shape.mode, nullptr, 2, 0); });
}

TEST_P(CentroidDraws, TrianglesStay) {
  expect_triangles(4, [] { draw_immediate(mode_shapes()[1]); });
}

// There are more vertices than a driver keeps in one piece between glBegin and glEnd.
TEST_P(CentroidDraws, LongStripsAndPolygons) {
  constexpr int columns = 6000;
  expect_split(4 * columns, [] {
    glBegin(GL_QUAD_STRIP);
    for (int i = 0; i <= columns; ++i) {
      const GLfloat x = -0.9F + 1.8F * static_cast<GLfloat>(i) / columns;
      emit(affine({{x, 0.8F}, {}}));
      emit(affine({{x, -0.7F}, {}}));
    }
    glEnd();
  });
  expect_split(columns, [] {
    glBegin(GL_POLYGON);
    for (int i = 0; i < columns; ++i) {
      const GLfloat angle = 6.2831853F * static_cast<GLfloat>(i) / columns;
      emit(affine({{0.9F * std::cos(angle), 0.9F * std::sin(angle)}, {}}));
    }
    glEnd();
  });
}

}  // namespace
}  // namespace glark::core::test
