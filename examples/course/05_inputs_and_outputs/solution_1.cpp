// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Solution 1: with inputs, the shader computes the light at every refined vertex.
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
uniform vec3 lamp;
varying vec3 color;
void main() {
  vec3 to_lamp = lamp - gl_Vertex.xyz;
  float near = 1.0 / (0.1 + dot(to_lamp, to_lamp));
  color = gl_Color.rgb * (0.2 + 0.5 * near * normalize(to_lamp).y);
  gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
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
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_INPUTS_ARK);  // also what GL_ARK begins with
  program = lesson::make_program(vertex_shader, fragment_shader);
}

void draw(double) {
  lesson::look(4, 25, 40);
  glUseProgram(program);
  lesson::set_uniform(program, "lamp", 0.2F, 0.5F, 0.1F);
  glColor3f(1, 0.8F, 0.5F);
  glDepthTag1i(5);
  table();
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 5, solution 1", .keys = {}, .begin = begin, .draw = draw});
}
