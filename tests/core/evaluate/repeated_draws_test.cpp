// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Repeated draws of kept vertices need no plan. Two draws that differ in one thing take turns until
// both are kept, and each still shows its own picture.
#include <functional>
#include <vector>

#include "tests/core/evaluate/kept_pictures.h"

namespace glark::core::test {
namespace {

using Change = std::function<void()>;

class RepeatedDraws : public KeptScene {
 protected:
  // Attribute 2 has the positions as colours.
  RepeatedDraws() {
    glVertexAttribPointer(2, 3, GL_FLOAT, GL_FALSE, sizeof(ColoredVertex), nullptr);
    glEnableVertexAttribArray(2);
    refine_uniformly(2, GL_LINEAR_INPUTS_ARK);
  }

  // Draws in the left half of the picture in one state, and in the right half in the other one.
  static void draw_both(const Change& one, const Change& other, const std::function<void()>& draw) {
    one();
    glViewport(0, 0, picture_size / 2, picture_size);
    draw();
    other();
    glViewport(picture_size / 2, 0, picture_size / 2, picture_size);
    draw();
    one();
    glViewport(0, 0, picture_size, picture_size);
  }
  // Neither draw shows what is kept of the other one.
  static void expect_own_pictures(const Change& one, const Change& other, const std::function<void()>& draw) {
    const auto turns = [&] { draw_both(one, other, draw); };
    const auto same = [&] {
      draw_both(
          one, [] {}, draw);
    };
    const Picture kept = expect_same_picture(turns);
    glDisable(GL_ARK);
    EXPECT_LE(differing_pixels(picture_of(turns), kept), tolerated_pixels);
    EXPECT_GT(differing_pixels(picture_of(same), kept), visible_pixels) << "the states do not differ";
    glEnable(GL_ARK);
  }
  // The draw is kept; then it shows the change, and the change back.
  static void expect_changes_seen(const Change& one, const Change& other, const std::function<void()>& draw) {
    for (const Change& change : {one, other, one, other}) {
      change();
      const Picture refined = picture_of(draw);
      EXPECT_EQ(differing_pixels(refined, expect_same_picture(draw)), 0);
      glDisable(GL_ARK);
      EXPECT_LE(differing_pixels(picture_of(draw), refined), tolerated_pixels);
      glEnable(GL_ARK);
    }
  }
  static void link(GLuint program, GLuint color) {
    glBindAttribLocation(program, 0, "position");
    glBindAttribLocation(program, color, "color");
    glLinkProgram(program);
  }
  static GLuint make_program() {
    const GLuint program = glCreateProgram();
    attach_shader(program, GL_VERTEX_SHADER,
                  "#version 430\nin vec3 position; in vec3 color; out vec3 c;\n"
                  "void main() { gl_Position = vec4(position.xy, 0.0, 1.0); c = color; }\n");
    attach_shader(program, GL_FRAGMENT_SHADER,
                  "#version 430\nin vec3 c; out vec4 result;\nvoid main() { result = vec4(c, 1.0); }\n");
    return program;
  }
};

INSTANTIATE_TEST_SUITE_P(All, RepeatedDraws, testing::Values(Profile::compatibility, Profile::core), profile_name);

// The colour comes from another array, which the vertices that are kept do not have.
TEST_P(RepeatedDraws, ProgramsWithOtherInputs) {
  const GLuint straight = make_program();
  link(straight, 1);
  const GLuint shifted = make_program();
  link(shifted, 2);
  expect_own_pictures([&] { glUseProgram(straight); }, [&] { glUseProgram(shifted); }, draw_elements);
}

TEST_P(RepeatedDraws, AProgramThatIsLinkedAgain) {
  const GLuint program = make_program();
  link(program, 1);
  glUseProgram(program);
  expect_changes_seen([&] { link(program, 2); }, [&] { link(program, 1); }, draw_elements);
}

TEST_P(RepeatedDraws, AProgramThatAnotherContextLinksAgain) {
  const GLuint program = make_program();
  link(program, 1);
  glUseProgram(program);
  OsmesaContext other(GetParam(), &context_);
  context_.make_current();
  const auto link_there = [&](GLuint color) {
    glFinish();
    other.make_current();
    link(program, color);
    glFinish();
    context_.make_current();
    glUseProgram(program);
  };
  expect_changes_seen([&] { link_there(2); }, [&] { link_there(1); }, draw_elements);
}

TEST_P(RepeatedDraws, VertexArrays) {
  GLuint other = 0;
  glGenVertexArrays(1, &other);
  glBindVertexArray(other);
  make_buffer(GL_ARRAY_BUFFER, two());
  point_generic_arrays(nullptr);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  expect_own_pictures([&] { glBindVertexArray(array_); }, [&] { glBindVertexArray(other); }, draw_elements);
}

TEST_P(RepeatedDraws, BuffersOfOneVertexArray) {
  const GLuint other = make_buffer(GL_ARRAY_BUFFER, two());
  const auto point = [](GLuint buffer) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    point_generic_arrays(nullptr);
  };
  expect_own_pictures([&] { point(vertices_); }, [&] { point(other); }, draw_elements);
}

// Only the second attribute has another source.
TEST_P(RepeatedDraws, OneArrayOfTwo) {
  const auto point = [](std::size_t offset) {
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(ColoredVertex), byte_offset(offset));
  };
  expect_own_pictures([&] { point(8); }, [&] { point(0); }, draw_elements);
}

TEST_P(RepeatedDraws, Indices) {
  const GLuint other = make_buffer(GL_ELEMENT_ARRAY_BUFFER, std::vector<GLushort>{0, 1, 2, 0, 1, 2, 0, 1, 2});
  const auto bind = [](GLuint buffer) { glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer); };
  expect_own_pictures([&] { bind(indices_); }, [&] { bind(other); }, draw_elements);
}

TEST_P(RepeatedDraws, CurrentValues) {
  glDisableVertexAttribArray(1);
  expect_own_pictures([] { glVertexAttrib3f(1, 1, 0.5F, 0); }, [] { glVertexAttrib3f(1, 0, 0.5F, 1); }, draw_elements);
}

TEST_P(RepeatedDraws, ArraysAndCurrentValues) {
  glVertexAttrib3f(1, 0, 0.5F, 1);
  expect_own_pictures([] { glEnableVertexAttribArray(1); }, [] { glDisableVertexAttribArray(1); }, draw_elements);
}

TEST_P(RepeatedDraws, Restart) {
  glPrimitiveRestartIndex(2);
  const auto draw = [] { glDrawElements(GL_TRIANGLE_STRIP, 9, GL_UNSIGNED_SHORT, nullptr); };
  expect_own_pictures([] { glDisable(GL_PRIMITIVE_RESTART); }, [] { glEnable(GL_PRIMITIVE_RESTART); }, draw);
}

TEST_P(RepeatedDraws, Levels) {
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK);
  for (const GLuint tag : {1U, 2U, 1U}) {
    glDepthTag1i(tag);
    repeat_often(draw_elements);
    picture_of(draw_elements);
    EXPECT_EQ(generated_primitives, 3U << (2 * tag));
  }
  for (const GLuint level : {1U, 2U, 1U}) {
    refine_uniformly(level, GL_LINEAR_INPUTS_ARK);
    repeat_often(draw_elements);
    picture_of(draw_elements);
    EXPECT_EQ(generated_primitives, 3U << (2 * level));
  }
}

TEST_P(RepeatedDraws, ABufferThatIsWritten) {
  const auto write = [&](const std::vector<ColoredVertex>& vertices) {
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBufferSubData(GL_ARRAY_BUFFER, 0, bytes, vertices.data());
  };
  expect_changes_seen([&] { write(two()); }, [&] { write(one()); }, draw_elements);
}

TEST_P(RepeatedDraws, FixedFunction) {
  if (GetParam() == Profile::core) GTEST_SKIP() << "compatibility contexts only";
  glUseProgram(0);
  for (const GLuint attribute : {0U, 1U, 2U}) glDisableVertexAttribArray(attribute);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, sizeof(ColoredVertex), nullptr);
  glColor3f(1, 0.5F, 0);
  const GLfloat light[4] = {0, 1, 0, 1};
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, light);
  expect_own_pictures([] { glDisable(GL_LIGHTING); }, [] { glEnable(GL_LIGHTING); }, draw_elements);
  glDisable(GL_LIGHTING);
  expect_own_pictures([] { glColor3f(1, 0.5F, 0); }, [] { glColor3f(0, 0.5F, 1); }, draw_elements);
  glEnableClientState(GL_COLOR_ARRAY);
  glColorPointer(3, GL_FLOAT, sizeof(ColoredVertex), byte_offset(8));
  expect_own_pictures([] { glShadeModel(GL_SMOOTH); }, [] { glShadeModel(GL_FLAT); }, draw_elements);
}

}  // namespace
}  // namespace glark::core::test
