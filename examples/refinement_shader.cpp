// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Your own refinement shader: two triangles become a rippling sheet. refine() runs once for each refined vertex, before
// the fixed function. It gets the interpolated inputs of the vertex and may change them; here it changes position and
// normal.
//
//   refinement_shader [OUT.png]
#include <GL/gl.h>

#include <GL/glark.h>

#include "examples/common/lesson.h"
#include "examples/common/look.h"
#include "examples/common/program.h"

namespace {

constexpr unsigned level = 7;

// Makes rings of height h(r) around the middle. The normal is the normal of the graph of h.
constexpr const char* waves = R"glsl(
void refine() {
  float r = length(gl_Vertex.xy);
  float h = 0.12 * cos(18.0 * r) * exp(-1.5 * r);
  float slope = -0.12 * exp(-1.5 * r) * (18.0 * sin(18.0 * r) + 1.5 * cos(18.0 * r));
  gl_Vertex.z += h;
  gl_Normal = normalize(vec3(-slope * gl_Vertex.xy / max(r, 1e-4), 1.0));
}
)glsl";

void draw_sheet() {
  glDepthTag1i(level);
  glBegin(GL_TRIANGLE_STRIP);
  glNormal3f(0, 0, 1);
  glVertex2f(-1, -1);
  glVertex2f(1, -1);
  glVertex2f(-1, 1);
  glVertex2f(1, 1);
  glEnd();
}

void begin() {
  glARKinit(level);
  glEnable(GL_ARK);
  lesson::set_refinement_shader(0, waves);  // 0 is the fixed function
  lesson::light();
}

void draw(double) {
  lesson::look(3, 30, 35);
  glRotatef(-90, 1, 0, 0);
  glColor3f(0.15F, 0.5F, 0.7F);
  draw_sheet();
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(
      argc, argv,
      {.title = "refinement_shader", .keys = {}, .begin = begin, .draw = draw, .width = 512, .height = 512});
}
