// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A subdivision surface in real time: a toy of 76 triangles bends. On the left is the coarse toy, on the right the
// surface that it controls. In every frame, the library glark-qas computes one step of Loop's scheme on the CPU. The
// refinement shader fits two quadratic patches to each triangle, one for positions and one for normals. Vertices near
// the eye have greater depth tags.
//
//   qas_surface [OUT.png [--seconds 1]]      the moment of the animation
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>
#include <glark/qas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "examples/common/blocks.h"
#include "examples/common/lesson.h"
#include "examples/common/look.h"
#include "examples/common/program.h"

namespace {

constexpr unsigned deepest = 5;

constexpr std::string_view drawing = R"(
..X..
..X..
XXXXX
..X..
..X..
)";
const lesson::BlockMesh toy = lesson::make_blocks(drawing);

// Bends the toy: its arms turn about the z axis. The angle grows with the distance from the axis.
std::vector<float> bent(const std::vector<float>& rest, float seconds) {
  std::vector<float> positions = rest;
  for (std::size_t i = 0; i < rest.size(); i += 3) {
    const float x = rest[i], y = rest[i + 1];
    const float angle = 0.35F * std::sin(2 * seconds) * std::hypot(x, y);
    positions[i] = x * std::cos(angle) - y * std::sin(angle);
    positions[i + 1] = x * std::sin(angle) + y * std::cos(angle);
  }
  return positions;
}

// One input has a point and the middle of the edge to the next corner. The refinement shader reads both; the vertex
// stage reads the point.
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
  vec3 n = normalize(passed_normal), light = normalize(vec3(-0.5, 0.6, 0.8));
  float shine = pow(max(dot(n, normalize(light + vec3(0.0, 0.0, 1.0))), 0.0), 40.0);
  gl_FragColor = vec4(vec3(0.9, 0.45, 0.15) * (0.25 + 0.75 * max(dot(n, light), 0.0)) + 0.5 * shine, 1.0);
}
)glsl";

enum : GLuint { point = 0, normal = 2, tag = 4 };  // a matrix takes two locations

// Sends the corners of the patches. Tags come from the distances of vertices, so triangles agree on common edges.
void point_to_corners(const glark::qas::Surface& surface, const std::vector<float>& positions) {
  using glark::qas::Corner;
  static std::vector<Corner> corners(surface.corner_count());
  static std::vector<float> tags;
  surface.write_corners(corners);
  tags.clear();
  for (const auto& [a, b] : surface.corner_vertices()) {  // half-way between two vertices
    const float towards_eye = positions[3 * a + 2] + positions[3 * b + 2];
    tags.push_back(std::clamp(4 + towards_eye, 3.0F, 1.0F * deepest));
  }
  const std::array<const float*, 4> columns = {corners[0].position.data(), corners[0].edge_position.data(),
                                               corners[0].normal.data(), corners[0].edge_normal.data()};
  for (GLuint i = 0; i < 4; ++i) {
    glVertexAttribPointer(point + i, 3, GL_FLOAT, GL_FALSE, sizeof(Corner), columns[i]);
    glEnableVertexAttribArray(point + i);
  }
  glDepthTagPointerARK(GL_FLOAT, 0, tags.data());
  glEnable(GL_DEPTH_TAG_ARRAY_ARK);
}

std::optional<glark::qas::Surface> surface;
GLuint program = 0;

// Runs once: the topology, the program, the buffers.
void begin() {
  glARKinit(deepest);
  glARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, tag);
  glEnable(GL_DEPTH_TEST);
  surface.emplace(glark::qas::Mesh{toy.positions.size() / 3, toy.triangles});
  program = lesson::make_program(vertex_shader, fragment_shader, {"point", nullptr, "normal"});
  lesson::set_refinement_shader(program,
                                glark::qas::refinement_shader({"point[0]", "point[1]", "normal[0]", "normal[1]"}));
}

// Runs in every frame: the mesh moves, its limit points follow, and the patches are refined while they are drawn.
void draw(double seconds) {
  const std::vector<float> positions = bent(toy.positions, 0.5F + static_cast<float>(seconds));
  lesson::use_part(0, 2);
  lesson::look(6.6F, -30, 30);
  glUseProgram(0);
  glColor3f(0.95F, 0.85F, 0.7F);
  lesson::draw_with_edges([&] {
    glBegin(GL_TRIANGLES);
    for (const std::uint32_t vertex : toy.triangles) glVertex3fv(&positions[3 * std::size_t{vertex}]);
    glEnd();
  });
  lesson::use_part(1, 2);
  surface->update(positions);
  point_to_corners(*surface, positions);
  glUseProgram(program);
  glEnable(GL_ARK);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(surface->corner_count()));
  glDisable(GL_ARK);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv,
                     {.title = "qas_surface", .keys = {}, .begin = begin, .draw = draw, .width = 1024, .height = 512});
}
