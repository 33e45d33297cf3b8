// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 1: tags by distance. Write the formula.
#include "examples/common/lesson.h"

#include <GL/gl.h>
#include <GL/glark.h>
#include <glark/depth.h>

#include <cmath>

#include "examples/common/look.h"
#include "examples/course/04_depth/terrain.h"

namespace {

constexpr unsigned deepest = 5;

const Terrain terrain;
std::vector<float> tags(terrain.vertices());

// Where the eye is, in the space of the terrain.
glark::depth::Vector eye_of(const lesson::Matrix& view) {
  glark::depth::Vector eye{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) eye[i] -= view[4 * i + j] * view[12 + j];
  return eye;
}

// The tag is 5 up to the distance 4, 0 from the distance 9 on, and falls linearly between them.
void tag(const glark::depth::Vector& eye) {
  for (std::size_t i = 0; i < tags.size(); ++i) {
    const float* const at = &terrain.positions[3 * i];
    const float distance = std::hypot(at[0] - eye[0], at[1] - eye[1], at[2] - eye[2]);
    tags[i] = distance < 6 ? 4 : 2;  // change this
  }
}

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
  lesson::light();
  glColor3f(0.6F, 0.75F, 0.5F);
}

void draw(double) {
  lesson::look(8, 30, 25);
  tag(eye_of(lesson::camera(8, 30, 25).view));
  lesson::say(lesson::triangles_as_text(draw_terrain));
  lesson::draw_with_edges(draw_terrain);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 4, exercise 1", .keys = {}, .begin = begin, .draw = draw});
}
