// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 2: a budget. Draw at most 2000 triangles, and at least 1500. Lower all tags alike.
#include "examples/common/lesson.h"

#include <GL/gl.h>
#include <GL/glark.h>
#include <glark/depth.h>

#include <algorithm>

#include "examples/common/look.h"
#include "examples/course/04_depth/terrain.h"

namespace {

constexpr unsigned deepest = 5;

const Terrain terrain;
std::vector<float> tags(terrain.vertices());
glark::depth::Tagger tagger(terrain.vertices(), terrain.triangles, deepest);

// Where the eye is, in the space of the terrain.
glark::depth::Vector eye_of(const lesson::Matrix& view) {
  glark::depth::Vector eye{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) eye[i] -= view[4 * i + j] * view[12 + j];
  return eye;
}

void draw_terrain() {
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(terrain.triangles.size()), GL_UNSIGNED_INT,
                 terrain.triangles.data());
}

// What the curvature asks for, which is too much.
std::vector<float> wanted_tags(const glark::depth::Vector& eye) {
  std::vector<float> wanted(terrain.vertices());
  tagger.by_curvature(terrain.positions, terrain.normals, {.eye = eye, .pixels_at_one = 600}, 0.1F, wanted);
  return wanted;
}

void tag(const glark::depth::Vector& eye) { std::ranges::copy(wanted_tags(eye), tags.begin()); }

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
  const unsigned triangles = lesson::count_triangles(draw_terrain);
  const char* const number = triangles > 2000 ? "too many" : triangles < 1500 ? "too few" : "between 1500 and 2000";
  const bool alike = lowered_alike(tags, wanted_tags(eye_of(lesson::camera(8, 30, 25).view)));
  lesson::say("%s, %s", number, alike ? "all tags lowered alike" : "some tags lowered more than others");
  lesson::draw_with_edges(draw_terrain);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 4, exercise 2", .keys = {}, .begin = begin, .draw = draw});
}
