// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Lesson 5: what the vertex shader sees. On the left it runs three times for each coarse triangle, and its outputs are
// interpolated. On the right its inputs are interpolated, and it runs on every refined vertex.
#define GL_GLEXT_PROTOTYPES
#include "examples/common/lesson.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>

#include "examples/common/look.h"
#include "examples/common/program.h"

namespace {

constexpr unsigned deepest = 5;
unsigned depth = 0;
float wave = 0;
bool edges = false;
GLuint program = 0;

// [shader]
constexpr const char* vertex_shader = R"glsl(#version 120
uniform float wave;
uniform vec3 lamp;
varying vec3 color;
void main() {
  vec3 position = gl_Vertex.xyz;
  position.y += wave * sin(6.0 * position.x);
  vec3 normal = normalize(vec3(-6.0 * wave * cos(6.0 * position.x), 1.0, 0.0));
  vec3 to_lamp = lamp - position;
  float near = 1.0 / (0.1 + dot(to_lamp, to_lamp));
  color = gl_Color.rgb * (0.2 + 0.5 * near * max(0.0, dot(normal, normalize(to_lamp))));
  gl_Position = gl_ModelViewProjectionMatrix * vec4(position, 1.0);
})glsl";
// [/shader]

constexpr const char* fragment_shader = R"glsl(#version 120
varying vec3 color;
void main() { gl_FragColor = vec4(color, 1.0); }
)glsl";

// A table of two triangles.
void table() {
  glBegin(GL_TRIANGLE_STRIP);
  glVertex3f(-1, 0, 1);
  glVertex3f(1, 0, 1);
  glVertex3f(-1, 0, -1);
  glVertex3f(1, 0, -1);
  glEnd();
}

void begin() {
  glARKinit(deepest);
  glEnable(GL_ARK);
  glEnable(GL_DEPTH_TEST);
  program = lesson::make_program(vertex_shader, fragment_shader);
}

void draw(double) {
  glUseProgram(program);
  lesson::set_uniform(program, "lamp", 0.2F, 0.5F, 0.1F);
  lesson::set_uniform(program, "wave", wave);
  glColor3f(1, 0.8F, 0.5F);
  glDepthTag1i(depth);
  for (const int part : {0, 1}) {
    lesson::use_part(part, 2);
    lesson::look(4, 25, 40);
    // [draw]
    glARKParameteriARK(GL_REFINEMENT_ARK, part == 0 ? GL_LINEAR_OUTPUTS_ARK : GL_LINEAR_INPUTS_ARK);
    if (edges) lesson::draw_with_edges(table);
    if (!edges) table();
    // [/draw]
  }
  lesson::say("depth %u: %u triangles on each side", depth, lesson::count_triangles(table));
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv,
                     {.title = "Lesson 5, outputs (left) and inputs (right)",
                      .keys = {{'d', "one level deeper", [] { depth = depth < deepest ? depth + 1 : depth; }},
                               {'s', "one level shallower", [] { depth = depth > 0 ? depth - 1 : depth; }},
                               {'v', "waves on or off", [] { wave = wave == 0 ? 0.12F : 0; }},
                               {'w', "wireframe", [] { edges = !edges; }}},
                      .begin = begin,
                      .draw = draw});
}
