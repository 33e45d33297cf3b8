// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A refined draw against the unrefined draw of the same GL: its picture, its triangles and its error.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"

namespace glark::conformance {

// The leaf of a case from the name of a command, which names of cases write in small letters.
inline std::string leaf_of_command(std::string_view command) {
  std::string leaf(command);
  for (char& each : leaf) each = each >= 'A' && each <= 'Z' ? static_cast<char>(each - 'A' + 'a') : each;
  return leaf;
}

// What a draw gives without refinement.
struct PlainDraw {
  Picture picture;
  GLuint triangles = 0;  // all primitives that it generates
  GLenum error = GL_NO_ERROR;
};

// ARK is enabled before and after it.
inline PlainDraw plain_draw(const std::function<void()>& draw) {
  PlainDraw plain;
  gl.Disable(GL_ARK);
  plain.picture = picture_of(draw);
  plain.error = gl.GetError();
  plain.triangles = count_generated(draw);
  while (gl.GetError() != GL_NO_ERROR) {
  }
  gl.Enable(GL_ARK);
  return plain;
}

// How a draw is refined, and how often it is drawn.
struct AsPlain {
  GLuint level = 2;   // its triangles are those of the unrefined draw 4^level times
  GLuint coarse = 0;  // triangles; 0: the primitives of the unrefined draw. Mesa 22 counts a quad or a polygon as one
  GLuint left = 0;    // of the unrefined primitives, those that are not refined
  bool is_often = false;   // draws it often between two looks
  bool has_pixels = true;  // something must be seen without refinement
};

inline void expect_as_plain(Test& t, const PlainDraw& plain, const std::function<void()>& draw, const std::string& what,
                            const AsPlain& how = {}) {
  if (how.has_pixels)
    t.expect(count_different(plain.picture, Picture(surface_size, surface_size), 0) > 40, what + ": seen unrefined");
  const GLuint coarse = how.coarse != 0 ? how.coarse : plain.triangles - how.left;
  const GLuint triangles = how.left + (coarse << (2 * how.level));
  for (int again = 0; again < 2; ++again) {
    const std::string turn = what + (again == 0 ? "" : ", again");
    t.expect_same_picture(picture_of(draw), plain.picture, turn, 4, 40);
    t.expect_error(plain.error, turn);
    t.expect_equal(count_generated(draw), triangles, turn + ": triangles");
    while (gl.GetError() != GL_NO_ERROR) {
    }
    if (how.is_often && again == 0) repeat_often(draw);
    while (gl.GetError() != GL_NO_ERROR) {
    }
  }
}

}  // namespace glark::conformance
