// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 2 of lesson 8: repair the refinement shader. It has three mistakes. The log names them one after the other.
// A repaired shader makes a saddle.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>

#include "examples/common/lesson.h"
#include "examples/common/look.h"
#include "examples/common/program.h"

namespace {

constexpr const char* saddle = R"glsl(
void refine() {
  const float bend = 0.5;
  gl_Vertex.y += bend * (gl_Vertex.x * gl_Vertex.x - gl_Vertex.z * gl_Vertex.z);
  gl_Normal = normalize(vec3(-2.0 * bend * gl_Vertex.x, 1.0, 2.0 * bend * gl_Vertex.z));
  gl_Color.rgb *= 1.0 - 0.3 * length(gl_Vertex.xz);
}
)glsl";

void begin() {
  glARKinit(6);
  glEnable(GL_ARK);
  lesson::set_refinement_shader(0, saddle);  // ends the program with the log if there is a mistake
}

void sheet() {
  glColor3f(0.9F, 0.65F, 0.3F);
  glNormal3f(0, 1, 0);
  glBegin(GL_TRIANGLE_FAN);
  glVertex3f(0, 0, 0);
  for (const int i : {0, 1, 2, 3, 0}) glVertex3f(i == 1 || i == 2 ? 1 : -1, 0, i >= 2 ? -1 : 1);
  glEnd();
}

void draw(double) {
  lesson::look(3.6F, 30, 30);
  lesson::light();
  glDepthTag1i(5);
  lesson::draw_with_edges(sheet);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 8, exercise 2: a saddle", .keys = {}, .begin = begin, .draw = draw});
}
