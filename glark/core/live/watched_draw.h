// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A draw that a user watches: counted, tinted, and asked whether it changes the chosen pixel.
#pragma once

#include <cstdint>
#include <optional>

#include "glark/core/live/frame_watch.h"
#include "glark/core/live/pixel_reader.h"
#include "glark/core/live/tint.h"

namespace glark::core {

// Lives while the draw is issued. Not constructed or destroyed between glBegin and glEnd.
class WatchedDraw {
 public:
  struct Draw {
    DrawClassKey key;
    bool kept = false;
    std::uint64_t triangles = 0;
  };
  WatchedDraw(const Environment& environment, FrameWatch& frame, const Draw& draw);
  ~WatchedDraw();
  WatchedDraw(const WatchedDraw&) = delete;
  WatchedDraw& operator=(const WatchedDraw&) = delete;

 private:
  const Environment& env_;
  FrameWatch& frame_;
  Draw draw_;
  std::optional<PixelValue> before_;
  std::optional<Tint> tint_;
};

}  // namespace glark::core
