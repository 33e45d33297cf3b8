// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Measured draws that are seen from the same place again are not measured again. Each change of what depths depend on is
// seen at once.
#include <functional>
#include <vector>

#include "tests/core/evaluate/kept_pictures.h"
#include "tests/core/support/measured_program.h"

namespace glark::core::test {
namespace {

constexpr GLsizei corners = 24;

std::vector<CurvedVertex> octahedron() {
  std::vector<CurvedVertex> vertices;
  for (int octant = 0; octant < 8; ++octant) {
    const auto sign = [&](int axis) { return (octant >> axis & 1) == 0 ? 1.0F : -1.0F; };
    const bool mirrored = sign(0) * sign(1) * sign(2) < 0;
    for (const int axis : {0, mirrored ? 2 : 1, mirrored ? 1 : 2}) {
      std::array<GLfloat, 3> position{};
      position[static_cast<std::size_t>(axis)] = sign(axis);
      vertices.push_back({position, position, {0.4F, 0.6F, 0.8F}, 0, 0});
    }
  }
  return vertices;
}

class KeptViews : public testing::Test {
 protected:
  KeptViews() {
    glViewport(0, 0, picture_size, picture_size);
    glEnable(GL_DEPTH_TEST);
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    upload(octahedron());
    glDisable(GL_DEPTH_TAG_ARRAY_ARK);
    use(link_measured_program());
    set_view(program_, perspective(3));
    measure_depths(6, 0);
    glARKParameterfARK(GL_SCREEN_ERROR_ARK, 0.5F);
    glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
    glARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  }
  void use(GLuint program) {
    program_ = program;
    glUseProgram(program);
  }
  static void draw() {
    glClear(GL_DEPTH_BUFFER_BIT);
    glDrawArrays(GL_TRIANGLES, 0, corners);
  }
  // The same values again: nothing of the draw is kept any more.
  static void write_vertices() { upload(octahedron()), glDisable(GL_DEPTH_TAG_ARRAY_ARK); }

  // The passes that measure submit vertices, too.
  static GLuint64 measured_vertices() {
    write_vertices();
    for (int i = 0; i < 3; ++i) draw();
    return submitted_vertices(draw);
  }
  static void settle_view() {
    const GLuint64 measured = measured_vertices();
    repeat_often(draw);
    repeat_often(draw);
    EXPECT_LT(submitted_vertices(draw), measured) << "the draw is measured each time";
  }
  // After `change`, the draw has the triangles that it has where nothing is kept, and it is kept again.
  static void expect_measured(const std::function<void()>& change) {
    settle_view();
    picture_of(draw);
    const GLuint before = generated_primitives;
    change();
    const Picture changed = picture_of(draw);
    const GLuint triangles = generated_primitives;
    EXPECT_NE(triangles, before) << "the change does not show";
    write_vertices();
    EXPECT_EQ(differing_pixels(changed, picture_of(draw)), 0);
    EXPECT_EQ(generated_primitives, triangles);
    EXPECT_EQ(pending_errors(), "");
  }

  OsmesaContext context_{Profile::compatibility};
  GLuint program_ = 0;
};

TEST_F(KeptViews, SamePicture) {
  for (const bool culled : {false, true}) {
    if (culled) glEnable(GL_CULL_FACE);
    write_vertices();
    const Picture first = picture_of(draw);
    const GLuint triangles = generated_primitives;
    settle_view();
    EXPECT_EQ(differing_pixels(first, picture_of(draw)), 0);
    EXPECT_EQ(generated_primitives, triangles);
  }
}

TEST_F(KeptViews, ACameraThatMoves) {
  expect_measured([&] { set_view(program_, perspective(12)); });
  expect_measured([&] {
    glProgramUniformMatrix4fv(program_, glGetUniformLocation(program_, "view"), 1, GL_FALSE, perspective(3).data());
  });
}

TEST_F(KeptViews, UniformsThatBendTheSurface) {
  expect_measured([&] { glUniform1f(glGetUniformLocation(program_, "bend"), 0.6F); });
}

TEST_F(KeptViews, UniformsFromADisplayList) {
  glNewList(1, GL_COMPILE);
  set_view(program_, perspective(12));
  glEndList();
  expect_measured([] { glCallList(1); });
  expect_measured([&] { set_view(program_, perspective(3)); });
}

TEST_F(KeptViews, TheViewport) {
  expect_measured([] { glViewport(0, 0, picture_size / 4, picture_size / 4); });
}

TEST_F(KeptViews, Culling) {
  expect_measured([] { glEnable(GL_CULL_FACE); });
}

TEST_F(KeptViews, MeasuresAndLevels) {
  expect_measured([] { glARKParameterfARK(GL_SCREEN_ERROR_ARK, 0.05F); });
  expect_measured([] { glARKParameteriARK(GL_EDGE_PIXELS_ARK, 12); });
  glARKParameteriARK(GL_EDGE_PIXELS_ARK, 0);
  expect_measured([] { glARKinit(1); });
}

TEST_F(KeptViews, PositionsFromABlock) {
  const GLuint block = make_buffer(GL_UNIFORM_BUFFER, std::vector<Matrix>{perspective(3)});
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, block);
  use(link_program({.vertex = "#version 430\nlayout(location = 0) in vec3 position;\n"
                              "layout(location = 1) in vec3 normal; layout(std140, binding = 0) uniform Camera {\n"
                              "  mat4 view; };\nout vec3 facing;\n"
                              "void main() { gl_Position = view * vec4(position, 1.0); facing = normal; }\n",
                    .fragment = "#version 430\nin vec3 facing; out vec4 color;\n"
                                "void main() { color = vec4(abs(facing), 1.0); }\n",
                    .attributes = {"position", "normal"}}));
  write_vertices();
  for (int i = 0; i < 40; ++i) draw();
  picture_of(draw);
  const GLuint before = generated_primitives;
  const Matrix far = perspective(12);
  glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof(far), far.data());
  picture_of(draw);
  EXPECT_NE(generated_primitives, before);
}

// Many programs set all their uniforms again in every frame.
TEST_F(KeptViews, TheSameValuesAgain) {
  const auto draw_again = [&] {
    set_view(program_, perspective(3));
    draw();
  };
  const GLuint64 measured = measured_vertices();
  for (int i = 0; i < 60; ++i) draw_again();
  EXPECT_LT(submitted_vertices(draw_again), measured);
}

// A camera that comes back to where it was while values were not compared.
TEST_F(KeptViews, ACameraThatComesBack) {
  const auto look_from = [&](GLfloat distance) { set_view(program_, perspective(distance)); };
  look_from(3);
  settle_view();
  picture_of(draw);
  const GLuint triangles = generated_primitives;
  for (int i = 0; i < 6; ++i) {
    look_from(12.0F + static_cast<GLfloat>(i));
    draw();
  }
  repeat_often(draw);
  repeat_often(draw);
  picture_of(draw);
  EXPECT_NE(generated_primitives, triangles);
  look_from(3);
  picture_of(draw);
  EXPECT_EQ(generated_primitives, triangles);
}

}  // namespace
}  // namespace glark::core::test
