// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// --refine smooth: quads whose corners are moved by an attribute with the name of a normal. It has the other end of a thick
// line, or an offset from the middle of a ball.
#include <array>
#include <vector>

#include "tests/core/meshes/ball.h"
#include "tests/core/meshes/under_glark_run.h"

namespace glark::core::test {
namespace {

struct LineVertex {
  std::array<GLfloat, 3> position;
  std::array<GLfloat, 4> normal;
};

// A square of four lines, leaning so that their ends have different depths.
std::vector<LineVertex> square_of_lines() {
  constexpr std::array<std::array<GLfloat, 3>, 4> ends{
      {{-0.6F, -0.5F, 0}, {0.6F, -0.6F, 0.3F}, {0.5F, 0.6F, 0}, {-0.6F, 0.5F, 0.3F}}};
  std::vector<LineVertex> vertices;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const std::array<GLfloat, 3> a = ends.at(i);
    const std::array<GLfloat, 3> b = ends.at((i + 1) % ends.size());
    const std::array<LineVertex, 4> corners{{{a, {b[0], b[1], b[2], 1}},
                                             {a, {b[0], b[1], b[2], -1}},
                                             {b, {a[0], a[1], a[2], -1}},
                                             {b, {a[0], a[1], a[2], 1}}}};
    for (const std::size_t corner : {0U, 2U, 1U, 1U, 2U, 3U}) vertices.push_back(corners.at(corner));
  }
  return vertices;
}

std::vector<Picture> frames_of_lines() {
  const OsmesaContext context{Profile::core};
  const GLuint program = link_program(
      {.vertex = "#version 430\nin vec3 position; in vec4 normal; out vec3 shade;\n"
                 "void main() { vec2 along = normalize(normal.xy - position.xy); shade = vec3(1.0);\n"
                 "  gl_Position = vec4(position, 1.0) + vec4(vec2(-along.y, along.x) * 0.05 * normal.w, 0.0, 0.0); }\n",
       .fragment = "#version 430\nin vec3 shade; out vec4 color;\nvoid main() { color = vec4(shade, 1.0); }\n",
       .attributes = {"position", "normal"}});
  glUseProgram(program);
  GLuint vertex_array = 0;
  glGenVertexArrays(1, &vertex_array);
  glBindVertexArray(vertex_array);
  make_buffer(GL_ARRAY_BUFFER, square_of_lines());
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(LineVertex), nullptr);
  glVertexAttribPointer(1, 4, GL_FLOAT, GL_FALSE, sizeof(LineVertex), byte_offset(12));
  for (const GLuint location : {0, 1}) glEnableVertexAttribArray(location);
  glEnable(GL_DEPTH_TEST);
  return draw_frames(5, [] { glDrawArrays(GL_TRIANGLES, 0, 24); });
}

TEST(ThickLines, AreNoSurface) {
  ASSERT_TRUE(as_under_glark_run);
  const std::vector<Picture> frames = frames_of_lines();
  EXPECT_GT(covered_pixels(frames[0]), 100);
  EXPECT_TRUE(frames[4] == frames[0]);
}

// Squares whose corners have the position of the middle. The normal moves them away from it. `length`: of the normals.
std::vector<Picture> frames_of_squares(GLfloat length) {
  const OsmesaContext context{Profile::core};
  glUseProgram(link_program(
      {.vertex = "#version 430\nin vec3 position; in vec3 normal; out vec2 at;\n"
                 "void main() { at = normal.xy; gl_Position = vec4(position + normal * 0.5, 1.0); }\n",
       .fragment = "#version 430\nin vec2 at; out vec4 color;\nvoid main() { color = vec4(1.0, abs(at), 1.0); }\n",
       .attributes = {"position", "normal"}}));
  GLuint vertex_array = 0;
  glGenVertexArrays(1, &vertex_array);
  glBindVertexArray(vertex_array);
  const GLfloat side = length * 0.7071F;
  std::vector<std::array<GLfloat, 6>> vertices;
  for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {-1, 1}, {-1, 1}, {1, -1}, {1, 1}}) {
    vertices.push_back({0, 0, 0, side * static_cast<GLfloat>(x), side * static_cast<GLfloat>(y), 0});
  }
  make_buffer(GL_ARRAY_BUFFER, vertices);
  for (const GLuint location : {0U, 1U}) {
    glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, 24, byte_offset(12 * location));
    glEnableVertexAttribArray(location);
  }
  glEnable(GL_DEPTH_TEST);
  return draw_frames(5, [] { glDrawArrays(GL_TRIANGLES, 0, 6); });
}

TEST(SquaresOfOffsets, AreNoSurface) {
  ASSERT_TRUE(as_under_glark_run);
  const std::vector<Picture> frames = frames_of_squares(0.8F);
  EXPECT_GT(covered_pixels(frames[0]), 100);
  EXPECT_TRUE(frames[4] == frames[0]);
}

}  // namespace
}  // namespace glark::core::test
