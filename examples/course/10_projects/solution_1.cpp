// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 1 of lesson 10: a letter to bake. The blocks of a letter become one soft shape. Its front and its back
// should be flat with hard edges, as if cut out with a form; its outline stays round.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>
#include <glark/qas.h>

#include <string_view>
#include <vector>

#include "examples/common/blocks.h"
#include "examples/common/lesson.h"
#include "examples/common/look.h"
#include "examples/common/program.h"

namespace {

constexpr GLuint point = 0, normal = 2;
GLuint program = 0;

constexpr std::string_view letter = R"(
XXXXX
X....
X.XXX
X...X
XXXXX
)";

// Pairs of vertices: the edges between a wall and the front or the back.
std::vector<std::uint32_t> rim(const lesson::BlockMesh& mesh) {
  std::vector<std::uint32_t> creases;
  const auto z = [&](std::uint32_t vertex) { return mesh.positions[3 * std::size_t{vertex} + 2]; };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::size_t first = i / 3 * 3;
    const std::uint32_t a = mesh.triangles[i];
    const std::uint32_t b = mesh.triangles[first + (i + 1) % 3], c = mesh.triangles[first + (i + 2) % 3];
    if (z(a) == z(b) && z(a) != z(c)) creases.insert(creases.end(), {a, b});
  }
  return creases;
}

constexpr const char* vertex_shader = R"glsl(#version 130
in mat2x3 point;
in mat2x3 normal;
out vec3 passed_normal;
void main() {
  passed_normal = gl_NormalMatrix * normal[0];
  gl_Position = gl_ModelViewProjectionMatrix * vec4(point[0], 1.0);
}
)glsl";

constexpr const char* fragment_shader = R"glsl(#version 130
in vec3 passed_normal;
void main() {
  float light = max(dot(normalize(passed_normal), normalize(vec3(-0.5, 0.7, 0.8))), 0.0);
  gl_FragColor = vec4(vec3(0.8, 0.55, 0.3) * (0.4 + 0.7 * light), 1.0);
}
)glsl";

void begin() {
  glARKinit(4);
  glEnable(GL_ARK);
  glEnable(GL_DEPTH_TEST);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 4);
  program = lesson::make_program(vertex_shader, fragment_shader, {"point", "unused", "normal"});
  lesson::set_refinement_shader(program,
                                glark::qas::refinement_shader({"point[0]", "point[1]", "normal[0]", "normal[1]"}));
}

void draw(double) {
  const lesson::BlockMesh mesh = lesson::make_blocks(letter);
  const std::vector<std::uint32_t> creases = rim(mesh);
  glark::qas::Surface surface({mesh.positions.size() / 3, mesh.triangles, creases});
  std::vector<glark::qas::Corner> corners(surface.corner_count());
  surface.update(mesh.positions);
  surface.write_corners(corners);
  lesson::look(9, -30, 15);
  glUseProgram(program);
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

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv,
                     {.title = "Lesson 10, exercise 1: a letter", .keys = {}, .begin = begin, .draw = draw});
}
