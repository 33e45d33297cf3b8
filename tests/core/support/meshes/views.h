// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Views of closed meshes about the origin from all directions, and pixels that show a hole.
#pragma once

#include "tests/core/support/measured_program.h"
#include "tests/core/support/meshes/split_meshes.h"
#include "tests/core/support/picture.h"

namespace glark::core::test {

inline Matrix view_along(const Vector& direction) {
  const Vector back = unit(direction);
  const Vector side = unit(cross(std::abs(back[1]) < 0.9F ? Vector{0, 1, 0} : Vector{1, 0, 0}, back));
  const Vector up = cross(back, side);
  Matrix view{};
  for (std::size_t i = 0; i < 3; ++i) {
    view[4 * i] = 0.47F * side[i];
    view[4 * i + 1] = 0.47F * up[i];
    view[4 * i + 2] = -0.2F * back[i];
    view[4 * i + 3] = -0.1F * back[i];  // somewhat in perspective
  }
  view[15] = 1;
  return view;
}

inline std::vector<Vector> directions() {
  std::vector<Vector> result;
  for (int i = 0; i < 27; ++i) {
    if (i != 13) {
      const int digits[] = {i % 3, i / 3 % 3, i / 9};
      result.push_back({static_cast<GLfloat>(digits[0]) - 0.97F, static_cast<GLfloat>(digits[1]) - 1.02F,
                        static_cast<GLfloat>(digits[2]) - 0.99F});
    }
  }
  return result;
}

// Counts pixels that show a hole. Red counts front faces, green back faces: a closed mesh has as many of both in every
// pixel.
inline int open_pixels(const Picture& picture) {
  int open = 0;
  int covered = 0;
  for (std::size_t i = 0; i + 3 < picture.size(); i += 4) {
    open += picture[i] != picture[i + 1] ? 1 : 0;
    covered += picture[i] != 0 ? 1 : 0;
  }
  EXPECT_GT(covered, 200) << "the scene shows nothing";
  return open;
}

}  // namespace glark::core::test
