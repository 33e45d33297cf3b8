// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Compares a refined draw, which repeats often, with the same draw unrefined: before a change and after it. Linear
// refinement is invisible, and so is a curved one of flat triangles.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/capture.h"

namespace glark::conformance {

using Draw = std::function<void()>;

// Compares several refined draws with the unrefined one. Returns the unrefined picture.
inline Picture expect_as_unrefined(Test& t, const Draw& draw, const std::string& what) {
  std::vector<Picture> refined;
  refined.push_back(picture_of(draw));
  repeat_often(draw);
  for (int again = 1; again < 4; ++again) refined.push_back(picture_of(draw));
  gl.Disable(GL_ARK);
  Picture plain = picture_of(draw);
  gl.Enable(GL_ARK);
  // After Enable, an implementation may read its state from GL in the next draw. Draw here, so that it has to notice
  // the caller's change by itself.
  for (int again = 0; again < 2; ++again) draw();
  t.expect(count_different(plain, Picture(surface_size, surface_size), 8) > 300, "something is drawn, " + what);
  for (const Picture& picture : refined) t.expect_same_picture(picture, plain, what, 4, 80);
  return plain;
}

// At least `least` pixels have to show the change.
inline void expect_change(Test& t, const Draw& draw, const Draw& change, const std::string& what, int least = 300) {
  const Picture before = expect_as_unrefined(t, draw, "before " + what);
  change();
  const Picture after = expect_as_unrefined(t, draw, "after " + what);
  t.expect(count_different(before, after, 8) > least, what + " shows");
  t.expect_no_error(what);
}

}  // namespace glark::conformance
