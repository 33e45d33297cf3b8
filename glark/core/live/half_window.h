// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Restricts draws to the left or the right half of the window by the scissor test, within the application's own scissor.
#pragma once

#include <array>

#include "glark/core/state/environment.h"

namespace glark::core {

// The left or the right half of a scissor box, cut at the column `middle`: x, y, width, height in pixels.
using Box = std::array<GLint, 4>;
Box left_of(const Box& box, GLint middle);
Box right_of(const Box& box, GLint middle);

class HalfWindow {
 public:
  // Takes the application's scissor. `on`: whether the draw is split at all.
  HalfWindow(const Environment& environment, bool on);
  ~HalfWindow();
  HalfWindow(const HalfWindow&) = delete;
  HalfWindow& operator=(const HalfWindow&) = delete;

  // Draws to the window, or to a framebuffer of its size, are split. Others are the same for both halves: shadow maps.
  static bool splits(const Environment& environment);
  bool on() const { return on_; }
  void select_left() const { select(left_of(limits_, middle_)); }
  void select_right() const { select(right_of(limits_, middle_)); }

 private:
  void select(const Box& box) const;

  const Environment& env_;
  bool on_;
  bool enabled_ = false;  // the application's scissor test
  GLint middle_ = 0;
  Box scissor_{};  // the application's
  Box limits_{};   // what it lets through
};

}  // namespace glark::core
