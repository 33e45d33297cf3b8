// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// How a user watches the draws of a program while it runs. The host may change it between two frames.
#pragma once

#include <array>
#include <optional>

#include "glark/core/draw_rule.h"

namespace glark::core {

struct LiveView {
  bool paused = false;                           // draws stay as the program makes them; everything is still tracked
  bool false_colors = false;                     // draws are tinted by what was decided about them
  bool counts_classes = false;                   // the classes of the last frame are kept (live/frame_watch.h)
  bool split = false;                            // in the left half of the window, draws stay as the program makes them
  std::optional<DrawState> marked = {};          // draws in this state are tinted, too
  std::optional<std::array<int, 2>> pixel = {};  // draws that change this pixel are noted; OpenGL's window coordinates
  std::array<unsigned, 2> window{};              // its size in pixels; needed by `split` and `pixel`

  bool watches_draws() const { return false_colors || counts_classes || split || marked || pixel; }
  bool operator==(const LiveView&) const = default;
};

}  // namespace glark::core
