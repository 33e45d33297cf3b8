// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 2: roll the table into a tube around the z axis, in the vertex shader. x runs from -1 to 1: once around.
// The radius is 0.6, and x = 0 is at the top.
#define GL_GLEXT_PROTOTYPES
#include "examples/common/lesson.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>

#include "examples/common/look.h"
#include "examples/common/program.h"

namespace {

GLuint program = 0;

constexpr const char* vertex_shader = R"glsl(#version 120
varying vec3 color;
void main() {
  vec3 position = gl_Vertex.xyz;
  vec3 normal = vec3(0.0, 1.0, 0.0);
  // Compute the position and the normal here.
  color = gl_Color.rgb * (0.25 + 0.75 * max(0.0, dot(normal, normalize(vec3(0.5, 0.7, 0.6)))));
  gl_Position = gl_ModelViewProjectionMatrix * vec4(position, 1.0);
})glsl";

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
  glARKinit(5);
  glEnable(GL_ARK);
  glEnable(GL_DEPTH_TEST);
  program = lesson::make_program(vertex_shader, fragment_shader);
}

void draw(double) {
  lesson::look(4, 25, 40);
  glUseProgram(program);
  glColor3f(0.5F, 0.8F, 1);
  glDepthTag1i(5);
  table();
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 5, exercise 2", .keys = {}, .begin = begin, .draw = draw});
}
