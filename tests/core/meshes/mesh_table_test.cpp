// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/meshes/mesh_table.h"

#include <gtest/gtest.h>

namespace glark::core {
namespace {

constexpr MeshKey ball{{7, 1, 0}};
constexpr MeshKey copy_of_ball{{8, 1, 0}};

constexpr MeshPass colors{.curves = true, .uses_depth = true, .writes_depth = true};
constexpr MeshPass flat_colors{.uses_depth = true, .writes_depth = true};
constexpr MeshPass flat_depth{.uses_depth = true, .writes_depth = true, .shows = false};
constexpr MeshPass curved_depth{.curves = true, .uses_depth = true, .writes_depth = true, .shows = false};
constexpr MeshPass equal_colors{.curves = true, .uses_depth = true, .equal = true};
constexpr MeshPass overlay{};
constexpr MeshPass not_compiled{.compiles = true, .uses_depth = true, .writes_depth = true};

class MeshTables : public testing::Test {
 protected:
  // Draws the passes for three frames, and returns the verdict on the last pass of the fourth.
  MeshVerdict settled(const std::vector<std::pair<MeshKey, MeshPass>>& passes) {
    MeshVerdict last = MeshVerdict::waits;
    for (int frame = 0; frame < 4; ++frame) {
      for (const auto& [key, pass] : passes) last = table_.draw(key, pass);
      table_.frame_finished();
    }
    return last;
  }
  MeshTable table_;
};

TEST_F(MeshTables, AMeshIsCurvedFromTheThirdFrameOn) {
  for (int frame = 1; frame <= 5; ++frame) {
    EXPECT_EQ(table_.draw(ball, colors), frame <= 2 ? MeshVerdict::waits : MeshVerdict::curved) << frame;
    table_.frame_finished();
  }
}

// Its programs are compiled in later frames.
TEST_F(MeshTables, AMeshWaitsInAllPassesUntilTheFrameAfterItsProgramsAreCompiled) {
  for (int frame = 1; frame <= 9; ++frame) {
    const bool compiles = frame >= 3 && frame <= 6;
    const MeshVerdict wanted = frame <= 7 ? MeshVerdict::waits : MeshVerdict::curved;
    if (compiles) {
      EXPECT_EQ(table_.draw(ball, not_compiled), MeshVerdict::waits) << frame;
    }
    if (frame != 3) {  // a pass before the missing one would be curved
      EXPECT_EQ(table_.draw(ball, colors), wanted) << frame;
    }
    table_.frame_finished();
  }
}

TEST_F(MeshTables, APassThatIsNotCompiledSaysNothingAboutItsMesh) {
  for (int frame = 0; frame < 9; ++frame) {
    EXPECT_EQ(table_.draw(ball, not_compiled), MeshVerdict::waits);
    EXPECT_EQ(table_.draw(ball, equal_colors), MeshVerdict::waits) << "it meets the pass before";
    table_.frame_finished();
  }
  EXPECT_EQ(settled({{ball, colors}}), MeshVerdict::curved);
}

TEST_F(MeshTables, PassesAreCompiledInTheLastFrameOfTheWatch) {
  EXPECT_FALSE(table_.is_nearly_watched(ball));
  table_.draw(ball, colors);
  EXPECT_FALSE(table_.is_nearly_watched(ball));
  table_.frame_finished();
  table_.draw(ball, colors);
  EXPECT_TRUE(table_.is_nearly_watched(ball));
  table_.compiles(ball);
  table_.frame_finished();
  EXPECT_EQ(table_.draw(ball, colors), MeshVerdict::waits);
  table_.frame_finished();
  EXPECT_EQ(table_.draw(ball, colors), MeshVerdict::curved);
}

TEST_F(MeshTables, ACurvedMeshIsKnown) {
  settled({{ball, colors}});
  EXPECT_TRUE(table_.is_curved(ball));
  EXPECT_FALSE(table_.is_curved(copy_of_ball));
  const MeshKey list = mesh_of_list(1);
  settled({{list, colors}});
  EXPECT_TRUE(table_.is_curved(mesh_of_list(2))) << "it would be curved at once";
}

// A program that compiles its list again in every frame.
TEST_F(MeshTables, ANewListWaitsWhileProgramsOfItsSourceAreCompiled) {
  for (std::uint64_t frame = 1; frame <= 7; ++frame) {
    const MeshKey list = mesh_of_list(frame);
    EXPECT_EQ(table_.draw(list, colors), frame <= 5 ? MeshVerdict::waits : MeshVerdict::curved) << frame;
    if (frame >= 2 && frame <= 4) table_.compiles(list);
    table_.frame_finished();
  }
}

TEST_F(MeshTables, AllDrawsOfAFrameGetTheSameVerdict) {
  for (int draw = 0; draw < 9; ++draw) EXPECT_EQ(table_.draw(ball, colors), MeshVerdict::waits);
}

TEST_F(MeshTables, AFrameWithoutDrawsIsNone) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(table_.draw(ball, colors), i < 2 ? MeshVerdict::waits : MeshVerdict::curved);
    for (int again = 0; again < 3; ++again) table_.frame_finished();
  }
}

// A program that compiles its list, or allocates its arrays, again in every frame.
TEST_F(MeshTables, ANewListOrArrayNeedNotWaitOnceItsSourceWasWatched) {
  for (std::uint64_t frame = 1; frame <= 5; ++frame) {
    const MeshKey array{{std::uint64_t{12} << 32U, 0, 0x1000 * frame}};
    const MeshVerdict wanted = frame <= 2 ? MeshVerdict::waits : MeshVerdict::curved;
    EXPECT_EQ(table_.draw(mesh_of_list(frame), colors), wanted) << frame;
    EXPECT_EQ(table_.draw(array, colors), wanted) << frame;
    EXPECT_EQ(table_.draw(MeshKey{{100 + frame, 1, 0}}, colors), MeshVerdict::waits) << "a buffer's name lasts";
    table_.frame_finished();
  }
}

TEST_F(MeshTables, ASourceWithAMeshOfBothKindsOfPassesIsNotTrusted) {
  for (std::uint64_t frame = 1; frame <= 5; ++frame) {
    EXPECT_EQ(table_.draw(mesh_of_list(frame), flat_colors), MeshVerdict::flat) << frame;
    EXPECT_EQ(table_.draw(mesh_of_list(frame), colors), MeshVerdict::flat) << frame;
    EXPECT_EQ(table_.draw(mesh_of_list(100 + frame), colors), MeshVerdict::waits) << frame;
    table_.frame_finished();
  }
}

// Lines and planes without normals say nothing about the meshes beside them.
TEST_F(MeshTables, AListThatIsOnlyFlatDoesNotMakeOthersWait) {
  for (std::uint64_t frame = 1; frame <= 5; ++frame) {
    table_.draw(mesh_of_list(100 + frame), flat_colors);
    EXPECT_EQ(table_.draw(mesh_of_list(frame), colors), frame <= 2 ? MeshVerdict::waits : MeshVerdict::curved) << frame;
    table_.frame_finished();
  }
}

// In the first frame, nothing tells that the sky is a background.
TEST_F(MeshTables, ABackgroundDoesNotMakeItsSourceMixed) {
  constexpr MeshPass sky{.curves = true, .uses_depth = true};
  constexpr MeshPass known_sky{.uses_depth = true, .behind = true};
  for (std::uint64_t frame = 1; frame <= 5; ++frame) {
    table_.draw(mesh_of_list(100), frame == 1 ? sky : known_sky);
    EXPECT_EQ(table_.draw(mesh_of_list(frame), colors), frame <= 2 ? MeshVerdict::waits : MeshVerdict::curved) << frame;
    table_.frame_finished();
  }
}

TEST_F(MeshTables, KnowsWhoWroteDepth) {
  EXPECT_TRUE(table_.any_wrote_depth()) << "nothing is known in the first frame";
  EXPECT_FALSE(table_.wrote_depth(ball));
  table_.draw(ball, colors);
  table_.draw(copy_of_ball, equal_colors);
  table_.frame_finished();
  EXPECT_TRUE(table_.any_wrote_depth() && table_.wrote_depth(ball));
  EXPECT_FALSE(table_.wrote_depth(copy_of_ball));
  table_.draw(copy_of_ball, equal_colors);
  table_.frame_finished();
  EXPECT_FALSE(table_.any_wrote_depth() || table_.wrote_depth(ball)) << "two frames ago";
}

TEST_F(MeshTables, OneFlatPassKeepsTheMeshFlat) {
  EXPECT_EQ(settled({{ball, flat_depth}, {ball, colors}}), MeshVerdict::flat);
  EXPECT_EQ(settled({{copy_of_ball, colors}}), MeshVerdict::curved) << "another mesh";
}

// The colour pass, which has the normals, comes after the pre-pass.
TEST_F(MeshTables, APassThatLacksOnlyNormalsIsExcusedInTheFirstFrame) {
  constexpr MeshPass lacking{.lacks_normal = true, .uses_depth = true, .writes_depth = true, .shows = false};
  EXPECT_EQ(table_.draw(ball, lacking), MeshVerdict::waits);
  table_.draw(ball, colors);
  table_.set_normals(ball, {copy_of_ball, GL_FLOAT});
  table_.frame_finished();
  EXPECT_EQ(table_.normals(ball).key, copy_of_ball);
  EXPECT_EQ(settled({{ball, curved_depth}, {ball, equal_colors}}), MeshVerdict::curved);
  EXPECT_EQ(table_.draw(ball, lacking), MeshVerdict::flat) << "it must have found them";
}

// A shadow map shows an object that is out of view. When it comes into view, its normals are known.
TEST_F(MeshTables, APassThatLacksOnlyNormalsIsExcusedUntilAnotherPassHasThem) {
  constexpr MeshPass lacking{.lacks_normal = true, .uses_depth = true, .writes_depth = true};
  for (int frame = 1; frame <= 5; ++frame) {
    EXPECT_EQ(table_.draw(ball, lacking), MeshVerdict::waits) << frame;
    table_.frame_finished();
  }
  EXPECT_EQ(table_.draw(ball, lacking), MeshVerdict::waits);
  for (int frame = 1; frame <= 3; ++frame) {
    EXPECT_EQ(table_.draw(ball, colors), frame <= 2 ? MeshVerdict::waits : MeshVerdict::curved) << frame;
    table_.frame_finished();
  }
}

TEST_F(MeshTables, APassThatFindsNoNormalsMakesItsMeshFlatInTheNextFrame) {
  constexpr MeshPass lacking{.lacks_normal = true, .uses_depth = true, .writes_depth = true};
  EXPECT_EQ(settled({{ball, lacking}, {ball, colors}}), MeshVerdict::flat);
}

constexpr MeshPass made_colors{.curves = true, .made = true, .uses_depth = true, .writes_depth = true};
constexpr MeshPass made_equal{.curves = true, .made = true, .uses_depth = true, .equal = true};

TEST_F(MeshTables, NormalsFromPositionsCurveAMeshInAllPasses) {
  EXPECT_EQ(settled({{ball, made_colors}, {ball, made_equal}}), MeshVerdict::curved);
}

TEST_F(MeshTables, TwoKindsOfNormalsAreTwoShapes) {
  table_.draw(ball, made_colors);
  EXPECT_EQ(table_.draw(ball, colors), MeshVerdict::waits) << "the normals were not known yet in the first frame";
  table_.frame_finished();
  table_.draw(ball, made_colors);
  EXPECT_EQ(table_.draw(ball, colors), MeshVerdict::flat);
}

TEST_F(MeshTables, LooseDrawsWithNormalsFromPositionsAreNotMet) {
  EXPECT_EQ(settled({{loose_mesh, made_colors}, {loose_mesh, colors}}), MeshVerdict::curved);
  EXPECT_EQ(settled({{loose_mesh, made_colors}, {loose_mesh, equal_colors}}), MeshVerdict::flat);
}

TEST_F(MeshTables, AMeshThatWasFlatOnceStaysFlat) {
  EXPECT_EQ(settled({{ball, colors}}), MeshVerdict::curved);
  EXPECT_EQ(table_.draw(ball, flat_colors), MeshVerdict::flat);
  EXPECT_EQ(settled({{ball, colors}}), MeshVerdict::flat);
}

TEST_F(MeshTables, PassesThatCanAllBeCurvedAre) {
  EXPECT_EQ(settled({{ball, curved_depth}, {ball, equal_colors}}), MeshVerdict::curved);
}

TEST_F(MeshTables, APassWithoutDepthMeetsNothing) {
  EXPECT_EQ(settled({{ball, overlay}, {ball, colors}}), MeshVerdict::curved);
}

TEST_F(MeshTables, UnrelatedLooseDrawsStayApart) {
  EXPECT_EQ(settled({{loose_mesh, flat_colors}, {loose_mesh, colors}}), MeshVerdict::curved);
}

TEST_F(MeshTables, ALooseEqualPassMayMeetAFlatDraw) {
  EXPECT_EQ(settled({{loose_mesh, flat_colors}, {loose_mesh, equal_colors}}), MeshVerdict::flat);
}

TEST_F(MeshTables, LooseDrawsThatMustMeetStayFlat) {
  constexpr MeshPass flat_equal{.uses_depth = true, .equal = true};
  EXPECT_EQ(settled({{loose_mesh, colors}, {loose_mesh, flat_equal}}), MeshVerdict::flat);
}

TEST_F(MeshTables, AnEqualPassNeedsAnEarlierPassOfItsFrame) {
  EXPECT_EQ(settled({{copy_of_ball, curved_depth}, {ball, equal_colors}}), MeshVerdict::unknown_partner);
}

// A browser shows its window between the depth pass of a page and the pass that must meet it.
TEST_F(MeshTables, AnEqualPassMayMeetAPassOfTheFrameBefore) {
  const auto show_between = [this] {
    EXPECT_NE(table_.draw(ball, curved_depth), MeshVerdict::unknown_partner);
    table_.frame_finished();
    return table_.draw(ball, equal_colors);
  };
  settled({{ball, curved_depth}, {ball, equal_colors}});
  EXPECT_EQ(show_between(), MeshVerdict::curved);
  table_ = {};
  for (int frame = 0; frame < 2; ++frame) {
    EXPECT_EQ(show_between(), MeshVerdict::waits) << "the pass before was not curved";
  }
  EXPECT_EQ(show_between(), MeshVerdict::curved);
}

TEST_F(MeshTables, AFailedDrawMakesItsMeshFlat) {
  EXPECT_EQ(settled({{ball, colors}}), MeshVerdict::curved);
  table_.draw(ball, flat_colors);
  EXPECT_EQ(table_.draw(ball, colors), MeshVerdict::flat) << "in the same frame";
}

TEST(MeshKeys, AreTheSourceOfThePositions) {
  const AttributeSource source{.buffer = 3, .generation = 2, .offset = 24, .stride = 24};
  AttributeSource other = source;
  other.offset = 240;
  EXPECT_EQ(mesh_of(source, 12), mesh_of(other, 12)) << "another range of the same vertices";
  other.offset = 12;
  EXPECT_NE(mesh_of(source, 12), mesh_of(other, 12)) << "another attribute of the vertex";
  other = source;
  other.generation = 3;
  EXPECT_NE(mesh_of(source, 12), mesh_of(other, 12)) << "another buffer of the same name";
  other = source;
  other.relative_offset = 8;
  EXPECT_NE(mesh_of(source, 12), mesh_of(other, 12));
  EXPECT_NE(mesh_of(source, 12), mesh_of_list(3));
}

TEST(MeshKeys, ClientMemoryIsItsAddress) {
  const AttributeSource source{.offset = 4096};
  AttributeSource other = source;
  other.offset = 4108;
  EXPECT_EQ(mesh_of(source, 12), mesh_of(source, 12));
  EXPECT_NE(mesh_of(source, 12), mesh_of(other, 12));
  EXPECT_NE(mesh_of(source, 12), loose_mesh);
}

}  // namespace
}  // namespace glark::core
