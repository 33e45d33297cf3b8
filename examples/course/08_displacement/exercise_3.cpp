// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 3 of lesson 8: the forgotten normal. The shader moves the vertices of a flag, but the light stays that of a
// flat sheet. Give every vertex the normal of the moved surface.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>

#include "examples/common/lesson.h"
#include "examples/common/look.h"
#include "examples/common/program.h"

namespace {

constexpr const char* flag = R"glsl(
void refine() {
  float x = gl_Vertex.x;
  gl_Vertex.z += 0.15 * sin(5.0 * x);
  // TODO: the slope of 0.15 * sin(5 x) along x; then the normal of the graph is (-slope, 0, 1), of unit length
}
)glsl";

void begin() {
  glARKinit(6);
  glEnable(GL_ARK);
  lesson::set_refinement_shader(0, flag);
}

void draw(double) {
  lesson::look(3.2F, 25, 10);
  lesson::light();
  glColor3f(0.85F, 0.3F, 0.3F);
  glNormal3f(0, 0, 1);
  glDepthTag1i(6);
  glBegin(GL_TRIANGLE_STRIP);
  for (const float x : {-1.2F, 1.2F}) {
    glVertex3f(x, 0.7F, 0);
    glVertex3f(x, -0.7F, 0);
  }
  glEnd();
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 8, exercise 3: a flag", .keys = {}, .begin = begin, .draw = draw});
}
