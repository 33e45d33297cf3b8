// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws from client memory are known by the content that they read, not by its address.
#include <array>

#include "tests/core/support/kept_scene.h"

namespace glark::core::test {
namespace {

class ClientMemory : public testing::Test {
 protected:
  ClientMemory() {
    for (const GLenum array : {GL_VERTEX_ARRAY, GL_COLOR_ARRAY}) glEnableClientState(array);
    refine_uniformly(2);
  }
  void draw_arrays() {
    point_conventional_arrays(vertices_.data());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 6);
  }
  void draw_elements() {
    point_conventional_arrays(vertices_.data());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices_.size()), GL_UNSIGNED_SHORT, indices_.data());
  }
  // The same content at another address.
  void move() {
    std::vector<ColoredVertex> vertices = vertices_;
    std::vector<GLushort> indices = indices_;
    vertices_.swap(vertices);
    indices_.swap(indices);
    former_vertices_.push_back(std::move(vertices));
    former_indices_.push_back(std::move(indices));
  }

  static void expect_change(const std::function<void()>& draw, const std::function<void()>& change) {
    expect_seen(draw, change);
    glEnable(GL_ARK);
  }

  OsmesaContext context_{Profile::compatibility};
  std::vector<ColoredVertex> vertices_ = first_vertices();
  std::vector<GLushort> indices_{0, 1, 2, 2, 1, 3};
  std::vector<std::vector<ColoredVertex>> former_vertices_;
  std::vector<std::vector<GLushort>> former_indices_;
};

TEST_F(ClientMemory, UnchangedArraysAreCapturedOnce) {
  expect_kept([this] { draw_arrays(); }, [] {});
  expect_kept([this] { draw_elements(); }, [] {});
}

TEST_F(ClientMemory, TheAddressDoesNotMatter) {
  expect_kept([this] { draw_arrays(); }, [this] { move(); });
  expect_kept([this] { draw_elements(); }, [this] { move(); });
}

TEST_F(ClientMemory, ChangesShow) {
  expect_change([this] { draw_arrays(); }, [this] { vertices_[5].position[1] *= -0.5F; });
  expect_change([this] { draw_arrays(); }, [this] { vertices_ = other_vertices(); });
  expect_change([this] { draw_elements(); }, [this] { vertices_[3].color = {0, 0, 0}; });
  expect_change([this] { draw_elements(); }, [this] { indices_[5] = 5; });
}

TEST_F(ClientMemory, VerticesThatAreNotReadDoNotMatter) {
  expect_kept([this] { draw_elements(); }, [this] { vertices_[4].position[0] += 0.125F; });
}

TEST_F(ClientMemory, OtherFormatsShow) {
  const auto draw = [] { glDrawArrays(GL_TRIANGLE_STRIP, 0, 6); };
  point_conventional_arrays(vertices_.data());
  expect_change(draw, [this] { glColorPointer(3, GL_UNSIGNED_BYTE, sizeof(ColoredVertex), &vertices_[0].color); });
}

TEST_F(ClientMemory, IndicesInABufferShow) {
  make_buffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  const auto draw = [this] {
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    point_conventional_arrays(vertices_.data());
    glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, nullptr);
  };
  expect_change(draw, [this] { vertices_[3].color = {0, 0, 0}; });
  const std::vector<GLushort> others{0, 1, 2, 2, 1, 5};
  expect_change(draw, [&] { glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, 12, others.data()); });
}

}  // namespace
}  // namespace glark::core::test
