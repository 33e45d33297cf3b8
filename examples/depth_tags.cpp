// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Depth tags by metrics: an eye flies over a coarse terrain of curved PN triangles. Every frame sets the tags of all
// vertices by the curvature that the eye sees, limited by distance, within a budget of triangles. The picture shows
// three frames in the false colours of the tags (blue 0, through green, to red at the deepest level), with the edges of
// the refined triangles.
//
//   depth_tags [OUT.png]
#include <GL/gl.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <GL/glark.h>
#include <glark/depth.h>
#include "examples/common/lesson.h"
#include "examples/common/look.h"

namespace {

constexpr int frames = 3;
constexpr int frame_size = 480;
constexpr unsigned max_level = 5;
constexpr unsigned side = 24;  // coarse squares along a side
constexpr float field_of_view = 0.9F;
constexpr std::uint64_t most_triangles = 30000;

struct Terrain {
  std::vector<float> positions, normals, tags, colors;
  std::vector<unsigned> triangles;
};

float height_at(float x, float y) {
  const float hills = 0.5F * std::sin(1.3F * x + 0.4F) * std::cos(1.1F * y);
  const float peak = 1.6F * std::exp(-1.5F * (x * x + y * y));
  return hills + peak;
}

Terrain make_terrain() {
  Terrain terrain;
  for (unsigned j = 0; j <= side; ++j) {
    for (unsigned i = 0; i <= side; ++i) {
      const float x = 8.0F * static_cast<float>(i) / side - 4;
      const float y = 8.0F * static_cast<float>(j) / side - 4;
      const float step = 0.01F;
      const float dx = (height_at(x + step, y) - height_at(x - step, y)) / (2 * step);
      const float dy = (height_at(x, y + step) - height_at(x, y - step)) / (2 * step);
      const float size = std::hypot(dx, dy, 1.0F);
      terrain.positions.insert(terrain.positions.end(), {x, y, height_at(x, y)});
      terrain.normals.insert(terrain.normals.end(), {-dx / size, -dy / size, 1 / size});
      if (i == side || j == side) continue;
      const unsigned at = j * (side + 1) + i;
      terrain.triangles.insert(terrain.triangles.end(), {at, at + 1, at + side + 2, at, at + side + 2, at + side + 1});
    }
  }
  terrain.tags.resize(terrain.positions.size() / 3);
  terrain.colors.resize(terrain.positions.size());
  return terrain;
}

// Three lines set the tags of a frame. This is the example's purpose.
void tag(Terrain& terrain, glark::depth::Tagger& tagger, const glark::depth::Vector& eye) {
  static std::vector<float> by_distance(terrain.tags.size());
  const glark::depth::View view{.eye = eye, .pixels_at_one = 0.5F * frame_size / std::tan(0.5F * field_of_view)};
  tagger.by_curvature(terrain.positions, terrain.normals, view, 0.05F, terrain.tags);
  tagger.by_distance(terrain.positions, {.point = eye, .nearest = 2, .farthest = 9, .finest = max_level}, by_distance);
  tagger.take_lesser(by_distance, terrain.tags);
  const glark::depth::Budget budget = tagger.keep_budget(most_triangles, terrain.tags);
  std::printf("%llu triangles, %.2f levels less than wished for\n", static_cast<unsigned long long>(budget.triangles),
              static_cast<double>(budget.bias));
}

void color_by_depth(Terrain& terrain) {
  for (std::size_t i = 0; i < terrain.tags.size(); ++i) {
    const float heat = terrain.tags[i] / max_level;
    terrain.colors[3 * i] = std::clamp(2 * heat - 0.6F, 0.15F, 1.0F);
    terrain.colors[3 * i + 1] = 0.3F + 0.65F * (1 - std::abs(2 * heat - 1));
    terrain.colors[3 * i + 2] = std::clamp(1 - 2 * heat, 0.15F, 1.0F);
  }
}

void look_from(const glark::depth::Vector& eye) {
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  const double half = 0.1 * std::tan(0.5 * static_cast<double>(field_of_view));
  glFrustum(-half, half, -half, half, 0.1, 100);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  // Looks at the peak, tilted down by the angle at which the eye sees it.
  const double down = std::atan2(static_cast<double>(eye[2]) - 0.6, -static_cast<double>(eye[1]));
  glRotated(-90 + down * 57.2957795, 1, 0, 0);
  glTranslatef(-eye[0], -eye[1], -eye[2]);
}

void draw(const Terrain& terrain) {
  glVertexPointer(3, GL_FLOAT, 0, terrain.positions.data());
  glNormalPointer(GL_FLOAT, 0, terrain.normals.data());
  glColorPointer(3, GL_FLOAT, 0, terrain.colors.data());
  glDepthTagPointerARK(GL_FLOAT, 0, terrain.tags.data());
  glDrawARPElementsARK(GL_TRIANGLES, static_cast<GLsizei>(terrain.triangles.size()), GL_UNSIGNED_INT,
                       terrain.triangles.data());
}

Terrain terrain = make_terrain();
glark::depth::Tagger tagger(terrain.tags.size(), terrain.triangles, max_level);

// The terrain is lit. So the program has normals, which curve the triangles.
void begin() {
  glARKinit(max_level);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_DEPTH_TAG_ARRAY_ARK})
    glEnableClientState(array);
  for (const GLenum capability : {GL_LIGHTING, GL_LIGHT0, GL_COLOR_MATERIAL, GL_DEPTH_TEST}) glEnable(capability);
}

void draw_flight(double) {
  for (int frame = 0; frame < frames; ++frame) {
    const glark::depth::Vector eye = {0, -10.0F + 3.2F * static_cast<float>(frame),
                                      3.2F - 0.5F * static_cast<float>(frame)};
    lesson::use_part(frame, frames);
    tag(terrain, tagger, eye);
    color_by_depth(terrain);
    look_from(eye);
    lesson::draw_with_edges([] { draw(terrain); });
  }
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv,
                     {.title = "depth_tags",
                      .keys = {},
                      .begin = begin,
                      .draw = draw_flight,
                      .width = frames * frame_size,
                      .height = frame_size});
}
