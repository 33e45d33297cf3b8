// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A capture leaves out the empty draws of one glMultiDraw call. The application's own call reaches GL as it is.
#include <algorithm>
#include <array>
#include <vector>

#include "tests/core/evaluate/shape_scene.h"

namespace glark::core::test {
namespace {

const gl::Dispatch* real = nullptr;
std::vector<std::vector<GLsizei>> counts_seen;

void multi_draw_arrays(GLenum mode, const GLint* first, const GLsizei* count, GLsizei draws) {
  counts_seen.emplace_back(count, count + draws);
  real->MultiDrawArrays(mode, first, count, draws);
}
void multi_draw_elements(GLenum mode, const GLsizei* count, GLenum type, const void* const* indices, GLsizei draws) {
  counts_seen.emplace_back(count, count + draws);
  real->MultiDrawElements(mode, count, type, indices, draws);
}

class MultiDraws : public testing::Test {
 protected:
  MultiDraws() : spied_(window_.gl), scene_((spy(), spied_), ShapeKind::uniform) { counts_seen.clear(); }

  void spy() {
    real = &window_.gl;
    spied_.MultiDrawArrays = multi_draw_arrays;
    spied_.MultiDrawElements = multi_draw_elements;
  }
  void draw_both() {
    const std::array<GLint, 2> first{1, 0};
    const std::array<GLushort, 4> four{0, 1, 2, 3};
    const std::array<const void*, 2> indices{four.data(), four.data()};
    hook::MultiDrawArrays(scene_.context(), GL_QUADS, first.data(), counts_.data(), 2);
    hook::MultiDrawElements(scene_.context(), GL_QUADS, counts_.data(), GL_UNSIGNED_SHORT, indices.data(), 2);
    EXPECT_EQ(hook::GetError(scene_.context()), static_cast<GLenum>(GL_NO_ERROR));
  }

  const std::vector<GLsizei> counts_{0, 4};
  PlainContext window_;
  gl::Dispatch spied_;
  ShapeScene scene_;
};

TEST_F(MultiDraws, ReachGlAsTheyAreWhereNothingIsRefined) {
  hook::ARKParameteriARK(scene_.context(), GL_UNIFORM_DEPTH_LEVEL_ARK, 0);
  draw_both();
  EXPECT_EQ(counts_seen, (std::vector<std::vector<GLsizei>>{counts_, counts_}));
}

TEST_F(MultiDraws, AreCapturedWithoutEmptyDraws) {
  draw_both();
  const std::vector<GLsizei> filled{1, 4};
  EXPECT_GE(std::count(counts_seen.begin(), counts_seen.end(), filled), 2);
  EXPECT_EQ(std::count(counts_seen.begin(), counts_seen.end(), counts_), 0);
}

}  // namespace
}  // namespace glark::core::test
