// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The hill of lesson 3. It is red inside: whoever sees red looks through a crack.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>

#include "examples/common/lesson.h"
#include "examples/common/look.h"
#include "examples/common/program.h"

namespace hill {

// Every refined vertex moves up onto a round hill.
inline constexpr const char* shader = R"glsl(
void refine() {
  float rest = max(0.0, 1.0 - 1.8 * dot(gl_Vertex.xz, gl_Vertex.xz));
  gl_Vertex.y = 0.7 * rest * rest;
  gl_Normal = vec3(5.04 * rest * gl_Vertex.x, 1.0, 5.04 * rest * gl_Vertex.z);
}
)glsl";

inline void begin() {
  glARKinit(6);
  glEnable(GL_ARK);
  lesson::set_refinement_shader(0, shader);
  lesson::light();
  constexpr float red[4] = {1, 0.1F, 0.1F, 1};
  glColorMaterial(GL_FRONT, GL_AMBIENT_AND_DIFFUSE);
  glMaterialfv(GL_BACK, GL_EMISSION, red);
  glEnable(GL_CULL_FACE);
}

// A flat ground, seen from its back. It is smaller than the hill, so that a closed hill hides it.
inline void ground() {
  glDisable(GL_ARK);
  glBegin(GL_QUADS);
  glVertex3f(0, -0.01F, -0.95F);
  glVertex3f(1.14F, -0.01F, 0);
  glVertex3f(0, -0.01F, 0.95F);
  glVertex3f(-1.14F, -0.01F, 0);
  glEnd();
  glEnable(GL_ARK);
}

// Draws what only shows through a crack. Returns whether a sample of the picture shows it. The offset hides the inside
// behind the outside, where both meet at the edge of the hill.
inline bool draw_inside(void (*mesh)()) {
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

// Draws the mesh from the left and from the right. `deepest` is its greatest tag. Returns "a crack", "no crack", or
// "too fine to tell": above tag 4, the offset hides small cracks, too.
inline const char* draw(void (*mesh)(), unsigned deepest) {
  bool crack = false;
  for (const int part : {0, 1}) {
    lesson::use_part(part, 2);
    lesson::look(3, part == 0 ? 60 : -60, 35);
    lesson::draw_with_edges(mesh);
    crack = draw_inside(mesh) || crack;
  }
  if (crack) return "a crack";
  return deepest > 4 ? "too fine to tell" : "no crack";
}

}  // namespace hill
