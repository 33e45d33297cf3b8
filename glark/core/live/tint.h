// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Tints a draw: its colours are multiplied by a constant, with the blending of OpenGL. No shader changes. A draw that
// blends already keeps its blending and changes some channels only.
#pragma once

#include <array>

#include "glark/core/live/draw_groups.h"
#include "glark/core/state/environment.h"

namespace glark::core {

// Sets the blending or the colour mask of draw buffer 0 during its lifetime. Not between glBegin and glEnd.
class Tint {
 public:
  Tint(const Environment& environment, const DrawGroupText& group);
  ~Tint();
  Tint(const Tint&) = delete;
  Tint& operator=(const Tint&) = delete;

 private:
  void set_blending(const std::array<float, 3>& color);
  void reset_blending() const;
  void set_mask(const std::array<bool, 3>& channels);

  const Environment& env_;
  bool blends_ = false;  // the draw blends
  std::array<GLboolean, 4> mask_{};
  std::array<GLfloat, 4> constant_{};
  std::array<GLint, 4> factors_{};  // source and destination of colour, then of alpha
  std::array<GLint, 2> equations_{};
};

}  // namespace glark::core
