// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench/offscreen.h"

#include <algorithm>
#include <cstdlib>

#include "tests/bench/gl.h"

namespace glark::bench {

void Offscreen::set_state() {
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glClearColor(0, 0, 0, 1);
}

Picture read_picture() {
  Picture picture(static_cast<std::size_t>(4) * picture_size * picture_size);
  glFinish();
  glReadPixels(0, 0, picture_size, picture_size, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
  return picture;
}

std::string difference(const Picture& a, const Picture& b) {
  constexpr int small_step = 12;
  int shown = 0;
  int different = 0;
  for (std::size_t i = 0; i < a.size(); i += 4) {
    int step = 0;
    bool lit = false;
    for (std::size_t k = i; k < i + 3; ++k) {
      step = std::max(step, std::abs(a[k] - b[k]));
      lit = lit || a[k] != 0 || b[k] != 0;
    }
    shown += lit ? 1 : 0;
    different += step > small_step ? 1 : 0;
  }
  if (shown < picture_size * picture_size / 100) return "the picture is empty";
  if (different * 50 > shown) return std::to_string(different) + " of " + std::to_string(shown) + " pixels differ";
  return {};
}

}  // namespace glark::bench
