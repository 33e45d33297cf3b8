// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 3: this shader reads gl_VertexID. A refined vertex has no number, so glark interpolates the outputs.
// Give the colours to the vertices with glColor3f, and use gl_Color in the shader.
#define GL_GLEXT_PROTOTYPES
#include "examples/common/lesson.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>

#include "examples/common/look.h"
#include "examples/common/program.h"

namespace {

GLuint program = 0;

constexpr const char* vertex_shader = R"glsl(#version 130
uniform vec3 lamp;
out vec3 color;
void main() {
  vec3 colors[4] = vec3[4](vec3(1, 0.4, 0.3), vec3(1, 0.9, 0.3), vec3(0.3, 0.6, 1), vec3(0.4, 0.9, 0.5));
  vec3 own = colors[gl_VertexID % 4];
  vec3 to_lamp = lamp - gl_Vertex.xyz;
  float near = 1.0 / (0.1 + dot(to_lamp, to_lamp));
  color = own * (0.2 + 0.5 * near * normalize(to_lamp).y);
  gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
})glsl";

constexpr const char* fragment_shader = R"glsl(#version 130
in vec3 color;
void main() { gl_FragColor = vec4(color, 1.0); }
)glsl";

void table() {
  constexpr float corners[4][3] = {{-1, 0, 1}, {1, 0, 1}, {-1, 0, -1}, {1, 0, -1}};
  glBegin(GL_TRIANGLE_STRIP);
  for (const auto& corner : corners) glVertex3fv(corner);
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
  lesson::set_uniform(program, "lamp", 0.2F, 0.5F, 0.1F);
  glDepthTag1i(5);
  table();
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 5, exercise 3", .keys = {}, .begin = begin, .draw = draw});
}
