// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Solution 3: a colour is an attribute, and attributes are interpolated.
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
  vec3 to_lamp = lamp - gl_Vertex.xyz;
  float near = 1.0 / (0.1 + dot(to_lamp, to_lamp));
  color = gl_Color.rgb * (0.2 + 0.5 * near * normalize(to_lamp).y);
  gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
})glsl";

constexpr const char* fragment_shader = R"glsl(#version 130
in vec3 color;
void main() { gl_FragColor = vec4(color, 1.0); }
)glsl";

void table() {
  constexpr float corners[4][3] = {{-1, 0, 1}, {1, 0, 1}, {-1, 0, -1}, {1, 0, -1}};
  constexpr float colors[4][3] = {{1, 0.4F, 0.3F}, {1, 0.9F, 0.3F}, {0.3F, 0.6F, 1}, {0.4F, 0.9F, 0.5F}};
  glBegin(GL_TRIANGLE_STRIP);
  for (int i = 0; i < 4; ++i) {
    glColor3fv(colors[i]);
    glVertex3fv(corners[i]);
  }
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
  return lesson::run(argc, argv, {.title = "Lesson 5, solution 3", .keys = {}, .begin = begin, .draw = draw});
}
