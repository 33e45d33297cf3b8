// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Lesson 10, project 1: a character of blocks, subdivided while it is drawn. In every frame, glark-qas computes one
// step of Loop's scheme for the coarse mesh; a refinement shader fits quadratic patches to the result.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>
#include <glark/qas.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "examples/common/blocks.h"
#include "examples/common/lesson.h"
#include "examples/common/look.h"
#include "examples/common/program.h"

namespace {

constexpr GLuint point = 0, normal = 2;  // attributes; a matrix takes two locations
constexpr int deepest = 4;
int depth = 3;
bool cage = false, wireframe = false;
GLuint program = 0;

// [blocks]
constexpr std::string_view blocks = R"(
..XXX..
..XXX..
X..X..X
XXXXXXX
..XXX..
..XXX..
..X.X..
..X.X..
.XX.XX.
)";
// [/blocks]

// [shaders]
// One input has a point and the middle of the edge to the next corner. The refinement shader reads both.
constexpr const char* vertex_shader = R"glsl(#version 130
in mat2x3 point;
in mat2x3 normal;
out vec3 passed_normal;
void main() {
  passed_normal = gl_NormalMatrix * normal[0];
  gl_Position = gl_ModelViewProjectionMatrix * vec4(point[0], 1.0);
}
)glsl";
// [/shaders]

constexpr const char* fragment_shader = R"glsl(#version 130
in vec3 passed_normal;
uniform vec3 colour;
void main() {
  float light = max(dot(normalize(passed_normal), normalize(vec3(-0.5, 0.7, 0.8))), 0.0);
  gl_FragColor = vec4(colour * (0.4 + 0.7 * light) + 0.3 * pow(light, 30.0), 1.0);
}
)glsl";

// [begin]
void begin() {
  glARKinit(deepest);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  program = lesson::make_program(vertex_shader, fragment_shader, {"point", "unused", "normal"});
  lesson::set_refinement_shader(program,
                                glark::qas::refinement_shader({"point[0]", "point[1]", "normal[0]", "normal[1]"}));
}
// [/begin]

// [wave]
// The arms wave: what lies beside the body moves up and down.
std::vector<float> waving(const std::vector<float>& rest, double seconds) {
  const float swing = std::sin(3 * static_cast<float>(seconds));
  std::vector<float> moved = rest;
  for (std::size_t i = 0; i < rest.size(); i += 3) {
    const float beside = std::max(std::abs(rest[i]) - 1.5F, 0.0F);
    moved[i] -= std::copysign(0.3F * swing * swing * beside, rest[i]);
    moved[i + 1] += 0.9F * swing * beside;
  }
  return moved;
}
// [/wave]

// [draw]
void draw_surface(const std::vector<glark::qas::Corner>& corners) {
  const auto column = [](GLuint location, const float* first) {
    glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(glark::qas::Corner), first);
    glEnableVertexAttribArray(location);
  };
  column(point, corners[0].position.data());
  column(point + 1, corners[0].edge_position.data());
  column(normal, corners[0].normal.data());
  column(normal + 1, corners[0].edge_normal.data());
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
}
// [/draw]

// The coarse mesh that controls the surface, as lines.
void draw_cage(const std::vector<float>& positions, const std::vector<std::uint32_t>& triangles) {
  glUseProgram(0);
  glDisable(GL_ARK);
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  glColor3f(0.2F, 0.2F, 0.5F);
  glBegin(GL_TRIANGLES);
  for (const std::uint32_t vertex : triangles) glVertex3fv(&positions[3 * std::size_t{vertex}]);
  glEnd();
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

// [frame]
void draw(double seconds) {
  static const lesson::BlockMesh mesh = lesson::make_blocks(blocks);
  static glark::qas::Surface surface({mesh.positions.size() / 3, mesh.triangles});
  static std::vector<glark::qas::Corner> corners(surface.corner_count());
  const std::vector<float> positions = waving(mesh.positions, seconds);
  surface.update(positions);
  surface.write_corners(corners);

  lesson::look(12.5F, -25, 10);
  glEnable(GL_DEPTH_TEST);
  if (cage) draw_cage(positions, mesh.triangles);
  glUseProgram(program);
  glEnable(GL_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, depth);
  lesson::set_uniform(program, "colour", 0.85F, 0.5F, 0.25F);
  if (wireframe) lesson::draw_with_edges([] { draw_surface(corners); });
  if (!wireframe) draw_surface(corners);
}
// [/frame]

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv,
                     {.title = "Lesson 10: a character",
                      .keys = {{'d', "one level deeper", [] { depth = std::min(depth + 1, deepest); }},
                               {'s', "one level shallower", [] { depth = std::max(depth - 1, 0); }},
                               {'m', "the coarse mesh, as lines", [] { cage = !cage; }},
                               {'w', "wireframe", [] { wireframe = !wireframe; }}},
                      .begin = begin,
                      .draw = draw});
}
