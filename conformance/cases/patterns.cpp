// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What every pattern is (11.R.5), read back through transform feedback.
#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

void check_uniform_count(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(one_triangle());
  for (int level = 0; level <= 4; ++level) {
    refine_uniformly(static_cast<GLuint>(level));
    const auto vertices = capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
    t.expect_equal(vertices.size(), std::size_t{3} << (2 * level), "vertices at depth " + std::to_string(level));
  }
}

void check_unrefined_count(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(one_triangle(), false);
  t.expect_equal(capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }).size(), 3U, "vertices of the coarse triangle");
}

}  // namespace

Cases patterns_cases() {
  return {{.name = "ark.pattern.uniform.count",
           .clauses = {"11.R.5-11"},
           .plan = "Capture one triangle at uniform depths 0 to 4 and count.",
           .wrong = "2^d or 3^d triangles; a level too few.",
           .control = check_unrefined_count,
           .check = check_uniform_count}};
}

}  // namespace glark::conformance
