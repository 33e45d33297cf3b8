// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Counts the draws of curved, tagged and displaced triangles that use kept refined vertices.
#include "tests/core/evaluate/shape_scene.h"

namespace glark::core::test {
namespace {

class KeptShapesCounted : public testing::TestWithParam<ShapeKind> {
 protected:
  PlainContext window_;
};

std::string kind_name(const testing::TestParamInfo<ShapeKind>& kind) {
  constexpr std::array names{"uniform", "tagged", "deep", "displaced"};
  return names.at(static_cast<std::size_t>(kind.param));
}

INSTANTIATE_TEST_SUITE_P(All, KeptShapesCounted,
                         testing::Values(ShapeKind::uniform, ShapeKind::tagged, ShapeKind::deep, ShapeKind::displaced),
                         kind_name);

TEST_P(KeptShapesCounted, FromTheSixthFrameOn) {
  ShapeScene scene(window_.gl, GetParam());
  EXPECT_EQ(scene.kept_of(5), 0U);
  EXPECT_EQ(scene.kept_of(4), 4U);
}

class KeptHeights : public testing::Test {
 protected:
  KeptHeights() { EXPECT_EQ(scene_.kept_of(7), 2U); }

  PlainContext window_;
  ShapeScene scene_{window_.gl, ShapeKind::displaced};
};

// GL is asked again, and has the same texture.
TEST_F(KeptHeights, StayWhereOtherUnitsGetTextures) {
  scene_.context().textures().bound();
  EXPECT_EQ(scene_.kept_of(3), 3U);
}

TEST_F(KeptHeights, StayWhereAnotherTextureIsWritten) {
  scene_.context().textures().to_texture(77);
  scene_.context().textures().to_target(GL_TEXTURE_3D);
  EXPECT_EQ(scene_.kept_of(3), 3U);
}

TEST_F(KeptHeights, AreNotKeptWhileTheTextureIsWrittenInEveryFrame) {
  for (int frame = 0; frame < 10; ++frame) {
    scene_.context().textures().to_any();
    EXPECT_EQ(scene_.kept_of(1), 0U);
  }
  EXPECT_GT(scene_.kept_of(8), 0U);
}

TEST_F(KeptHeights, AreNotKeptFromAFramebuffersTexture) {
  scene_.context().textures().attached(1);
  EXPECT_EQ(scene_.kept_of(10), 0U);
}

TEST_F(KeptHeights, AreNotKeptOnceAListHasTextures) {
  scene_.context().textures().never_trust_any();
  EXPECT_EQ(scene_.kept_of(10), 0U);
}

}  // namespace
}  // namespace glark::core::test
