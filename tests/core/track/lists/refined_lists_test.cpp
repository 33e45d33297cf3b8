// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Display lists: they are refined by the state at the time of the call.
#include "tests/core/support/modes.h"
#include "tests/core/support/programs.h"
#include "tests/core/support/scene.h"

namespace glark::core::test {
namespace {

const ModeShape& strip() { return mode_shapes()[1]; }

class RefinedLists : public testing::Test {
 protected:
  RefinedLists() { glARKinit(2); }
  template <typename Contents>
  GLuint compile(Contents&& contents) {
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    contents();
    glEndList();
    return list;
  }
  OsmesaContext context_{Profile::compatibility};
};

void draw_shifted(GLfloat x, GLfloat y) {
  glPushMatrix();
  glTranslatef(x, y, 0);
  glScalef(0.4F, 0.4F, 1);
  draw_immediate(strip());
  glPopMatrix();
}

TEST_F(RefinedLists, StateBetweenDraws) {
  const GLuint list = compile([] {
    draw_shifted(-0.5F, -0.5F);
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
    draw_shifted(0.5F, 0.5F);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  });
  expect_same_scene({8}, [list] { glCallList(list); });
}

// Nine vertices in three rows, and two strips of six vertices through them.
constexpr GLfloat rows[9][2] = {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {0, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}};
constexpr GLint none = -1;
constexpr GLint two_strips[] = {3, 0, 4, 1, 5, 2, none, 6, 3, 7, 4, 8, 5};

TEST_F(RefinedLists, RestartedByACall) {
  const auto strips = [] {
    glBegin(GL_TRIANGLE_STRIP);
    for (const GLint i : two_strips) {
      i == none ? glPrimitiveRestartNV() : glVertex2fv(rows[i]);
    }
    glEnd();
  };
  const GLuint list = compile(strips);
  expect_same_scene({12}, [list] { glCallList(list); });  // in a list Mesa joins strips by triangles without area
  expect_same_scene({8}, strips);
}

TEST_F(RefinedLists, RestartEnabledAfterBegin) {
  glPrimitiveRestartIndexNV(0);
  glVertexPointer(2, GL_FLOAT, 0, rows);
  glEnableClientState(GL_VERTEX_ARRAY);
  const GLuint list = compile([] {
    glBegin(GL_TRIANGLE_STRIP);
    for (const GLint i : two_strips) {
      if (i == none) {
        glEnableClientState(GL_PRIMITIVE_RESTART_NV);
      }
      glArrayElement(i == none ? 0 : i);
    }
    glEnd();
  });
  glDisableClientState(GL_PRIMITIVE_RESTART_NV);
  glDisableClientState(GL_VERTEX_ARRAY);
  expect_same_scene({12}, [list] { glCallList(list); });
}

TEST_F(RefinedLists, RestartOfElements) {
  glVertexPointer(2, GL_FLOAT, 0, rows);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnable(GL_PRIMITIVE_RESTART);
  glPrimitiveRestartIndex(9);
  const GLuint list = compile([] {
    constexpr GLuint indices[] = {3, 0, 4, 1, 5, 2, 9, 6, 3, 7, 4, 8, 5};
    glDrawElements(GL_TRIANGLE_STRIP, 13, GL_UNSIGNED_INT, indices);
  });
  glPrimitiveRestartIndex(0);
  expect_same_scene({}, [list] { glCallList(list); });
}

TEST_F(RefinedLists, SeveralStripsOfOneCall) {
  glVertexPointer(2, GL_FLOAT, 0, rows);
  glEnableClientState(GL_VERTEX_ARRAY);
  const GLuint list = compile([] {
    constexpr GLuint lower[] = {3, 0, 4, 1, 5, 2};
    constexpr GLuint upper[] = {6, 3, 7, 4, 8, 5};
    const void* const starts[] = {lower, upper};
    constexpr GLsizei counts[] = {6, 6};
    glMultiDrawElements(GL_TRIANGLE_STRIP, counts, GL_UNSIGNED_INT, starts, 2);
  });
  expect_same_scene({}, [list] { glCallList(list); });
}

// An attribute that appears late splits the primitive in Mesa's list.
TEST_F(RefinedLists, AttributesThatAppearLate) {
  for (const std::size_t late : {std::size_t{1}, std::size_t{2}, std::size_t{4}}) {
    const GLuint list = compile([late] {
      glBegin(GL_TRIANGLE_STRIP);
      for (std::size_t i = 0; i < 6; ++i) {
        if (i == late) {
          const GLfloat half[] = {0.5F, 0.5F, 0.5F, 1};
          glMaterialfv(GL_FRONT, GL_DIFFUSE, half);
          glVertexAttrib4f(5, 1, 0, 1, 1);
        }
        i == late ? glVertex3f(rows[two_strips[i]][0], rows[two_strips[i]][1], 0.1F) : glVertex2fv(rows[two_strips[i]]);
      }
      glEnd();
      glBegin(GL_LINES);  // a second mode: Mesa draws lists with only one primitive wrong
      glVertex2f(-1, 0.5F);
      glVertex2f(1, 0.5F);
      glEnd();
    });
    SCOPED_TRACE(late);
    expect_same_scene({}, [list] { glCallList(list); });
  }
}

TEST_F(RefinedLists, ColorLeftByTheListColorsWhatFollows) {
  const GLuint list = compile([] { glColor3f(1, 0.5F, 0.25F); });
  expect_same_scene({2}, [list] {
    glColor3f(0, 0, 1);
    glCallList(list);
    glBegin(GL_QUADS);
    for (const auto& [x, y] : {std::pair{-1, -1}, {0, -1}, {0, 1}, {-1, 1}}) glVertex2i(x, y);
    glEnd();
  });
}

TEST_F(RefinedLists, Nested) {
  const GLuint leaf = compile([] { draw_immediate(strip()); });
  const GLuint middle = compile([leaf] {
    glPushMatrix();
    glScalef(0.5F, 0.5F, 1);
    glCallList(leaf);
    glPopMatrix();
  });
  const GLuint root = compile([middle] {
    glTranslatef(-0.5F, 0, 0);
    glCallList(middle);
    glTranslatef(1, 0, 0);
    glCallList(middle);
    glTranslatef(-0.5F, 0, 0);
  });
  expect_same_scene({8}, [root] { glCallList(root); });
}

TEST_F(RefinedLists, CallsItselfToTheDepthOfOpenGl) {
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  draw_immediate(strip());
  glCallList(list);
  glEndList();
  GLint nesting = 0;
  glGetIntegerv(GL_MAX_LIST_NESTING, &nesting);
  expect_same_scene({static_cast<GLuint>(4 * nesting)}, [list] { glCallList(list); });
}

TEST_F(RefinedLists, NestedListReplacedAfterCompilation) {
  const GLuint leaf = compile([] { draw_shifted(-0.5F, -0.5F); });
  const GLuint root = compile([leaf] { glCallList(leaf); });
  glNewList(leaf, GL_COMPILE);
  draw_immediate(strip());
  draw_shifted(0.5F, 0.5F);
  glEndList();
  expect_same_scene({8}, [root] { glCallList(root); });
}

TEST_F(RefinedLists, CallListsWithABase) {
  const GLuint base = glGenLists(3);
  for (GLuint i = 0; i < 3; ++i) {
    glNewList(base + i, GL_COMPILE);
    draw_shifted(static_cast<GLfloat>(i) * 0.6F - 0.6F, 0);
    glEndList();
  }
  const GLubyte names[] = {0, 2};
  glListBase(base);
  expect_same_scene({8}, [&] { glCallLists(2, GL_UNSIGNED_BYTE, names); });
  const GLubyte pairs[] = {0, 1, 0, 2};
  expect_same_scene({8}, [&] { glCallLists(2, GL_2_BYTES, pairs); });
}

TEST_F(RefinedLists, CallListsInAList) {
  const GLuint base = glGenLists(2);
  for (GLuint i = 0; i < 2; ++i) {
    glNewList(base + i, GL_COMPILE);
    draw_shifted(static_cast<GLfloat>(i) * 0.6F - 0.6F, 0);
    glEndList();
  }
  glListBase(base);
  const GLuint list = compile([] {
    const GLubyte names[] = {0, 1};
    glCallLists(2, GL_UNSIGNED_BYTE, names);
  });
  expect_same_scene({8}, [&] { glCallList(list); });
}

TEST_F(RefinedLists, CompileAndExecute) {
  const GLuint list = glGenLists(1);
  expect_same_scene({8}, [list] {
    glNewList(list, GL_COMPILE_AND_EXECUTE);
    draw_shifted(-0.5F, -0.5F);
    draw_shifted(0.5F, 0.5F);
    glEndList();
  });
  expect_same_scene({8}, [list] { glCallList(list); });
}

// Arrays are read when the list is compiled.
TEST_F(RefinedLists, ArraysAreReadAtCompilation) {
  std::vector<ColoredVertex> vertices = strip().vertices;
  point_conventional_arrays(vertices.data());
  const GLushort indices[] = {0, 1, 2, 2, 1, 3};
  const GLuint list = compile([&] {
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 6);
    glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, indices);
  });
  vertices.assign(vertices.size(), {});
  expect_same_scene({6}, [list] { glCallList(list); });
}

TEST_F(RefinedLists, InsideBeginTheListGivesVertices) {
  const GLuint list = compile([] {
    for (int i = 1; i < 5; ++i) emit(strip().vertices[static_cast<std::size_t>(i)]);
  });
  expect_same_scene({4}, [list] {
    glBegin(GL_TRIANGLE_STRIP);
    emit(strip().vertices[0]);
    glCallList(list);
    emit(strip().vertices[5]);
    glEnd();
  });
}

// OpenGL 4.6 compatibility, 21.4: a list may end the primitive that the application has begun.
TEST_F(RefinedLists, AListEndsThePrimitive) {
  const GLuint vertices = compile([] {
    for (const ColoredVertex& vertex : strip().vertices) emit(vertex);
  });
  const GLuint end = compile([] { glEnd(); });
  expect_same_scene({4}, [=] {
    glBegin(GL_TRIANGLE_STRIP);
    glCallList(vertices);
    glCallList(end);
  });
  const GLuint begin = compile([] { glBegin(GL_TRIANGLES); });
  glCallList(begin);
  glCallList(end);
  EXPECT_EQ(pending_errors(), "");
}

TEST_F(RefinedLists, VerticesFromListsInABeginOfAList) {
  const GLuint base = glGenLists(2);
  glListBase(base);
  const auto compile_vertices = [base](GLuint list, std::size_t first, std::size_t end) {
    glNewList(base + list, GL_COMPILE);
    for (std::size_t i = first; i < end; ++i) emit(strip().vertices[i]);
    glEndList();
  };
  compile_vertices(0, 0, 3);
  compile_vertices(1, 3, 4);
  const GLuint list = compile([base] {
    const GLubyte second = 1;
    glBegin(GL_TRIANGLE_STRIP);
    glCallList(base);
    glCallLists(1, GL_UNSIGNED_BYTE, &second);
    glEnd();
  });
  expect_same_scene({2}, [list] { glCallList(list); });
  compile_vertices(1, 3, 6);
  expect_same_scene({4}, [list] { glCallList(list); });
}

TEST_F(RefinedLists, CallListsInsideBegin) {
  const GLuint base = glGenLists(6);
  for (GLuint i = 0; i < 6; ++i) {
    glNewList(base + i, GL_COMPILE);
    emit(strip().vertices[i]);
    glEndList();
  }
  glListBase(base);
  const GLubyte names[] = {0, 1, 2, 3, 4, 5};
  expect_same_scene({4}, [&] {
    glBegin(GL_TRIANGLE_STRIP);
    glCallLists(6, GL_UNSIGNED_BYTE, names);
    glEnd();
  });
}

// The rectangle stays unrefined, as without a list.
TEST_F(RefinedLists, Rectangle) {
  const GLuint list = compile([] { glRectf(-0.5F, -0.5F, 0.75F, 0.5F); });
  glColor3f(1, 0, 0);
  const Picture plain = picture_of([list] { glCallList(list); });
  const GLuint primitives = generated_primitives;
  refine_uniformly(2, GL_LINEAR_INPUTS_ARK);
  EXPECT_EQ(differing_pixels(plain, picture_of([list] { glCallList(list); })), 0);
  EXPECT_EQ(generated_primitives, primitives);
}

TEST_F(RefinedLists, UniformsChangedByAList) {
  const GLuint program = link_program(
      {.vertex = "#version 120\n"
                 "uniform vec4 tint; uniform vec2 shift[2];\n"
                 "void main() { gl_Position = gl_Vertex * vec4(0.5, 0.5, 1.0, 1.0) + vec4(shift[1], 0.0, 0.0);\n"
                 "gl_FrontColor = gl_Color * tint; }\n"});
  glUseProgram(program);
  const GLint tint = glGetUniformLocation(program, "tint");
  const GLint shift = glGetUniformLocation(program, "shift[1]");
  const GLuint list = compile([=] {
    glUniform4f(tint, 1, 0.5F, 0.25F, 1);
    glUniform2f(shift, 0.4F, 0.3F);
    draw_immediate(strip());
    glUniform4f(tint, 0.25F, 0.5F, 1, 1);
    glUniform2f(shift, -0.4F, -0.3F);
    draw_immediate(strip());
  });
  expect_same_scene({12}, [=] {
    glUniform4f(tint, 1, 1, 1, 1);
    glUniform2f(shift, -0.4F, 0.3F);
    draw_immediate(strip());
    glCallList(list);
  });
}

TEST_F(RefinedLists, ProgramChosenByAList) {
  const GLuint program = link_program(
      {.vertex = "#version 120\nvoid main() { gl_Position = gl_Vertex; gl_FrontColor = 1.0 - gl_Color; }\n"});
  const GLuint list = compile([program] {
    glUseProgram(program);
    draw_immediate(strip());
    glUseProgram(0);
    draw_shifted(0, 0);
  });
  expect_same_scene({8}, [list] { glCallList(list); });
}

TEST_F(RefinedLists, DeletedAndCompiledAgain) {
  const GLuint list = compile([] { draw_shifted(0, 0); });
  glDeleteLists(list, 1);
  glNewList(list, GL_COMPILE);
  draw_immediate(strip());
  glEndList();
  expect_same_scene({4}, [list] { glCallList(list); });
}

TEST_F(RefinedLists, CompiledBeforeInitIsDrawnAtLeastUnrefined) {
  OsmesaContext fresh(Profile::compatibility);
  const GLuint list = compile([] { draw_immediate(strip()); });
  const Picture plain = picture_of([list] { glCallList(list); });
  refine_uniformly(2);
  EXPECT_LE(differing_pixels(plain, picture_of([list] { glCallList(list); })), tolerated_pixels);
}

TEST_F(RefinedLists, TagsAreCompiled) {
  const GLuint list = compile([] {
    glDepthTag1i(2);
    draw_immediate(strip());
    glDepthTag1i(1);
    draw_immediate(strip());
    glDepthTag1i(0);
  });
  glEnable(GL_ARK);
  picture_of([list] { glCallList(list); });
  EXPECT_EQ(generated_primitives, 4U * 16 + 4 * 4);
}

TEST_F(RefinedLists, WithoutTagsTheCurrentTagCounts) {
  const GLuint list = compile([] { draw_immediate(strip()); });
  glEnable(GL_ARK);
  glDepthTag1i(1);
  picture_of([list] { glCallList(list); });
  EXPECT_EQ(generated_primitives, 4U * 4);
  glDepthTag1i(2);
  picture_of([list] { glCallList(list); });
  EXPECT_EQ(generated_primitives, 4U * 16);
}

// Such a list sets its uniforms at once, also for its own draws.
TEST_F(RefinedLists, UniformsOfListsThatAreExecuted) {
  const GLuint program =
      link_program({.vertex = "#version 120\nvoid main() { gl_Position = gl_Vertex; }\n",
                    .fragment = "#version 120\nuniform vec4 tint;\nvoid main() { gl_FragColor = tint; }\n"});
  glUseProgram(program);
  const GLint tint = glGetUniformLocation(program, "tint");
  expect_same_scene({4}, [&] {
    for (const bool right : {false, true}) {
      glNewList(1, GL_COMPILE_AND_EXECUTE);
      glUniform4f(tint, right ? 1.0F : 0.0F, 1.0F, 0.0F, 1.0F);
      glBegin(GL_QUADS);
      for (const int corner : {0, 1, 3, 2})
        glVertex2f((right ? 0.0F : -1.0F) + static_cast<float>(corner % 2), corner < 2 ? -1.0F : 1.0F);
      glEnd();
      glEndList();
    }
  });
}

}  // namespace
}  // namespace glark::core::test
