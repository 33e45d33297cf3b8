// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Shared by tests of kept captures: a scene of coloured triangles in buffers, and ways to see that a draw was captured.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "tests/core/support/modes.h"
#include "tests/core/support/programs.h"
#include "tests/core/support/scene.h"

namespace glark::core::test {

// A capture submits the vertices of the application once more.
inline GLuint64 submitted_vertices(const std::function<void()>& draw) {
  GLuint query = 0;
  GLuint64 count = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_VERTICES_SUBMITTED, query);
  draw();
  glEndQuery(GL_VERTICES_SUBMITTED);
  glGetQueryObjectui64v(query, GL_QUERY_RESULT, &count);
  glDeleteQueries(1, &query);
  return count;
}

// From then on, the refined vertices of a draw that may keep them are kept.
inline void repeat_often(const std::function<void()>& draw) {
  for (int i = 0; i < 20; ++i) draw();
}

// The vertices of a draw that is kept.
inline GLuint64 settle(const std::function<void()>& draw) {
  const GLuint64 first = submitted_vertices(draw);
  repeat_often(draw);
  const GLuint64 kept = submitted_vertices(draw);
  EXPECT_LT(kept, first) << "the draw is captured each time";
  return kept;
}

// After `change`, the draw is the same as before: nothing is captured.
inline void expect_kept(const std::function<void()>& draw, const std::function<void()>& change) {
  const GLuint64 kept = settle(draw);
  for (int i = 0; i < 3; ++i) {
    change();
    EXPECT_EQ(submitted_vertices(draw), kept) << "repetition " << i;
  }
  EXPECT_EQ(pending_errors(), "");
}

inline void expect_captured_again(const std::function<void()>& draw, const std::function<void()>& change) {
  const GLuint64 kept = settle(draw);
  change();
  EXPECT_GT(submitted_vertices(draw), kept);
  EXPECT_EQ(pending_errors(), "");
}

// The draw is kept. `change` shows in the picture as it does without refinement.
inline void expect_seen(const std::function<void()>& draw, const std::function<void()>& change) {
  const Picture before = picture_of(draw);
  repeat_often(draw);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(differing_pixels(before, picture_of(draw)), 0);
  change();
  const Picture after = picture_of(draw);
  EXPECT_EQ(generated_primitives % 16, 0U);
  EXPECT_GT(generated_primitives, 0U);
  for (int i = 0; i < 2; ++i) EXPECT_EQ(differing_pixels(after, picture_of(draw)), 0);
  glDisable(GL_ARK);
  const Picture plain = picture_of(draw);
  EXPECT_LE(differing_pixels(plain, after), tolerated_pixels);
  EXPECT_GT(differing_pixels(plain, before), visible_pixels) << "the change does not show";
  EXPECT_EQ(pending_errors(), "");
}

// Six coloured vertices: a strip of four triangles.
inline std::vector<ColoredVertex> first_vertices() { return mode_shapes()[1].vertices; }
inline std::vector<ColoredVertex> other_vertices() {
  std::vector<ColoredVertex> vertices = first_vertices();
  for (ColoredVertex& v : vertices)
    v = {{v.position[0] * 0.6F, v.position[1] * -0.7F}, {v.color[2], v.color[0], v.color[1]}};
  return vertices;
}

class KeptScene : public testing::TestWithParam<Profile> {
 protected:
  KeptScene() {
    glGenVertexArrays(1, &array_);
    glBindVertexArray(array_);
    vertices_ = make_buffer(GL_ARRAY_BUFFER, one());
    point_generic_arrays(nullptr);
    indices_ = make_buffer(GL_ELEMENT_ARRAY_BUFFER, std::vector<GLushort>{0, 1, 2, 2, 1, 3, 3, 4, 5});
    program_ = link_program(
        {.vertex =
             "#version 430\nlayout(location = 0) in vec2 position; layout(location = 1) in vec3 color; out vec3 c;\n"
             "void main() { gl_Position = vec4(position, 0.0, 1.0); c = color; }\n",
         .fragment = "#version 430\nin vec3 c; out vec4 result;\nvoid main() { result = vec4(c, 1.0); }\n"});
    glUseProgram(program_);
    refine_uniformly(2);
  }
  static std::vector<ColoredVertex> one() { return first_vertices(); }
  static std::vector<ColoredVertex> two() { return other_vertices(); }
  static constexpr GLsizeiptr bytes = 6 * sizeof(ColoredVertex);
  static void draw_arrays() { glDrawArrays(GL_TRIANGLE_STRIP, 0, 6); }
  static void draw_elements() { glDrawElements(GL_TRIANGLES, 9, GL_UNSIGNED_SHORT, nullptr); }

  OsmesaContext context_{GetParam()};
  GLuint array_ = 0;
  GLuint program_ = 0;
  GLuint vertices_ = 0;
  GLuint indices_ = 0;
};

}  // namespace glark::core::test
