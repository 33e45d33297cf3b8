// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/meshes/unknown_partners.h"

#include <gtest/gtest.h>

#include "glark/core/meshes/mesh_table.h"

namespace glark::core {
namespace {

constexpr MeshKey ball{{7, 1, 0}};
constexpr MeshKey other{{8, 1, 0}};
constexpr std::uint64_t window = 1;
constexpr std::uint64_t shadow_map = 2;

constexpr MeshPass colors{.curves = true, .uses_depth = true, .writes_depth = true, .target = window};
constexpr MeshPass flat_colors{.uses_depth = true, .writes_depth = true, .target = window};
constexpr MeshPass flat_depth{.uses_depth = true, .writes_depth = true, .shows = false, .target = window};

MeshPass changed(MeshPass pass, bool MeshPass::*flag) {
  pass.*flag = true;
  return pass;
}
MeshPass in_shadow_map(MeshPass pass) {
  pass.target = shadow_map;
  return pass;
}

class UnknownPartnersOfMeshes : public testing::Test {
 protected:
  using Passes = std::vector<std::pair<MeshKey, MeshPass>>;
  // Draws the passes for some frames, and returns the verdict on the last pass of the last one.
  MeshVerdict settled(const Passes& passes, std::uint64_t frames = 4) {
    MeshVerdict last = MeshVerdict::waits;
    for (std::uint64_t frame = 0; frame < frames; ++frame) {
      for (const auto& [key, pass] : passes) last = table_.draw(key, pass);
      table_.frame_finished();
    }
    return last;
  }
  MeshTable table_;
};

// Shadow volumes of a mesh in a buffer, made by glBegin.
TEST_F(UnknownPartnersOfMeshes, APreparationWithoutIdentityMayMeetAnyMesh) {
  constexpr MeshPass volume{.uses_depth = true, .shows = false, .marks = true, .target = window};
  EXPECT_EQ(settled({{ball, colors}, {loose_mesh, volume}, {ball, colors}}), MeshVerdict::unknown_partner);
}

// A depth pre-pass that reads its positions from a buffer of their own.
TEST_F(UnknownPartnersOfMeshes, APreparationThatShowsNowhereMayMeetAnyMesh) {
  EXPECT_EQ(settled({{other, flat_depth}, {ball, colors}}), MeshVerdict::unknown_partner);
  EXPECT_EQ(settled({{ball, colors}}), MeshVerdict::unknown_partner) << "for some time";
  settled({{ball, colors}}, UnknownPartners::frames_of_doubt);
  EXPECT_EQ(settled({{ball, colors}}), MeshVerdict::curved);
}

TEST_F(UnknownPartnersOfMeshes, APreparationThatShowsMeetsItself) {
  EXPECT_EQ(settled({{other, flat_depth}, {other, flat_colors}, {ball, colors}}), MeshVerdict::curved);
}

// A shadow map shows an object that is out of view.
TEST_F(UnknownPartnersOfMeshes, APreparationThatShowedEarlierMeetsItself) {
  settled({{other, flat_colors}, {ball, colors}});
  EXPECT_EQ(settled({{other, in_shadow_map(flat_depth)}, {ball, colors}}), MeshVerdict::curved);
}

TEST_F(UnknownPartnersOfMeshes, TheDoubtEndsWhenThePreparationShows) {
  EXPECT_EQ(settled({{other, in_shadow_map(flat_depth)}, {ball, colors}}), MeshVerdict::unknown_partner);
  EXPECT_EQ(settled({{other, flat_colors}, {ball, colors}}, 2), MeshVerdict::curved);
}

// The bottom of a hole: nothing that is strictly nearer can lie on it.
TEST_F(UnknownPartnersOfMeshes, ALidMeetsNothing) {
  for (const MeshKey& key : {other, loose_mesh}) {
    EXPECT_EQ(settled({{ball, colors}, {key, flat_depth}, {ball, colors}}), MeshVerdict::curved);
  }
  EXPECT_EQ(settled({{loose_mesh, colors}, {loose_mesh, flat_depth}, {loose_mesh, colors}}), MeshVerdict::curved);
}

TEST_F(UnknownPartnersOfMeshes, ALaterDrawMayLieOnADepthPass) {
  for (const MeshKey& key : {other, loose_mesh}) {
    table_ = {};
    const Passes passes{{ball, colors}, {key, flat_depth}, {ball, changed(colors, &MeshPass::meets_depth)}};
    EXPECT_EQ(settled(passes), MeshVerdict::unknown_partner);
  }
}

TEST_F(UnknownPartnersOfMeshes, ALaterDrawElsewhereDoesNotLieOnALid) {
  MeshPass elsewhere = changed(colors, &MeshPass::meets_depth);
  elsewhere.target = 3;
  EXPECT_EQ(settled({{ball, colors}, {other, flat_depth}, {ball, elsewhere}}), MeshVerdict::curved);
}

// The depths of a shadow map are copied or read later.
TEST_F(UnknownPartnersOfMeshes, ALidLiesBesideThingsThatShow) {
  for (const MeshKey& key : {other, loose_mesh}) {
    table_ = {};
    EXPECT_EQ(settled({{key, flat_depth}, {ball, colors}}), MeshVerdict::unknown_partner) << "nothing shows before it";
    table_ = {};
    EXPECT_EQ(settled({{ball, colors}, {key, in_shadow_map(flat_depth)}, {ball, colors}}),
              MeshVerdict::unknown_partner);
  }
}

TEST_F(UnknownPartnersOfMeshes, AStencilOrAnOffsetMakesNoLid) {
  for (bool MeshPass::*const flag : {&MeshPass::marks, &MeshPass::meets_depth}) {
    table_ = {};
    EXPECT_EQ(settled({{ball, colors}, {other, changed(flat_depth, flag)}, {ball, colors}}),
              MeshVerdict::unknown_partner);
  }
}

constexpr std::uint64_t stencil = Framebuffers::window_stencil;
constexpr MeshPass mask{.shows = false, .marks = true, .target = window, .stencil = stencil};
constexpr MeshPass colors_in_mask{
    .curves = true, .uses_depth = true, .writes_depth = true, .marks = true, .target = window, .stencil = stencil};

// A browser fills a shape: it marks the pixels of the shape, and then draws a quad where they are marked.
TEST_F(UnknownPartnersOfMeshes, AMaskMeetsWhatUsesItsStencilBuffer) {
  MeshPass elsewhere = colors_in_mask;
  elsewhere.stencil = stencil + 1;
  for (const MeshKey& key : {other, loose_mesh}) {
    table_ = {};
    EXPECT_EQ(settled({{key, mask}, {ball, colors}}), MeshVerdict::curved);
    EXPECT_EQ(settled({{key, mask}, {ball, elsewhere}}), MeshVerdict::curved);
    EXPECT_EQ(settled({{key, mask}, {ball, colors_in_mask}}), MeshVerdict::unknown_partner);
    table_ = {};
    EXPECT_EQ(settled({{ball, colors_in_mask}, {key, mask}, {ball, colors}}), MeshVerdict::unknown_partner)
        << "in any order";
  }
}

TEST_F(UnknownPartnersOfMeshes, AMaskMeetsWhatTheLastFrameDrewInItsStencilBuffer) {
  settled({{ball, colors_in_mask}});
  EXPECT_EQ(settled({{other, mask}, {ball, colors}}, 1), MeshVerdict::curved) << "what is drawn later may not meet it";
  EXPECT_EQ(settled({{ball, colors}}, 1), MeshVerdict::unknown_partner);
}

// Shadow volumes compare depths.
TEST_F(UnknownPartnersOfMeshes, AStencilPassThatComparesDepthsIsNoMask) {
  EXPECT_EQ(settled({{other, changed(mask, &MeshPass::uses_depth)}, {ball, colors}}), MeshVerdict::unknown_partner);
}

TEST_F(UnknownPartnersOfMeshes, AMaskInAnUnknownStencilBufferMayMeetAnyMesh) {
  MeshPass unknown = mask;
  unknown.stencil = Framebuffers::unknown_stencil;
  EXPECT_EQ(settled({{other, unknown}, {ball, colors}}), MeshVerdict::unknown_partner);
}

// A mesh that is a lid, and something else as well.
TEST_F(UnknownPartnersOfMeshes, EachPassOverTheMeshMustBeALid) {
  const Passes passes{{ball, colors}, {other, flat_depth}, {other, in_shadow_map(flat_depth)}, {ball, colors}};
  EXPECT_EQ(settled(passes), MeshVerdict::unknown_partner);
}

// A picture of a tree, as smooth draws it in a shadow map: with two triangles, in all passes.
TEST_F(UnknownPartnersOfMeshes, AFewLonePolygonsMeetTheirOwnColors) {
  const MeshPass lone = changed(in_shadow_map(flat_depth), &MeshPass::lone);
  Passes passes(UnknownPartners::few_lone_polygons, {loose_mesh, lone});
  passes.emplace_back(loose_mesh, colors);
  EXPECT_EQ(settled(passes), MeshVerdict::curved);
  passes.insert(passes.begin(), {loose_mesh, lone});
  EXPECT_EQ(settled(passes), MeshVerdict::flat) << "a depth pass of single polygons may belong to any mesh";
}

// glEnd tells how many triangles lie between it and glBegin.
TEST_F(UnknownPartnersOfMeshes, ADrawMayTurnOutToBeALonePolygon) {
  const MeshPass open = changed(in_shadow_map(flat_depth), &MeshPass::open);
  const auto last_verdict = [&](std::uint64_t triangles) {
    MeshVerdict last = MeshVerdict::waits;
    for (int frame = 0; frame < 4; ++frame) {
      table_.draw(loose_mesh, open);
      table_.loose_ended(triangles);
      last = table_.draw(ball, colors);
      table_.frame_finished();
    }
    return last;
  };
  EXPECT_EQ(last_verdict(2), MeshVerdict::curved);
  EXPECT_EQ(last_verdict(0), MeshVerdict::curved);
  EXPECT_EQ(table_.draw(loose_mesh, colors), MeshVerdict::waits);
  EXPECT_EQ(last_verdict(3), MeshVerdict::unknown_partner);
  EXPECT_EQ(table_.draw(loose_mesh, colors), MeshVerdict::flat);
  table_ = {};
  EXPECT_EQ(settled({{loose_mesh, open}, {ball, colors}}), MeshVerdict::unknown_partner) << "it never ended";
}

TEST_F(UnknownPartnersOfMeshes, ALonePolygonThatMarksMayMeetAnyMesh) {
  const MeshPass lone = changed(flat_depth, &MeshPass::lone);
  for (bool MeshPass::*const flag : {&MeshPass::marks, &MeshPass::equal}) {
    table_ = {};
    const Passes passes{{loose_mesh, in_shadow_map(changed(lone, flag))}, {ball, colors}};
    EXPECT_EQ(settled(passes), MeshVerdict::unknown_partner);
  }
}

}  // namespace
}  // namespace glark::core
