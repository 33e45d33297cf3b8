// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Lesson 10, project 2: from a scan to a relief. Points without any order become triangle strips; curved PN triangles
// bend between the points; a height map carves a relief into them. The keys show one step after the other.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>
#include <glark/surfel.h>

#include <cmath>
#include <string>
#include <vector>

#include "examples/common/lesson.h"
#include "examples/common/look.h"

namespace {

constexpr int deepest = 4, map_size = 128, scanned = 3000;
int step = 3;  // 0: points, 1: strips, 2: curved, 3: with a relief
bool wireframe = false;

struct Scan {
  std::vector<float> positions, normals, coordinates;
};

// A vase as a scanner sees it: points all over its surface, in no order.
Scan make_scan() {
  Scan scan;
  for (int i = 0; i < scanned; ++i) {
    const float y = 2 * std::fmod(static_cast<float>(i) * 0.7548777F, 1.0F) - 1;
    const float turn = 6.2831853F * std::fmod(static_cast<float>(i) * 0.5698403F, 1.0F);
    const float radius = 0.55F + 0.25F * std::sin(2.6F * y + 0.5F);
    const float slope = 0.65F * std::cos(2.6F * y + 0.5F);
    const float x = std::cos(turn), z = std::sin(turn);
    scan.positions.insert(scan.positions.end(), {radius * x, y, radius * z});
    scan.normals.insert(scan.normals.end(), {x, -slope, z});
    // Left and right have the same picture. So the coordinate has no seam.
    scan.coordinates.insert(scan.coordinates.end(), {std::abs(turn / 3.1415927F - 1), 0.5F + 0.5F * y});
  }
  return scan;
}

// Waves that cross: a net of ribs.
void upload_height_map() {
  std::vector<float> heights;
  for (int t = 0; t < map_size; ++t) {
    for (int s = 0; s < map_size; ++s) {
      const float a = 6.2831853F * static_cast<float>(s) / map_size, b = 6.2831853F * static_cast<float>(t) / map_size;
      heights.push_back(std::pow(std::abs(std::cos(2 * a + 3 * b)), 6.0F) +
                        std::pow(std::abs(std::cos(2 * a - 3 * b)), 6.0F));
    }
  }
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, map_size, map_size, 0, GL_RED, GL_FLOAT, heights.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
}

// [strips]
void draw_strips(const glark::surfel::Strips& strips) {
  glark::surfel::View view{.width = 640, .height = 480, .cull_frustum = false, .cull_back_faces = false};
  view.point_pixels = view.level_pixels = 0;
  for (const unsigned i : {0U, 5U, 10U, 15U}) view.clip_from_object[i] = 1;
  static glark::surfel::Frame frame;
  strips.select(view, frame);
  for (std::size_t i = 0; i < frame.counts.size(); ++i) {
    const auto* const first = strips.indices().data() + reinterpret_cast<std::size_t>(frame.offsets[i]) / 4;
    glDrawElements(GL_TRIANGLE_STRIP, frame.counts[i], GL_UNSIGNED_INT, first);
  }
}
// [/strips]

// [draw]
void draw(double) {
  static const Scan scan = make_scan();
  static const glark::surfel::Strips strips({scan.positions, scan.normals});
  glVertexPointer(3, GL_FLOAT, 0, scan.positions.data());
  glNormalPointer(GL_FLOAT, 0, scan.normals.data());
  glTexCoordPointer(2, GL_FLOAT, 0, scan.coordinates.data());

  lesson::look(3.2F, 0, 15);
  lesson::light();
  glColor3f(0.55F, 0.6F, 0.8F);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, step < 2 ? 0 : deepest);
  glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, step < 3 ? -1 : 0);
  if (step == 0) glDrawArrays(GL_POINTS, 0, scanned);
  const auto surface = [] { draw_strips(strips); };
  if (step > 0 && wireframe) lesson::draw_with_edges(surface);
  if (step > 0 && !wireframe) surface();
}
// [/draw]

// [begin]
void begin() {
  upload_height_map();
  glARKinit(deepest);
  glEnable(GL_ARK);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  glARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.035F);
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY}) glEnableClientState(array);
  glPointSize(2);
}
// [/begin]

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv,
                     {.title = "Lesson 10: from a scan to a relief",
                      .keys = {{'p', "the points", [] { step = 0; }},
                               {'s', "strips through the points", [] { step = 1; }},
                               {'c', "curved triangles", [] { step = 2; }},
                               {'r', "the relief", [] { step = 3; }},
                               {'w', "wireframe", [] { wireframe = !wireframe; }}},
                      .begin = begin,
                      .draw = draw});
}
