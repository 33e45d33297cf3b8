// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// --refine smooth: a draw that repeats with kept vertices is not planned, but its mesh is judged each time.
#include <functional>
#include <vector>

#include "tests/core/meshes/ball.h"

namespace glark::core::test {
namespace {

constexpr int frames_until_repeated = 24;
constexpr int frames_until_flat = 6;  // a new mesh is excused at first

class RepeatedMeshes : public testing::Test {
 protected:
  RepeatedMeshes() {
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glGenVertexArrays(1, &array_);
    glBindVertexArray(array_);
    make_buffer(GL_ARRAY_BUFFER, ball_corners());
    glVertexPointer(3, GL_FLOAT, 0, nullptr);
    glNormalPointer(GL_FLOAT, 0, nullptr);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    list_ = glGenLists(1);
    glNewList(list_, GL_COMPILE);
    glBegin(GL_TRIANGLES);
    for (const auto& corner : ball_corners()) {
      glNormal3fv(corner.data());
      glVertex3fv(corner.data());
    }
    glEnd();
    glEndList();
    glBindVertexArray(0);
  }
  void draw_array() const {
    glBindVertexArray(array_);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(ball_corners().size()));
    glBindVertexArray(0);
  }
  // The arrays that are bound stay the same, too: plans depend on them.
  void draw_list() const {
    glBindVertexArray(array_);
    glCallList(list_);
    glBindVertexArray(0);
  }
  // A pass without normals that must meet an unknown mesh. It changes no state of the fixed function, so that the next
  // draw repeats.
  void draw_shadow_map() const {
    shadow_map_.bind();
    other_.draw_positions();
    DepthFramebuffer::unbind();
  }
  void expect_flat_beside_a_shadow_map(const std::function<void()>& draw) const {
    const std::vector<Picture> round = draw_frames(frames_until_repeated, draw);
    EXPECT_GT(covered_pixels(round.back()), round_pixels);
    for (std::size_t i = 3; i < round.size(); ++i) EXPECT_TRUE(round[i] == round.back()) << i;
    const std::vector<Picture> flat = draw_frames(frames_until_flat, [&] {
      draw_shadow_map();
      draw();
    });
    EXPECT_TRUE(flat.back() == round.front());
  }

  OsmesaContext context_{Profile::compatibility};
  Ball other_{Source::buffer};
  DepthFramebuffer shadow_map_;
  GLuint array_ = 0;
  GLuint list_ = 0;
};

TEST_F(RepeatedMeshes, ArraysTurnFlatWithAnUnknownPartner) {
  expect_flat_beside_a_shadow_map([this] { draw_array(); });
}

TEST_F(RepeatedMeshes, ListsTurnFlatWithAnUnknownPartner) {
  expect_flat_beside_a_shadow_map([this] { draw_list(); });
}

// The same program without normals: the mesh has others, or none.
TEST_F(RepeatedMeshes, NormalsSwitchedOff) {
  draw_frames(frames_until_repeated, [this] { draw_array(); });
  glBindVertexArray(array_);
  glDisableClientState(GL_NORMAL_ARRAY);
  glNormal3f(0, 0, 1);
  const std::vector<Picture> frames = draw_frames(3, [this] { draw_array(); });
  EXPECT_NEAR(covered_pixels(frames.back()), octahedron_pixels, octahedron_pixels / 50);
}

}  // namespace
}  // namespace glark::core::test
