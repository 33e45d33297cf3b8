// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 3: no tags at all. Let the graphics card measure: an edge gets segments of at most 20 pixels.
#include "examples/common/lesson.h"

#include <GL/gl.h>
#include <GL/glark.h>

#include "examples/common/look.h"
#include "examples/course/04_depth/terrain.h"

namespace {

constexpr unsigned deepest = 5;

const Terrain terrain;
std::vector<float> tags(terrain.vertices());

void draw_terrain() {
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(terrain.triangles.size()), GL_UNSIGNED_INT,
                 terrain.triangles.data());
}

void begin() {
  glARKinit(deepest);
  glEnable(GL_ARK);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  glVertexPointer(3, GL_FLOAT, 0, terrain.positions.data());
  glNormalPointer(GL_FLOAT, 0, terrain.normals.data());
  glDepthTagPointerARK(GL_FLOAT, 0, tags.data());
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_DEPTH_TAG_ARRAY_ARK}) glEnableClientState(array);
  // Set two parameters here: GL_DEPTH_SOURCE_ARK and GL_EDGE_PIXELS_ARK.
  lesson::light();
  glColor3f(0.6F, 0.75F, 0.5F);
}

void draw(double) {
  lesson::look(8, 30, 25);
  lesson::say(lesson::triangles_as_text(draw_terrain));
  lesson::draw_with_edges(draw_terrain);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 4, exercise 3", .keys = {}, .begin = begin, .draw = draw});
}
