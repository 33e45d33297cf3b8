// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Pictures of draws with measured depths, the state that these draws read, and the budget.
#include "tests/core/support/measured_program.h"
#include "tests/core/support/scene.h"

namespace glark::core::test {
namespace {

// draw() gives the same picture refined by measured depths as unrefined, with more triangles.
template <typename Draw>
void expect_same_picture(GLuint coarse_triangles, Draw&& draw) {
  glDisable(GL_ARK);
  const Picture plain = picture_of(draw);
  EXPECT_GT(differing_pixels(plain, Picture(plain.size(), 0)), visible_pixels) << "the scene shows nothing";
  glEnable(GL_ARK);
  for (int repetition = 0; repetition < 3; ++repetition) {
    EXPECT_LE(differing_pixels(plain, picture_of(draw)), tolerated_pixels) << "repetition " << repetition;
    EXPECT_GT(generated_primitives, 2 * coarse_triangles) << "repetition " << repetition;
  }
  EXPECT_EQ(pending_errors(), "");
}

// A grid of cells x cells quads in the plane z = 0, from -1 to 1.
std::vector<CurvedVertex> grid(int cells) {
  std::vector<CurvedVertex> vertices;
  const auto add = [&](int x, int y) {
    const auto at = [cells](int i) { return 2.0F * static_cast<GLfloat>(i) / static_cast<GLfloat>(cells) - 1; };
    const auto odd = [](int i) { return i % 2 == 0 ? 0.3F : 0.9F; };
    vertices.push_back({{at(x), at(y), 0}, {0, 0, 1}, {odd(x), odd(y), 1}, 0, 0});
  };
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) {
      for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) add(x + i, y + j);
    }
  }
  return vertices;
}

class MeasuredPictures : public testing::Test {
 protected:
  MeasuredPictures() { glViewport(0, 0, picture_size, picture_size); }
  void draw_with(GLuint program, int cells) {
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glUseProgram(program);
    upload(grid(cells));
    glDisable(GL_DEPTH_TAG_ARRAY_ARK);
  }
  OsmesaContext context_{Profile::compatibility};
};

TEST_F(MeasuredPictures, InPerspective) {
  for (const int cells : {1, 6, 20}) {
    const GLuint program = link_measured_program();
    draw_with(program, cells);
    measure_depths(6, 4);
    for (const GLenum refinement : {GL_LINEAR_INPUTS_ARK, GL_LINEAR_OUTPUTS_ARK, GL_CURVED_PN_ARK}) {
      glARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(refinement));
      set_view(program, perspective(1.7F, 0.6F));
      expect_same_picture(static_cast<GLuint>(2 * cells * cells),
                          [=] { glDrawArrays(GL_TRIANGLES, 0, 6 * cells * cells); });
    }
  }
}

// Primitive restart must not apply to the indices that sort the triangles.
TEST_F(MeasuredPictures, RestartAtASmallIndex) {
  constexpr GLfloat rows[9][2] = {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {0, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}};
  constexpr GLuint two_strips[] = {3, 0, 4, 1, 5, 2, 9, 6, 3, 7, 4, 8, 5};
  measure_depths(6, 4);
  glVertexPointer(2, GL_FLOAT, 0, rows);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnable(GL_PRIMITIVE_RESTART);
  glPrimitiveRestartIndex(9);
  expect_same_picture(8, [&] { glDrawElements(GL_TRIANGLE_STRIP, 13, GL_UNSIGNED_INT, two_strips); });
}

TEST_F(MeasuredPictures, FixedFunctionOfEveryKind) {
  measure_depths(6, 4);
  const auto quad = [] {
    glBegin(GL_QUADS);
    for (const auto& [x, y] : {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}}) {
      glColor3f(x, y, 1);
      glVertex3f(x, y, 0);
    }
    glEnd();
  };
  glMatrixMode(GL_PROJECTION);
  glFrustum(-0.5, 0.5, -0.5, 0.5, 0.5, 9);
  glMatrixMode(GL_MODELVIEW);
  glTranslatef(0, 0, -1.5F);
  glRotatef(20, 0, 1, 0);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_OUTPUTS_ARK);
  expect_same_picture(2, quad);
  const GLuint near = generated_primitives;
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  quad();
  glEndList();
  expect_same_picture(2, [list] { glCallList(list); });
  EXPECT_EQ(generated_primitives, near);
  glTranslatef(0, 0, -4);
  picture_of([list] { glCallList(list); });
  EXPECT_LT(generated_primitives, near);
}

// Small draws keep the order of their triangles, in all patterns: later triangles cover earlier ones.
TEST_F(MeasuredPictures, OrderOfASmallDraw) {
  const GLuint program = link_measured_program();
  glUseProgram(program);
  set_view(program, flat_view);
  std::vector<CurvedVertex> stack;
  for (int i = 0; i < 40; ++i) {
    const GLfloat size = 0.05F + 0.07F * static_cast<GLfloat>((17 * i) % 13);
    const std::array<GLfloat, 3> color{static_cast<GLfloat>(i % 3) * 0.4F, static_cast<GLfloat>(i % 5) * 0.25F, 1};
    for (const auto& [x, y] : {std::pair{-1.0F, -1.0F}, {1.0F, -0.7F}, {0.2F, 1.0F}})
      stack.push_back({{x * size, y * size, 0}, {0, 0, 1}, color, 0, 0});
  }
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  upload(stack);
  glDisable(GL_DEPTH_TAG_ARRAY_ARK);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_COLOR);
  measure_depths(5, 4);
  expect_same_picture(40, [] { glDrawArrays(GL_TRIANGLES, 0, 120); });
}

// glark follows the viewport, no matter which call changes it.
TEST_F(MeasuredPictures, ViewportsOfListsAndStacks) {
  const GLuint program = link_measured_program();
  draw_with(program, 1);
  set_view(program, flat_view);
  measure_depths(6, 16);
  const auto draw = [] { glDrawArrays(GL_TRIANGLES, 0, 6); };
  const auto triangles = [&] {
    picture_of(draw);
    return generated_primitives;
  };
  const GLuint whole = triangles();
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glViewport(0, 0, picture_size / 4, picture_size / 4);
  glEndList();
  EXPECT_EQ(triangles(), whole);
  glPushAttrib(GL_VIEWPORT_BIT);
  glCallList(list);
  EXPECT_LT(triangles(), whole);
  glPopAttrib();
  EXPECT_EQ(triangles(), whole);
  const auto indexed = proc<PFNGLVIEWPORTINDEXEDFPROC>("glViewportIndexedf");
  indexed(0, 0, 0, picture_size / 4.0F, picture_size / 4.0F);
  EXPECT_LT(triangles(), whole);
  glViewport(0, 0, -1, 5);
  EXPECT_EQ(pending_errors(), "0x0501 ");
  EXPECT_LT(triangles(), whole);
}

// glark's own passes use the same storage bindings.
TEST_F(MeasuredPictures, VertexStageReadsStorage) {
  const GLuint program =
      link_program({.vertex = "#version 430\nlayout(location = 0) in vec3 position;\n"
                              "layout(std430, binding = 0) readonly buffer A { float size; };\n"
                              "layout(std430, binding = 2) readonly buffer B { vec4 tint; };\nout vec4 c;\n"
                              "void main() { gl_Position = vec4(position * size, 1.0); c = tint; }\n",
                    .fragment = "#version 430\nin vec4 c; out vec4 color;\nvoid main() { color = c; }\n"});
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, make_buffer(GL_ARRAY_BUFFER, std::vector<GLfloat>{0.5F}));
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, make_buffer(GL_ARRAY_BUFFER, std::vector<GLfloat>{1, 0.5F, 0, 1}));
  draw_with(program, 2);
  measure_depths(6, 4);
  expect_same_picture(8, [] { glDrawArrays(GL_TRIANGLES, 0, 24); });
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK);
  glEnable(GL_DEPTH_TAG_ARRAY_ARK);
  glDepthTagPointerARK(GL_UNSIGNED_BYTE, sizeof(CurvedVertex), byte_offset(offsetof(CurvedVertex, tag)));
  const Picture tagged = picture_of([] { glDrawArrays(GL_TRIANGLES, 0, 24); });
  glDisable(GL_ARK);
  EXPECT_LE(differing_pixels(tagged, picture_of([] { glDrawArrays(GL_TRIANGLES, 0, 24); })), tolerated_pixels);
}

TEST_F(MeasuredPictures, TheBudgetIsKeptAndUsed) {
  constexpr GLuint budget = 3000;
  const GLuint program = link_measured_program();
  draw_with(program, 6);
  measure_depths(7, 1, 0, budget);
  const auto draw = [] { glDrawArrays(GL_TRIANGLES, 0, 6 * 36); };
  const auto frame = [&] {
    std::array<GLuint, 2> passes{};
    for (GLuint& pass : passes) {
      picture_of(draw);
      pass = generated_primitives;
    }
    EXPECT_EQ(passes[0], passes[1]) << "passes over the same geometry do not meet";
    glFinish();  // ends the frame where there is no window
    return passes[0] + passes[1];
  };
  for (const GLfloat turn : {0.0F, 0.4F, 0.9F}) {
    for (const GLfloat distance : {1.2F, 3.0F}) {
      set_view(program, perspective(distance, turn));
      for (int settling = 0; settling < 5; ++settling) frame();
      const GLuint settled = frame();
      EXPECT_LE(settled, budget);
      EXPECT_GE(settled, budget / 4);
      for (int later = 0; later < 5; ++later) EXPECT_EQ(frame(), settled) << "the depths swing";
    }
  }
  glARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, 0);
  EXPECT_GT(frame(), 2 * budget);
}

// The mesh has more coarse triangles than the budget. All are drawn, and the depths come back when there is room.
TEST_F(MeasuredPictures, ABudgetThatCannotBeKept) {
  const GLuint program = link_measured_program();
  draw_with(program, 20);
  set_view(program, perspective(1.5F));
  measure_depths(5, 4, 0, 100);
  for (int frame = 0; frame < 8; ++frame) {
    picture_of([] { glDrawArrays(GL_TRIANGLES, 0, 6 * 400); });
    glFinish();
  }
  EXPECT_EQ(generated_primitives, 800U);
  for (int frame = 0; frame < 10; ++frame) {
    picture_of([] { glDrawArrays(GL_TRIANGLES, 0, 3); });
    glFinish();
  }
  EXPECT_GT(generated_primitives, 1U);
}

}  // namespace
}  // namespace glark::core::test
