// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/live/watched_draw.h"

namespace glark::core {
namespace {

// The pixel is one of the window: framebuffers of another size have no such pixel.
bool may_change_pixel(const Environment& environment) {
  const LiveView& view = environment.options.live;
  const std::array<float, 2>& viewport = environment.bindings().viewport;
  return view.pixel &&
         (environment.state.framebuffers().bound_name() == 0 ||
          (viewport[0] == static_cast<float>(view.window[0]) && viewport[1] == static_cast<float>(view.window[1])));
}

}  // namespace

WatchedDraw::WatchedDraw(const Environment& environment, FrameWatch& frame, const Draw& draw)
    : env_(environment), frame_(frame), draw_(draw) {
  const LiveView& view = env_.options.live;
  if (view.counts_classes) {
    frame_.count(draw_.key, draw_.kept, draw_.triangles);
  }
  if (may_change_pixel(env_)) {
    before_ = read_pixel(env_, *view.pixel);
  }
  if (draw_.key.state.depth_only) {
    return;
  }
  if (view.marked == draw_.key.state) {
    tint_.emplace(env_, marked_group);
  } else if (view.false_colors) {
    tint_.emplace(env_, text_of(group_of(draw_.key.verdict, draw_.kept)));
  }
}

WatchedDraw::~WatchedDraw() {
  tint_.reset();
  if (before_ && env_.options.live.pixel && read_pixel(env_, *env_.options.live.pixel) != *before_) {
    frame_.changed_pixel(draw_.key, draw_.kept);
  }
}

}  // namespace glark::core
