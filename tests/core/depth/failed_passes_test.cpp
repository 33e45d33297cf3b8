// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The passes of another kind of depths are compiled while those of the first kind are in use. If that fails, each draw
// of this kind stays coarse, not only the first one.
#include "tests/core/evaluate/shape_scene.h"

namespace glark::core::test {
namespace {

const gl::Dispatch* real = nullptr;
bool linking_fails = false;

void link_program(GLuint program) {
  if (!linking_fails) real->LinkProgram(program);
}

class FailedPasses : public testing::Test {
 protected:
  FailedPasses() : failing_(window_.gl) {
    real = &window_.gl;
    linking_fails = false;
    failing_.LinkProgram = link_program;
  }
  ~FailedPasses() override { linking_fails = false; }

  PlainContext window_;
  gl::Dispatch failing_;
};

TEST_F(FailedPasses, LeaveEachDrawCoarse) {
  ShapeScene scene(failing_, ShapeKind::tagged);
  hook::ARKParameteriARK(scene.context(), GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  hook::ARKParameteriARK(scene.context(), GL_UNIFORM_DEPTH_LEVEL_ARK, 0);
  const std::vector<GLubyte> coarse = scene.draw_frame();
  hook::ARKParameteriARK(scene.context(), GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK);
  const std::vector<GLubyte> refined = scene.draw_frame();
  ASSERT_NE(refined, coarse);
  linking_fails = true;
  hook::ARKParameteriARK(scene.context(), GL_PATTERN_INTERIOR_ARK, GL_SMOOTH_INTERIOR_ARK);
  for (int frame = 0; frame < 3; ++frame) {
    EXPECT_EQ(scene.draw_frame(), coarse) << frame;
    EXPECT_EQ(hook::GetError(scene.context()), static_cast<GLenum>(GL_NO_ERROR)) << frame;
  }
}

}  // namespace
}  // namespace glark::core::test
