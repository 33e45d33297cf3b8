// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench/same_picture.h"

#include <stdexcept>

#include "tests/bench/gl.h"

namespace glark::bench {

Picture picture_of(const Competitor& competitor) {
  competitor.prepare();
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  competitor.draw();
  return read_picture();
}

void expect_same(const std::string& name, const Competitor& refined, const Competitor& other) {
  const Picture expected = picture_of(other);
  // The second picture of a refined draw fills the cache, which provides the third one.
  for (int i = 0; i < 3; ++i) {
    const std::string wrong = difference(picture_of(refined), expected);
    if (!wrong.empty()) throw std::runtime_error(name + ": " + wrong);
  }
}

}  // namespace glark::bench
