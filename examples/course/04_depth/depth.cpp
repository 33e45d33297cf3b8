// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Lesson 4: where depth tags come from. Four ways to choose them for a coarse terrain: all alike, by distance, by the
// bend of the surface within a budget, or measured on the graphics card.
#include "examples/common/lesson.h"

#include <GL/gl.h>
#include <GL/glark.h>
#include <glark/depth.h>

#include <algorithm>
#include <cmath>

#include "examples/common/look.h"
#include "examples/course/04_depth/terrain.h"

namespace {

constexpr unsigned deepest = 5;

enum class Way { uniform, distance, curvature, measured };

Way way = Way::uniform;
float distance_of_eye = 9;
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

// [distance]
void tag_by_distance(const glark::depth::Vector& eye) {
  for (std::size_t i = 0; i < tags.size(); ++i) {
    const float* const at = &terrain.positions[3 * i];
    const float distance = std::hypot(at[0] - eye[0], at[1] - eye[1], at[2] - eye[2]);
    tags[i] = std::clamp(deepest - 3 * std::log2(distance / 3.5F), 0.0F, 1.0F * deepest);  // 3 levels per doubling
  }
}
// [/distance]

// [curvature]
void tag_by_curvature(const glark::depth::Vector& eye) {
  const glark::depth::View view{.eye = eye, .pixels_at_one = 600};
  tagger.by_curvature(terrain.positions, terrain.normals, view, 0.5F, tags);  // at most 0.5 pixels from the true shape
  tagger.keep_budget(2000, tags);                                             // but at most 2000 triangles
}
// [/curvature]

void draw_terrain() {
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(terrain.triangles.size()), GL_UNSIGNED_INT,
                 terrain.triangles.data());
}

void begin() {
  glARKinit(deepest);
  glEnable(GL_ARK);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);  // from positions and normals: lesson 6
  // [begin]
  glVertexPointer(3, GL_FLOAT, 0, terrain.positions.data());
  glNormalPointer(GL_FLOAT, 0, terrain.normals.data());
  glDepthTagPointerARK(GL_FLOAT, 0, tags.data());
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_DEPTH_TAG_ARRAY_ARK}) glEnableClientState(array);
  // [/begin]
  glARKParameteriARK(GL_EDGE_PIXELS_ARK, 16);  // of the measured way
  lesson::light();
  glColor3f(0.6F, 0.75F, 0.5F);
}

void draw(double) {
  const glark::depth::Vector eye = eye_of(lesson::camera(distance_of_eye, 30, 25).view);
  lesson::look(distance_of_eye, 30, 25);
  if (way == Way::uniform) std::fill(tags.begin(), tags.end(), 2.0F);
  if (way == Way::distance) tag_by_distance(eye);
  if (way == Way::curvature) tag_by_curvature(eye);
  // [source]
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, way == Way::measured ? GL_MEASURED_DEPTH_ARK : GL_DEPTH_TAG_ARK);
  // [/source]
  constexpr const char* names[] = {"uniform", "by distance", "by curvature", "measured"};
  lesson::say("%s: %s", names[static_cast<int>(way)], lesson::triangles_as_text(draw_terrain).c_str());
  lesson::draw_with_edges(draw_terrain);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv,
                     {.title = "Lesson 4, depth",
                      .keys = {{'1', "uniform: all tags are 2", [] { way = Way::uniform; }},
                               {'2', "by the distance from the eye", [] { way = Way::distance; }},
                               {'3', "by curvature, at most 2000 triangles", [] { way = Way::curvature; }},
                               {'4', "measured on the graphics card: 16 pixels", [] { way = Way::measured; }},
                               {'n', "nearer", [] { distance_of_eye *= 0.8F; }},
                               {'f', "farther", [] { distance_of_eye *= 1.25F; }}},
                      .begin = begin,
                      .draw = draw});
}
