// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws a point cloud as triangle strips with the library glark-surfel, without reconstructing its surface. On the left
// are the points; in the middle the strips of this view, each in its own colour; on the right the same strips as curved
// triangles, by GL_CURVED_PN_ARK. One glMultiDrawElements draws the strips. Strips that face away or lie outside the
// picture are culled.
//
//   surfel_strips [OUT.png [--seconds 1]]      the moment of the animation; only strips of the bulge change
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <glark/surfel.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <GL/glark.h>

#include "examples/common/knot.h"
#include "examples/common/lesson.h"
#include "examples/common/look.h"
#include "examples/common/program.h"

namespace {

constexpr unsigned deepest = 2;

// Moves points near the tip of the x axis outwards, the nearest points farthest, and rotates their normals. Returns the
// moved points.
std::vector<std::uint32_t> bulge(lesson::Points& points, float by) {
  std::vector<std::uint32_t> moved;
  for (std::uint32_t i = 0; i < points.positions.size() / 3; ++i) {
    float* const p = &points.positions[3UL * i];
    float* const n = &points.normals[3UL * i];
    const float d[3] = {p[0] - 1.35F, p[1], p[2]};
    const float near = 1 - (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) / 0.5F;
    if (near <= 0) continue;
    const float along = d[0] * n[0] + d[1] * n[1] + d[2] * n[2];
    for (int k = 0; k < 3; ++k) {
      p[k] += by * near * near * n[k];
      n[k] += by * 8 * near * (d[k] - along * n[k]);  // minus the slope of near * near across the normal
    }
    moved.push_back(i);
  }
  return moved;
}

// The view as the library needs it: projection times model-view, and the size in pixels.
glark::surfel::View look(int column) {
  lesson::use_part(column, 3);
  lesson::look(5.6F, 0, 40);
  GLint viewport[4];
  lesson::Matrix projection, model_view;
  glRotatef(-90, 1, 0, 0);
  glGetIntegerv(GL_VIEWPORT, viewport);
  glGetFloatv(GL_PROJECTION_MATRIX, projection.data());
  glGetFloatv(GL_MODELVIEW_MATRIX, model_view.data());
  return {.clip_from_object = lesson::multiply(projection, model_view),
          .width = static_cast<unsigned>(viewport[2]),
          .height = static_cast<unsigned>(viewport[3])};
}

// Draws the strips one by one, so that each has its colour.
void draw_coloured(const glark::surfel::Frame& frame) {
  for (std::size_t i = 0; i < frame.counts.size(); ++i) {
    const auto shade = [&](std::size_t prime) { return 0.35F + 0.6F * float(i * prime % 97) / 97; };
    glColor3f(shade(31), shade(57), shade(83));
    glDrawElements(GL_TRIANGLE_STRIP, frame.counts[i], GL_UNSIGNED_INT, frame.offsets[i]);
  }
}

lesson::Points points = lesson::make_knot(6000);
std::optional<glark::surfel::Strips> strips;

// Runs once: the strips. Their indices go to a buffer. The points stay in their arrays and in their order.
void begin() {
  lesson::light();
  glEnable(GL_CULL_FACE);
  glARKinit(deepest);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, deepest);
  strips.emplace(glark::surfel::Cloud{points.positions, points.normals});
  lesson::make_buffer(GL_ELEMENT_ARRAY_BUFFER, nullptr, 0);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
}

// Runs when points move: only their strips are updated. Large programs upload only the ranges that update() returns.
void move(float by) {
  points = lesson::make_knot(6000);
  const std::vector<std::uint32_t> moved = bulge(points, by);
  strips->update({points.positions, points.normals}, moved);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(strips->indices().size_bytes()),
               strips->indices().data(), GL_STATIC_DRAW);
  glVertexPointer(3, GL_FLOAT, 0, points.positions.data());
  glNormalPointer(GL_FLOAT, 0, points.normals.data());
}

// Runs in every frame: select what is visible, then draw it. The example draws it in three ways.
void draw_views(double seconds) {
  move(0.2F + 0.2F * static_cast<float>(std::sin(seconds)));
  glDisable(GL_ARK);
  look(0);
  glColor3f(0.2F, 0.35F, 0.6F);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(points.positions.size() / 3));
  glark::surfel::Frame frame;
  strips->select(look(1), frame);
  draw_coloured(frame);
  look(2);
  glColor3f(0.9F, 0.6F, 0.3F);
  glEnable(GL_ARK);
  glMultiDrawElements(GL_TRIANGLE_STRIP, frame.counts.data(), GL_UNSIGNED_INT, frame.offsets.data(), frame.draws());
  lesson::say("%zu of %zu strips in %d draws of one call", frame.strips, strips->counts().strips, frame.draws());
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(
      argc, argv,
      {.title = "surfel_strips", .keys = {}, .begin = begin, .draw = draw_views, .width = 1536, .height = 512});
}
