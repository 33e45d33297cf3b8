// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws of captured vertices begin another command buffer if glark has drawn indirectly: see Submission::flush_indirect.
#include "tests/core/evaluate/shape_scene.h"

namespace glark::core::test {
namespace {

int flushes = 0;
void (*flush_of_gl)() = nullptr;

void count_flush() {
  ++flushes;
  flush_of_gl();
}

class CountedDraws : public testing::Test {
 protected:
  CountedDraws() : spied_(window_.gl) {
    flushes = 0;
    flush_of_gl = window_.gl.Flush;
    spied_.Flush = count_flush;
  }
  // Nothing has been captured, so that the draw is an error. GL gives it after the flush.
  void draw_counted(ShapeScene& scene) {
    hook::DrawTransformFeedback(scene.context(), GL_TRIANGLES, 0);
    EXPECT_EQ(hook::GetError(scene.context()), static_cast<GLenum>(GL_INVALID_OPERATION));
  }

  PlainContext window_;
  gl::Dispatch spied_;
};

TEST_F(CountedDraws, FlushOnceAfterIndirectDraws) {
  ShapeScene scene(spied_, ShapeKind::tagged);
  draw_counted(scene);
  scene.draw_frame();
  scene.draw_frame();
  EXPECT_EQ(flushes, 0);
  draw_counted(scene);
  EXPECT_EQ(flushes, 1);
  draw_counted(scene);
  EXPECT_EQ(flushes, 1);
}

TEST_F(CountedDraws, DoNotFlushAfterOtherDraws) {
  ShapeScene scene(spied_, ShapeKind::uniform);
  scene.draw_frame();
  draw_counted(scene);
  EXPECT_EQ(flushes, 0);
}

}  // namespace
}  // namespace glark::core::test
