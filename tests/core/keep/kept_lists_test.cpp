// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Display lists and the fixed function: captures are kept while the current values that they inherit stay the same. A
// kept list leaves the current values that GL would leave.
#include <array>
#include <utility>

#include "tests/core/support/kept_scene.h"

namespace glark::core::test {
namespace {

class KeptLists : public testing::Test {
 protected:
  KeptLists() { refine_uniformly(2); }
  static const ModeShape& strip() { return mode_shapes()[1]; }
  template <typename Commands>
  static GLuint compile(Commands&& commands) {
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    commands();
    glEndList();
    return list;
  }
  static void give_positions() {
    glBegin(GL_TRIANGLE_STRIP);
    for (const ColoredVertex& vertex : strip().vertices) glVertex2fv(vertex.position.data());
    glEnd();
  }
  static std::array<GLfloat, 4> current(GLenum name) {
    std::array<GLfloat, 4> value{};
    glGetFloatv(name, value.data());
    return value;
  }

  OsmesaContext context_{Profile::compatibility};
};

TEST_F(KeptLists, ListIsKept) {
  const GLuint list = compile([] { draw_immediate(strip()); });
  expect_kept([list] { glCallList(list); }, [] { glTranslatef(0.001F, 0, 0); });
}

// The list sets all attributes of its vertices, so changed current values do not matter.
TEST_F(KeptLists, ListInheritsNothing) {
  const GLuint list = compile([] { draw_immediate(strip()); });
  const GLuint unseen = compile([] { glPopAttrib(); });
  expect_kept([list] { glCallList(list); },
              [unseen] {
                glPushAttrib(GL_CURRENT_BIT);
                glColor3f(0, 0, 1);
                glCallList(unseen);
              });
}

TEST_F(KeptLists, ListOfArraysIsKept) {
  const std::vector<ColoredVertex> vertices = strip().vertices;
  point_conventional_arrays(vertices.data());
  const GLuint list = compile([] { glDrawArrays(GL_TRIANGLE_STRIP, 0, 6); });
  expect_kept([list] { glCallList(list); }, [] {});
}

TEST_F(KeptLists, NestedListsWithStateAreKept) {
  const GLuint leaf = compile([] { draw_immediate(strip()); });
  const GLuint root = compile([leaf] {
    glPushMatrix();
    glScalef(0.5F, 0.5F, 1);
    glCallList(leaf);
    glPopMatrix();
    glColor3f(1, 0, 0);
    give_positions();
  });
  expect_kept([root] { glCallList(root); }, [] {});
  expect_same_scene({8}, [root] { glCallList(root); });
}

TEST_F(KeptLists, InheritedColor) {
  const GLuint list = compile([] { give_positions(); });
  glColor3f(1, 0.5F, 0);
  expect_kept([list] { glCallList(list); }, [] { glColor3f(1, 0.5F, 0); });
  expect_seen([list] { glCallList(list); }, [] { glColor3f(0, 0.5F, 1); });
}

TEST_F(KeptLists, ColorsTakeTurns) {
  const GLuint list = compile([] { give_positions(); });
  const auto draw = [list] {
    for (const GLubyte green : std::initializer_list<GLubyte>{0, 128, 255}) {
      glColor4ub(255, green, 0, 255);
      glCallList(list);
      glTranslatef(0.1F, 0, 0);
    }
    glLoadIdentity();
  };
  expect_kept(draw, [] {});
  expect_same_scene({12}, draw);
}

TEST_F(KeptLists, ColorOfAnotherList) {
  const GLuint red = compile([] { glColor3f(1, 0, 0); });
  const GLuint blue = compile([] { glColor3f(0, 0, 1); });
  const GLuint list = compile([] { give_positions(); });
  glCallList(red);
  expect_kept([list] { glCallList(list); }, [red] { glCallList(red); });
  expect_seen([list] { glCallList(list); }, [blue] { glCallList(blue); });
}

TEST_F(KeptLists, ColorRestoredByPopAttrib) {
  const GLuint list = compile([] { give_positions(); });
  glColor3f(0, 0, 1);
  glPushAttrib(GL_CURRENT_BIT);
  glColor3f(1, 0, 0);
  expect_seen([list] { glCallList(list); }, [] { glPopAttrib(); });
}

TEST_F(KeptLists, ColorRestoredByPopAttribOfAList) {
  const GLuint list = compile([] { give_positions(); });
  const GLuint pop = compile([] { glPopAttrib(); });
  glColor3f(0, 0, 1);
  glPushAttrib(GL_CURRENT_BIT);
  glColor3f(1, 0, 0);
  expect_seen([list] { glCallList(list); }, [pop] { glCallList(pop); });
}

// The first vertices of the list inherit a colour, and the list's last colour stays.
TEST_F(KeptLists, LateColorInTheList) {
  const GLuint list = compile([] {
    glBegin(GL_TRIANGLE_STRIP);
    for (std::size_t i = 0; i < 6; ++i) {
      if (i == 4) glColor3f(0, 1, 0);
      glVertex2fv(strip().vertices[i].position.data());
    }
    glEnd();
  });
  const auto draw = [list] {
    glColor3f(1, 0, 0);
    glCallList(list);
  };
  expect_kept(draw, [] {});
  expect_same_scene({4}, draw);
}

TEST_F(KeptLists, WhatAKeptListLeavesBehind) {
  const GLuint list = compile([] {
    glBegin(GL_TRIANGLES);
    glColor4ub(255, 0, 51, 255);
    glNormal3b(127, 0, 0);
    glMultiTexCoord2f(GL_TEXTURE3, 0.25F, 0.5F);
    glSecondaryColor3d(0.25, 0.5, 0.75);
    glFogCoordf(0.125F);
    const GLfloat generic[4] = {1, 2, 3, 4};
    glVertexAttrib4fv(5, generic);
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {0, 1}}) glVertex2i(x, y);
    glEnd();
  });
  const auto read = [] {
    glActiveTexture(GL_TEXTURE3);
    std::vector<std::array<GLfloat, 4>> values = {current(GL_CURRENT_COLOR), current(GL_CURRENT_NORMAL),
                                                  current(GL_CURRENT_TEXTURE_COORDS),
                                                  current(GL_CURRENT_SECONDARY_COLOR), current(GL_CURRENT_FOG_COORD)};
    values.emplace_back();
    glGetVertexAttribfv(5, GL_CURRENT_VERTEX_ATTRIB, values.back().data());
    return values;
  };
  const auto reset = [] {
    glColor4f(1, 1, 1, 1);
    glNormal3f(0, 0, 1);
    glMultiTexCoord4f(GL_TEXTURE3, 0, 0, 0, 1);
    glSecondaryColor3f(0, 0, 0);
    glFogCoordf(0);
    glVertexAttrib4f(5, 0, 0, 0, 1);
  };
  glDisable(GL_ARK);
  glCallList(list);
  const auto plain = read();
  glEnable(GL_ARK);
  for (int i = 0; i < 4; ++i) {
    reset();
    glCallList(list);
    EXPECT_EQ(read(), plain) << "repetition " << i;
  }
  EXPECT_EQ(pending_errors(), "");
}

// No attribute stands for a material, so such lists are executed each time.
TEST_F(KeptLists, MaterialOfAListStays) {
  glEnable(GL_LIGHTING);
  const GLuint list = compile([] {
    const GLfloat glowing[4] = {0.5F, 0.25F, 1, 1};
    glBegin(GL_TRIANGLES);
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, glowing);
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {0, 1}}) glVertex2i(x, y);
    glEnd();
  });
  for (int i = 0; i < 4; ++i) {
    const GLfloat black[4] = {0, 0, 0, 1};
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, black);
    glCallList(list);
    std::array<GLfloat, 4> emission{};
    glGetMaterialfv(GL_FRONT, GL_EMISSION, emission.data());
    EXPECT_EQ(emission[2], 1.0F) << "repetition " << i;
  }
}

TEST_F(KeptLists, CompiledAgain) {
  const GLuint list = compile([] { draw_immediate(strip()); });
  expect_seen([list] { glCallList(list); },
              [list] {
                glNewList(list, GL_COMPILE);
                glScalef(0.5F, 0.5F, 1);
                draw_immediate(strip());
                glLoadIdentity();
                glEndList();
              });
}

TEST_F(KeptLists, TagsOfListsAreKept) {
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK);
  const GLuint list = compile([] {
    glBegin(GL_TRIANGLE_STRIP);
    for (GLuint i = 0; i < 6; ++i) {
      glDepthTag1i(i % 3);
      emit(strip().vertices[i]);
    }
    glEnd();
  });
  expect_kept([list] { glCallList(list); }, [] { glDepthTag1i(1); });
}

class KeptFixedFunction : public KeptLists {
 protected:
  KeptFixedFunction() {
    make_buffer(GL_ARRAY_BUFFER, strip().vertices);
    glVertexPointer(2, GL_FLOAT, sizeof(ColoredVertex), nullptr);
    glEnableClientState(GL_VERTEX_ARRAY);
  }
  static void draw() { glDrawArrays(GL_TRIANGLE_STRIP, 0, 6); }
};

TEST_F(KeptFixedFunction, CurrentColor) {
  glColor3f(1, 0.5F, 0);
  expect_kept(draw, [] { glColor3f(1, 0.5F, 0); });
  expect_seen(draw, [] { glColor3ub(0, 128, 255); });
}

TEST_F(KeptFixedFunction, ColorOfAVertexArrayElement) {
  glColor3f(1, 1, 1);
  glEnableClientState(GL_COLOR_ARRAY);
  glColorPointer(3, GL_FLOAT, sizeof(ColoredVertex), byte_offset(sizeof(ColoredVertex::position)));
  glDisableClientState(GL_COLOR_ARRAY);
  expect_seen(draw, [] {
    glEnableClientState(GL_COLOR_ARRAY);
    glBegin(GL_POINTS);
    glArrayElement(2);
    glEnd();
    glDisableClientState(GL_COLOR_ARRAY);
  });
}

TEST_F(KeptFixedFunction, ArraysEnabledAndDisabled) {
  glColor3f(1, 0.5F, 0);
  glColorPointer(3, GL_FLOAT, sizeof(ColoredVertex), byte_offset(sizeof(ColoredVertex::position)));
  expect_seen(draw, [] { glEnableClientState(GL_COLOR_ARRAY); });
  glEnable(GL_ARK);
  expect_seen(draw, [] { glDisableClientState(GL_COLOR_ARRAY); });
}

// Arrays are enabled as client states, but by the functions for capabilities.
TEST_F(KeptFixedFunction, ArraysEnabledAsCapabilities) {
  glColor3f(1, 0.5F, 0);
  glColorPointer(3, GL_FLOAT, sizeof(ColoredVertex), byte_offset(sizeof(ColoredVertex::position)));
  expect_seen(draw, [] { glEnable(GL_COLOR_ARRAY); });
  glEnable(GL_ARK);
  expect_seen(draw, [] { glDisable(GL_COLOR_ARRAY); });
}

TEST_F(KeptFixedFunction, ElementBufferDeletedWhileBound) {
  const std::vector<GLushort> all = {0, 1, 2, 2, 1, 3, 3, 4, 5};
  const std::vector<GLushort> one = {0, 1, 2, 0, 0, 0, 0, 0, 0};
  const GLuint elements = make_buffer(GL_ELEMENT_ARRAY_BUFFER, all);
  const GLushort* at = nullptr;
  expect_seen([&at] { glDrawElements(GL_TRIANGLES, 9, GL_UNSIGNED_SHORT, at); },
              [&] {
                glDeleteBuffers(1, &elements);
                at = one.data();
              });
}

TEST_F(KeptFixedFunction, RestartEnabled) {
  make_buffer(GL_ELEMENT_ARRAY_BUFFER, std::vector<GLushort>{0, 1, 2, 3, 4, 5});
  glPrimitiveRestartIndexNV(3);
  const auto draw_strip = [] { glDrawElements(GL_TRIANGLE_STRIP, 6, GL_UNSIGNED_SHORT, nullptr); };
  expect_seen(draw_strip, [] { glEnableClientState(GL_PRIMITIVE_RESTART_NV); });
  glEnable(GL_ARK);
  expect_seen(draw_strip, [] { glDisableClientState(GL_PRIMITIVE_RESTART_NV); });
}

// glBindBufferOffsetEXT binds the generic binding point as well, like glBindBufferBase.
TEST_F(KeptFixedFunction, WrittenThroughAnOffsetBinding) {
  const auto bind = proc<PFNGLBINDBUFFEROFFSETEXTPROC>("glBindBufferOffsetEXT");
  if (bind == nullptr) GTEST_SKIP() << "no glBindBufferOffsetEXT here";
  const GLuint buffer = make_buffer(GL_ARRAY_BUFFER, strip().vertices);
  glVertexPointer(2, GL_FLOAT, sizeof(ColoredVertex), nullptr);
  const GLuint other = make_buffer(GL_ARRAY_BUFFER, strip().vertices);
  glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, other);
  expect_seen(draw, [&] {
    bind(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer, 0);
    const std::vector<ColoredVertex> changed = other_vertices();
    glBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, static_cast<GLsizeiptr>(changed.size() * sizeof(ColoredVertex)),
                    changed.data());
  });
}

TEST_F(KeptFixedFunction, PointerOfAnotherUnit) {
  GLuint texture = 0;
  const GLubyte texels[] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 0, 255};
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glEnable(GL_TEXTURE_2D);
  glTexCoordPointer(2, GL_FLOAT, sizeof(ColoredVertex), nullptr);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  expect_kept(draw, [] {
    glClientActiveTexture(GL_TEXTURE1);
    glTexCoordPointer(3, GL_FLOAT, sizeof(ColoredVertex), byte_offset(8));
    glClientActiveTexture(GL_TEXTURE0);
  });
  expect_seen(draw, [] { glTexCoordPointer(2, GL_FLOAT, sizeof(ColoredVertex), byte_offset(8)); });
}

TEST_F(KeptFixedFunction, ClientMemoryIsNeverTrusted) {
  std::vector<ColoredVertex> vertices = strip().vertices;
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glVertexPointer(2, GL_FLOAT, sizeof(ColoredVertex), vertices.data());
  expect_seen(draw, [&] {
    for (ColoredVertex& vertex : vertices) vertex.position[1] *= -0.5F;
  });
}

}  // namespace
}  // namespace glark::core::test
