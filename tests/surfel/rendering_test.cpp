// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Renders strips: there are no holes, and culling changes no pixel.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "tests/surfel/clouds.h"

namespace glark::surfel::test {
namespace {

constexpr int size = 192;

class SurfelRendering : public testing::Test {
 protected:
  void SetUp() override {
    context_ = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
    ASSERT_NE(OSMesaMakeCurrent(context_, image_.data(), GL_UNSIGNED_BYTE, size, size), GL_FALSE);
    glEnable(GL_DEPTH_TEST);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glEnable(GL_CULL_FACE);
  }
  void TearDown() override { OSMesaDestroyContext(context_); }

  void begin(const Points& points, const View& view) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(view.clip_from_object.data());
    glVertexPointer(3, GL_FLOAT, 0, points.positions.data());
    glNormalPointer(GL_FLOAT, 0, points.normals.data());
  }

  // Draws the strips that are selected for a view. Without culling, draws all strips.
  std::vector<GLuint> draw(const Points& points, const Strips& strips, View view, bool culled) {
    view.cull_frustum = view.cull_back_faces = culled;
    begin(points, view);
    Frame frame;
    strips.select(view, frame);
    for (const void*& offset : frame.offsets) {
      offset = reinterpret_cast<const char*>(strips.indices().data()) + reinterpret_cast<std::uintptr_t>(offset);
    }
    glMultiDrawElements(GL_TRIANGLE_STRIP, frame.counts.data(), GL_UNSIGNED_INT, frame.offsets.data(), frame.draws());
    return read();
  }

  // Draws a point white if it faces the eye, and black like the background if it faces away. Behind a real hole lie
  // points that face away.
  std::vector<GLuint> draw_splats(const Points& points, const View& view, float pixels) {
    begin(points, view);
    std::vector<GLuint> colours;
    for (std::size_t i = 0; i < points.size(); ++i) {
      float away = 0;
      for (std::size_t k = 0; k < 3; ++k) away += view.clip_from_object[4 * k + 2] * points.normals[3 * i + k];
      colours.push_back(away < 0 ? 0xFFFFFFFFU : 0U);
    }
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, colours.data());
    glEnableClientState(GL_COLOR_ARRAY);
    glPointSize(pixels);
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(points.size()));
    glDisableClientState(GL_COLOR_ARRAY);
    glColor4f(1, 1, 1, 1);
    return read();
  }

  static std::vector<GLuint> read() {
    std::vector<GLuint> pixels(size * size);
    glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    return pixels;
  }

 private:
  OSMesaContext context_ = nullptr;
  std::vector<GLuint> image_ = std::vector<GLuint>(size * size);
};

// Parallel views from the faces, edges and corners of a cube.
std::vector<View> views(const Points& points) {
  std::array<float, 3> low{1e30F, 1e30F, 1e30F}, high{-1e30F, -1e30F, -1e30F};
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], points.positions[i]);
    high[i % 3] = std::max(high[i % 3], points.positions[i]);
  }
  const float radius = 0.5F * std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  std::vector<View> all;
  for (int code = 0; code < 27; ++code) {
    const std::array<int, 3> step = {code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1};
    const float length = std::sqrt(static_cast<float>(step[0] * step[0] + step[1] * step[1] + step[2] * step[2]));
    if (length == 0) continue;
    std::array<std::array<float, 3>, 3> axes{};  // to the right, up, to the eye
    for (std::size_t k = 0; k < 3; ++k) axes[2][k] = static_cast<float>(step[k]) / length;
    const std::size_t least = step[0] == 0 ? 0 : step[1] == 0 ? 1 : step[2] == 0 ? 2 : 0;
    std::array<float, 3> along{};
    along[least] = 1;
    const auto cross = [](const auto& a, const auto& b) {
      return std::array<float, 3>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    };
    axes[0] = cross(along, axes[2]);
    const float across = std::hypot(axes[0][0], axes[0][1], axes[0][2]);
    for (float& x : axes[0]) x /= across;
    axes[1] = cross(axes[2], axes[0]);
    View view{.width = size, .height = size, .point_pixels = 0};
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t k = 0; k < 3; ++k) {
        const float element = axes[row][k] / (row == 2 ? -radius : radius);
        view.clip_from_object[4 * k + row] = element;
        view.clip_from_object[12 + row] -= element * 0.5F * (low[k] + high[k]);
      }
    }
    view.clip_from_object[15] = 1;
    all.push_back(view);
  }
  return all;
}

// Counts pixels where strips are seen from behind: through a hole, or because a triangle has the wrong orientation.
// Only pixels well inside the area of front-facing splats count. Pixels without any triangle do not count, because
// there splats cover a real gap.
int holes(const std::vector<GLuint>& splats, const std::vector<GLuint>& strips, const std::vector<GLuint>& both_sides,
          int margin) {
  int count = 0;
  for (int y = margin; y < size - margin; ++y) {
    for (int x = margin; x < size - margin; ++x) {
      const int at = y * size + x;
      const auto pixel = static_cast<std::size_t>(at);
      if (strips[pixel] != 0 || both_sides[pixel] == 0) continue;
      bool inside = true;
      for (int dy = -margin; dy <= margin && inside; ++dy) {
        for (int dx = -margin; dx <= margin && inside; ++dx) {
          const int beside = (y + dy) * size + x + dx;
          inside = splats[static_cast<std::size_t>(beside)] != 0;
        }
      }
      count += inside ? 1 : 0;
    }
  }
  return count;
}

class SurfelHoles : public SurfelRendering, public testing::WithParamInterface<std::string> {};

TEST_P(SurfelHoles, NoneIn26Views) {
  const std::string& name = GetParam();
  const auto points = name == "sphere" ? sphere(20000) : name == "torus" ? torus(20000) : scan(name);
  if (!points) GTEST_SKIP() << name << ".ply.zst is not in ../shared/data, or zstd is missing";
  const Strips strips(points->cloud());
  int all = 0;
  for (const View& view : views(*points)) {
    constexpr float splat = 3;
    const auto splats = draw_splats(*points, view, splat);
    const auto from_outside = draw(*points, strips, view, true);
    glDisable(GL_CULL_FACE);
    all += holes(splats, from_outside, draw(*points, strips, view, false), 3);
    glEnable(GL_CULL_FACE);
  }
  EXPECT_EQ(all, 0);
}

INSTANTIATE_TEST_SUITE_P(Models, SurfelHoles,
                         testing::Values("sphere", "torus", "igea", "horse", "armadillo", "nefertiti", "bunny"),
                         [](const auto& parameter) { return parameter.param; });

TEST_F(SurfelRendering, CullingChangesNoPixel) {
  const Points points = torus(20000);
  const Strips strips(points.cloud());
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  for (View view : views(points)) {
    EXPECT_EQ(draw(points, strips, view, false), draw(points, strips, view, true));
    for (float& element : view.clip_from_object) element *= 3;  // closer
    view.clip_from_object[15] = 1;
    EXPECT_EQ(draw(points, strips, view, false), draw(points, strips, view, true));
  }
}

}  // namespace
}  // namespace glark::surfel::test
