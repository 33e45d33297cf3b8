// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Solution 3: no tag puts a vertex at z = 0.3. The left side needs this vertex, too, and then both sides have the same edges.
#define GL_GLEXT_PROTOTYPES
#include "examples/common/lesson.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>

#include "examples/common/look.h"
#include "examples/common/program.h"

namespace {

// Every refined vertex moves up onto a round hill.
constexpr const char* hill = R"glsl(
void refine() {
  float rest = max(0.0, 1.0 - 1.8 * dot(gl_Vertex.xz, gl_Vertex.xz));
  gl_Vertex.y = 0.7 * rest * rest;
  gl_Normal = vec3(5.04 * rest * gl_Vertex.x, 1.0, 5.04 * rest * gl_Vertex.z);
}
)glsl";

void begin() {
  glARKinit(6);
  glEnable(GL_ARK);
  lesson::set_refinement_shader(0, hill);
  lesson::light();
  constexpr float red[4] = {1, 0.1F, 0.1F, 1};
  glColorMaterial(GL_FRONT, GL_AMBIENT_AND_DIFFUSE);
  glMaterialfv(GL_BACK, GL_EMISSION, red);
  glEnable(GL_CULL_FACE);
}

void mesh() {
  glDepthTag1i(4);
  glBegin(GL_TRIANGLES);
  glColor3f(0.95F, 0.75F, 0.4F);
  glVertex3f(0, 0, -1);
  glVertex3f(-1.2F, 0, 0);
  glVertex3f(0, 0, 0.3F);
  glVertex3f(0, 0, 0.3F);
  glVertex3f(-1.2F, 0, 0);
  glVertex3f(0, 0, 1);
  glColor3f(0.5F, 0.75F, 0.55F);
  glVertex3f(0, 0, -1);
  glVertex3f(0, 0, 0.3F);
  glVertex3f(1.2F, 0, 0);
  glVertex3f(0, 0, 0.3F);
  glVertex3f(0, 0, 1);
  glVertex3f(1.2F, 0, 0);
  glEnd();
}

// A flat ground, seen from its back.
void ground() {
  glDisable(GL_ARK);
  glBegin(GL_QUADS);
  glVertex3f(0, -0.01F, -0.95F);
  glVertex3f(1.14F, -0.01F, 0);
  glVertex3f(0, -0.01F, 0.95F);
  glVertex3f(-1.14F, -0.01F, 0);
  glEnd();
  glEnable(GL_ARK);
}

// The hill is red inside. Whoever sees red looks through a crack. Returns whether any sample of the picture is red.
bool draw_inside() {
  GLuint query = 0;
  GLuint visible = 0;
  glGenQueries(1, &query);
  glCullFace(GL_FRONT);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(16, 64);
  glBeginQuery(GL_ANY_SAMPLES_PASSED, query);
  mesh();
  ground();
  glEndQuery(GL_ANY_SAMPLES_PASSED);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glCullFace(GL_BACK);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &visible);
  glDeleteQueries(1, &query);
  return visible != 0;
}

void draw(double) {
  bool crack = false;
  for (const int part : {0, 1}) {  // seen from the left, and from the right
    lesson::use_part(part, 2);
    lesson::look(3, part == 0 ? 60 : -60, 35);
    lesson::draw_with_edges(mesh);
    crack = draw_inside() || crack;
  }
  lesson::say(crack ? "a crack" : "no crack");
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 3", .keys = {}, .begin = begin, .draw = draw});
}
