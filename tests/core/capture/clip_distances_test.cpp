// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The application's clip distances are off while its vertices are captured, and on again for the draw.
#include "tests/core/evaluate/shape_scene.h"

namespace glark::core::test {
namespace {

const gl::Dispatch* clipping = nullptr;
std::vector<bool> captured_clipped;

void begin_feedback(GLenum mode) {
  captured_clipped.push_back(clipping->IsEnabled(GL_CLIP_DISTANCE3) != GL_FALSE);
  clipping->BeginTransformFeedback(mode);
}

class ClipDistances : public testing::Test {
 protected:
  ClipDistances() : spied_(window_.gl), scene_((spy(), spied_), ShapeKind::uniform) {}
  void spy() {
    clipping = &window_.gl;
    captured_clipped.clear();
    spied_.BeginTransformFeedback = begin_feedback;
  }
  void expect_clipped_draw() {
    captured_clipped.clear();
    scene_.draw_frame();
    EXPECT_EQ(captured_clipped, std::vector<bool>{false});
    EXPECT_EQ(window_.gl.IsEnabled(GL_CLIP_DISTANCE3), GL_TRUE);
    EXPECT_EQ(window_.gl.IsEnabled(GL_CLIP_DISTANCE2), GL_FALSE);
  }

  PlainContext window_;
  gl::Dispatch spied_;
  ShapeScene scene_;
};

TEST_F(ClipDistances, AreOffInCaptures) {
  hook::Enable(scene_.context(), GL_CLIP_DISTANCE3);
  expect_clipped_draw();
}

TEST_F(ClipDistances, OfTheAttributeStackAreFollowed) {
  hook::Enable(scene_.context(), GL_CLIP_DISTANCE3);
  hook::PushAttrib(scene_.context(), GL_ENABLE_BIT);
  hook::Disable(scene_.context(), GL_CLIP_DISTANCE3);
  hook::PopAttrib(scene_.context());
  expect_clipped_draw();
}

TEST_F(ClipDistances, StayOffIfTheApplicationHasDisabledThem) {
  hook::Enable(scene_.context(), GL_CLIP_DISTANCE3);
  hook::Disable(scene_.context(), GL_CLIP_DISTANCE3);
  scene_.draw_frame();
  EXPECT_EQ(window_.gl.IsEnabled(GL_CLIP_DISTANCE3), GL_FALSE);
}

}  // namespace
}  // namespace glark::core::test
