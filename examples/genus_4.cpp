// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A coarse mesh gives the topology of a surface, a refinement shader its shape. A slab of 136 triangles with four holes
// becomes a smooth body: each refined vertex moves onto the zero of a function. Then the body twists. Transform
// feedback reads the drawn triangles back: they form a closed surface, and Euler's formula finds the four holes.
//
//   genus_4 [OUT.png [--press e] [--seconds 1]]
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "examples/common/blocks.h"
#include "examples/common/lesson.h"
#include "examples/common/look.h"
#include "examples/common/program.h"

namespace {

constexpr const char* vertex_shader = R"glsl(#version 120
varying float light;
void main() {
  vec3 normal = normalize(gl_NormalMatrix * gl_Normal);
  light = 0.3 + 0.7 * abs(dot(normal, normalize(vec3(-0.4, 0.5, 0.9))));
  gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
})glsl";

constexpr const char* fragment_shader = R"glsl(#version 120
varying float light;
void main() { gl_FragColor = vec4(vec3(0.75, 0.55, 0.8) * light, 1.0); }
)glsl";

// The body is the space within 0.28 of the middle plane and outside the holes. Each vertex moves along the gradient of
// this function.
constexpr const char* refinement_shader = R"glsl(
uniform float twist;

float body(vec3 p) {
  float inside = 2.1 - sqrt(length(p.xy * p.xy));              // a rounded square
  float hole = length(abs(p.xy) - 0.8) - 0.42;                 // four round holes
  float blend = clamp(0.5 + (inside - hole) / 0.6, 0.0, 1.0);  // a smooth minimum
  inside = mix(inside, hole, blend) - 0.3 * blend * (1.0 - blend);
  return length(vec2(max(0.28 - inside, 0.0), p.z)) - 0.28;
}

vec3 slope(vec3 p) {
  const vec2 h = vec2(0.01, 0.0);
  return vec3(body(p + h.xyy) - body(p - h.xyy), body(p + h.yxy) - body(p - h.yxy),
              body(p + h.yyx) - body(p - h.yyx)) / 0.02;
}

void refine() {
  vec3 position = gl_Vertex.xyz;
  for (int step = 0; step < 8; ++step) {
    vec3 s = slope(position);
    position -= body(position) * s / max(dot(s, s), 0.1);
  }
  vec3 normal = normalize(slope(position));
  float turn = twist * position.x;
  mat2 rotation = mat2(cos(turn), sin(turn), -sin(turn), cos(turn));
  gl_Vertex = vec4(position.x, rotation * position.yz, 1.0);
  gl_Normal = vec3(normal.x, rotation * normal.yz);  // approximate: the twist shears as well
}
)glsl";

constexpr std::string_view drawing = "XXXXX\nX.X.X\nXXXXX\nX.X.X\nXXXXX";
lesson::BlockMesh slab = lesson::make_blocks(drawing);
std::vector<unsigned char> tags;  // fine around the holes
GLuint program = 0;
bool edges = false;

void draw_slab() {
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(slab.triangles.size()), GL_UNSIGNED_INT, slab.triangles.data());
}

// Returns the genus of the surface that draw_slab() draws, or -1 if it is not closed. For a closed surface of genus g,
// V - E + F is 2 - 2 g. Vertices with the same bits are one vertex.
int genus() {
  using Point = std::array<float, 4>;
  std::vector<Point> points(std::size_t{3} * lesson::count_triangles(draw_slab));
  const GLuint buffer = lesson::make_buffer(GL_TRANSFORM_FEEDBACK_BUFFER, points);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  glBeginTransformFeedback(GL_TRIANGLES);
  draw_slab();
  glEndTransformFeedback();
  glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, static_cast<GLsizeiptr>(points.size() * sizeof(Point)),
                     points.data());
  const std::set<Point> vertices(points.begin(), points.end());
  std::map<std::pair<Point, Point>, int> sides;
  for (std::size_t i = 0; i < points.size(); ++i) ++sides[std::minmax(points[i], points[i % 3 == 2 ? i - 2 : i + 1])];
  const bool closed = std::all_of(sides.begin(), sides.end(), [](const auto& side) { return side.second == 2; });
  const auto characteristic = static_cast<int>(vertices.size() + points.size() / 3) - static_cast<int>(sides.size());
  return closed ? (2 - characteristic) / 2 : -1;
}

void begin() {
  for (std::size_t i = 0; i < slab.positions.size(); i += 3) {
    float* const at = &slab.positions[i];
    tags.push_back(std::max(std::abs(at[0]), std::abs(at[1])) > 2 ? 2 : 4);
    for (const int axis : {0, 1, 2}) at[axis] *= axis == 2 ? 0.6F : 0.8F;
  }
  glARKinit(4);
  glEnable(GL_ARK);
  glEnable(GL_DEPTH_TEST);
  program = lesson::make_program(vertex_shader, fragment_shader);
  const char* const varying = "gl_Position";
  glTransformFeedbackVaryings(program, 1, &varying, GL_INTERLEAVED_ATTRIBS);
  glLinkProgram(program);
  lesson::set_refinement_shader(program, refinement_shader);
  glUseProgram(program);
  glVertexPointer(3, GL_FLOAT, 0, slab.positions.data());
  glEnableClientState(GL_VERTEX_ARRAY);
  glDepthTagPointerARK(GL_UNSIGNED_BYTE, 0, tags.data());
  glEnableClientState(GL_DEPTH_TAG_ARRAY_ARK);
  const int found = genus();
  lesson::say("genus %d", found);
  if (found != 4) throw std::runtime_error("the body does not have four holes");
}

void draw(double seconds) {
  lesson::look(7.5F, 20, 40);
  glRotatef(-90, 1, 0, 0);
  lesson::set_uniform(program, "twist", 0.4F * static_cast<float>(std::sin(seconds)));
  if (edges) lesson::draw_with_edges(draw_slab);
  if (!edges) draw_slab();
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(
      argc, argv,
      {.title = "genus_4", .keys = {{'e', "edges on or off", [] { edges = !edges; }}}, .begin = begin, .draw = draw});
}
