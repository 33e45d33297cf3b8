// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Options that change between two frames, and draws that a user watches. Links the core without the shim.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <vector>

#include "glark/core/context.h"
#include "glark/core/report/statistics.h"
#include "glark/core/stages.h"
#include "glark/gl/hooks.h"
#include "tests/core/support/plain_context.h"
#include "tests/core/support/state_snapshot.h"

namespace glark::core::test {
namespace {

using Color = std::array<GLubyte, 3>;
constexpr Color white{255, 255, 255};

Color tinted(const DrawGroupText& group) {
  Color color{};
  for (std::size_t i = 0; i < 3; ++i) color[i] = static_cast<GLubyte>(group.color[i] * 255 + 0.5F);
  return color;
}

// White triangles that fill the window, in a context of transparent refinement.
class WatchedDraws : public testing::Test {
 protected:
  WatchedDraws() {
    options_.transparent = true;
    options_.level = 1;
    options_.max_level = 2;
    options_.refinement = Refinement::linear_outputs;
    options_.left_draws = 0;
    context_ = Context::create(window_.gl, make_share_group(), options_);
    hook::Enable(*context_, GL_DEPTH_TEST);
    hook::DepthFunc(*context_, GL_ALWAYS);
  }
  ~WatchedDraws() override {
    context_->release();
    context_.reset();
  }

  void change() { context_->change_options(options_); }

  void draw() {
    static constexpr std::array<GLfloat, 12> corners{-1, -1, 1, -1, -1, 1, -1, 1, 1, -1, 1, 1};
    window_.gl.EnableClientState(GL_VERTEX_ARRAY);
    window_.gl.VertexPointer(2, GL_FLOAT, 0, corners.data());
    context_->state().refresh();
    if (context_->refining())  // as the wrappers of the shim do
      hook::DrawArrays(*context_, GL_TRIANGLES, 0, 6);
    else
      window_.gl.DrawArrays(GL_TRIANGLES, 0, 6);
  }
  // A frame with one draw; returns its refined triangles.
  std::uint64_t draw_frame() {
    window_.gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const std::uint64_t before = statistics().refined_triangles;
    draw();
    context_->frame_finished();
    return statistics().refined_triangles - before;
  }
  Color pixel(int x, int y) const {
    Color color{};
    window_.gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    window_.gl.ReadPixels(x, y, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, color.data());
    return color;
  }
  const std::vector<WatchedClass>& classes() const { return context_->stages()->draw().watch().last_frame(); }

  PlainContext window_;
  ContextOptions options_;
  std::unique_ptr<Context> context_;
};

TEST_F(WatchedDraws, TheNextFrameHasTheNewLevel) {
  EXPECT_EQ(draw_frame(), 2U * 4);
  options_.level = 3;
  change();
  EXPECT_EQ(draw_frame(), 2U * 64) << "the pool of patterns grows";
  options_.level = 2;
  change();
  EXPECT_EQ(draw_frame(), 2U * 16);
}

TEST_F(WatchedDraws, APausedContextRefinesNothing) {
  draw_frame();
  options_.live.paused = true;
  change();
  EXPECT_EQ(draw_frame(), 0U);
  EXPECT_EQ(pixel(5, 5), white);
  options_.live.paused = false;
  change();
  EXPECT_EQ(draw_frame(), 2U * 4);
}

TEST_F(WatchedDraws, FalseColorsShowTheDecision) {
  options_.live.false_colors = true;
  change();
  draw_frame();
  EXPECT_EQ(pixel(5, 5), tinted(text_of(DrawGroup::refined)));
  options_.level = 0;
  change();
  draw_frame();
  EXPECT_EQ(pixel(5, 5), tinted(text_of(DrawGroup::user)));
}

TEST_F(WatchedDraws, ABlendedDrawKeepsItsBlending) {
  options_.live.false_colors = true;
  change();
  hook::Enable(*context_, GL_BLEND);
  draw_frame();
  EXPECT_EQ(pixel(5, 5), (Color{0, 255, 0})) << "refined draws change the green channel";
}

TEST_F(WatchedDraws, TheLeftHalfOfASplitWindowIsAsTheProgramDrawsIt) {
  options_.live.split = true;
  options_.live.false_colors = true;
  options_.live.window = {plain_side, plain_side};
  change();
  EXPECT_EQ(draw_frame(), 2U * 4);
  EXPECT_EQ(pixel(plain_side / 2 - 1, 60), white);
  EXPECT_EQ(pixel(plain_side / 2, 60), tinted(text_of(DrawGroup::refined)));
}

TEST_F(WatchedDraws, SplitStaysWithinTheScissorOfTheProgram) {
  options_.live.split = true;
  options_.live.window = {plain_side, plain_side};
  change();
  draw_frame();
  window_.gl.Enable(GL_SCISSOR_TEST);
  window_.gl.Scissor(0, 0, plain_side, 0);
  window_.gl.ClearColor(0, 0, 1, 1);
  window_.gl.Disable(GL_SCISSOR_TEST);
  window_.gl.Clear(GL_COLOR_BUFFER_BIT);
  window_.gl.Enable(GL_SCISSOR_TEST);
  window_.gl.Scissor(40, 40, 48, 48);
  draw();
  EXPECT_EQ(pixel(39, 60), (Color{0, 0, 255}));
  EXPECT_EQ(pixel(40, 60), white);
  EXPECT_EQ(pixel(87, 60), white);
  EXPECT_EQ(pixel(88, 60), (Color{0, 0, 255}));
}

TEST_F(WatchedDraws, ClassesHaveWhatWasDecided) {
  options_.live.counts_classes = true;
  change();
  draw_frame();
  ASSERT_EQ(classes().size(), 1U);
  EXPECT_EQ(classes()[0].triangles, 2U);
  EXPECT_EQ(classes()[0].key.verdict.cause, std::nullopt);
  EXPECT_EQ(classes()[0].key.verdict.level, 1U);
}

TEST_F(WatchedDraws, MarkedDrawsAreTinted) {
  options_.live.counts_classes = true;
  change();
  draw_frame();
  options_.live.marked = classes()[0].key.state;
  change();
  draw_frame();
  EXPECT_EQ(pixel(5, 5), tinted(marked_group));
  options_.live.marked->blend = true;
  change();
  draw_frame();
  EXPECT_EQ(pixel(5, 5), white) << "draws in another state are not marked";
}

TEST_F(WatchedDraws, ThePixelNamesTheDrawsThatChangeIt) {
  options_.live.counts_classes = true;
  options_.live.window = {plain_side, plain_side};
  options_.live.pixel = {5, 5};
  change();
  draw_frame();
  ASSERT_EQ(classes().size(), 1U);
  EXPECT_EQ(classes()[0].pixel_step, 1U);
  window_.gl.Enable(GL_SCISSOR_TEST);
  window_.gl.Scissor(20, 20, 20, 20);
  draw();
  context_->frame_finished();
  ASSERT_EQ(classes().size(), 1U);
  EXPECT_EQ(classes()[0].pixel_step, 0U);
}

// Every value that OpenGL returns is the same after a draw that is watched in all ways.
TEST_F(WatchedDraws, LeaveTheStateOfTheProgram) {
  draw_frame();
  options_.live = {.false_colors = true,
                   .counts_classes = true,
                   .split = true,
                   .pixel = std::array{5, 5},
                   .window = {plain_side, plain_side}};
  change();
  window_.gl.BlendColor(0.25F, 0.5F, 0.75F, 1);
  window_.gl.BlendFuncSeparate(GL_DST_COLOR, GL_ONE, GL_ZERO, GL_SRC_ALPHA);
  window_.gl.BlendEquationSeparate(GL_MAX, GL_FUNC_SUBTRACT);
  window_.gl.Scissor(3, 4, 100, 90);
  window_.gl.PixelStorei(GL_PACK_ROW_LENGTH, 7);
  const StateSnapshot::Names names = StateSnapshot::find_names();
  for (const bool blends : {false, true}) {
    blends ? hook::Enable(*context_, GL_BLEND) : hook::Disable(*context_, GL_BLEND);
    draw();  // sets what client arrays change
    const StateSnapshot before = StateSnapshot::take(names);
    draw();
    EXPECT_EQ(StateSnapshot::take(names).difference(before), "");
    EXPECT_GT(before.size(), 500U);
  }
  EXPECT_EQ(hook::GetError(*context_), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace glark::core::test
