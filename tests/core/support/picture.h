// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A picture, and the difference between two pictures.
#pragma once

#include <vector>

#include "tests/core/support/osmesa_context.h"

namespace glark::core::test {

using Picture = std::vector<GLubyte>;

inline Picture read_picture() {
  Picture picture(4 * picture_size * picture_size);
  glReadPixels(0, 0, picture_size, picture_size, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
  return picture;
}

// Counts the pixels in which a channel differs by more than 2 levels.
inline int differing_pixels(const Picture& a, const Picture& b) {
  int count = 0;
  for (std::size_t pixel = 0; pixel < a.size(); pixel += 4) {
    bool differs = false;
    for (std::size_t channel = 0; channel < 4; ++channel) {
      differs = differs || std::abs(a[pixel + channel] - b[pixel + channel]) > 2;
    }
    count += differs ? 1 : 0;
  }
  return count;
}

inline constexpr int tolerated_pixels = picture_size * picture_size / 200;  // 0.5 %
inline constexpr int visible_pixels = picture_size * picture_size / 64;     // 1.5 %: a test scene shows at least that

}  // namespace glark::core::test
