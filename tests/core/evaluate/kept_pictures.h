// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "tests/core/support/kept_scene.h"

namespace glark::core::test {

// `draw` shows what it showed before its vertices were kept.
inline Picture expect_same_picture(const std::function<void()>& draw) {
  const Picture first = picture_of(draw);
  EXPECT_GT(differing_pixels(first, Picture(first.size(), 0)), visible_pixels);
  const GLuint triangles = generated_primitives;
  repeat_often(draw);
  Picture kept = picture_of(draw);
  EXPECT_EQ(differing_pixels(first, kept), 0);
  EXPECT_EQ(generated_primitives, triangles);
  EXPECT_EQ(pending_errors(), "");
  return kept;
}

}  // namespace glark::core::test
