// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Errors of DrawARP and DrawARPElementsARK, and of ordinary draws while ARK is enabled (10.R.2).
#include <fmt/core.h>
#include <functional>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/cases/draws/ring.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

void expect_nothing_drawn(Test& t, GLenum error, const std::string& what, const std::function<void()>& draw) {
  const GLboolean was_enabled = gl.IsEnabled(GL_ARK);
  gl.ClearColor(0, 0, 1, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  const Picture before = read_picture(surface_size, surface_size);
  draw();
  t.expect_error(error, what);
  t.expect_same_picture(read_picture(surface_size, surface_size), before, what + " draws nothing");
  t.expect_equal(gl.IsEnabled(GL_ARK), was_enabled, what + " leaves ARK as it was");
}

void set_up_errors(Test& t, bool has_pool) {
  gl.UseProgram(colour_program(t));
  upload(ring());
  bind_indices(GL_UNSIGNED_BYTE);
  if (has_pool) refine_by_tags(3);
}

void check_bad_modes(Test& t) {
  set_up_errors(t, true);
  std::vector<GLenum> bad = {GL_POINTS,
                             GL_LINES,
                             GL_LINE_LOOP,
                             GL_LINE_STRIP,
                             GL_LINES_ADJACENCY,
                             GL_LINE_STRIP_ADJACENCY,
                             GL_PATCHES,
                             GL_TRIANGLES_ADJACENCY,
                             0x1234,
                             GL_TRIANGLE_STRIP_ADJACENCY};
  if (!t.is_compat()) bad.insert(bad.end(), {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON});
  for (const GLenum mode : bad) {
    const std::string name = fmt::format("mode {}", mode);
    expect_nothing_drawn(t, GL_INVALID_ENUM, "DrawARP, " + name, [mode] { gl.DrawARP(mode, 0, 6); });
    expect_nothing_drawn(t, GL_INVALID_ENUM, "DrawARPElementsARK, " + name,
                         [mode] { gl.DrawARPElementsARK(mode, 6, GL_UNSIGNED_BYTE, nullptr); });
  }
}

void check_before_init(Test& t) {
  set_up_errors(t, false);
  gl.DepthTag1i(0);
  t.expect_no_error("set-up");
  expect_nothing_drawn(t, GL_INVALID_OPERATION, "DrawARP", [] { gl.DrawARP(GL_TRIANGLES, 0, 6); });
  expect_nothing_drawn(t, GL_INVALID_OPERATION, "DrawARPElementsARK",
                       [] { gl.DrawARPElementsARK(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, nullptr); });
}

void check_in_list(Test& t) {
  set_up_errors(t, true);
  const GLuint list = gl.GenLists(1);
  for (const GLenum how : {GL_COMPILE, GL_COMPILE_AND_EXECUTE}) {
    gl.NewList(list, how);
    expect_nothing_drawn(t, GL_INVALID_OPERATION, "DrawARP", [] { gl.DrawARP(GL_TRIANGLES, 0, 6); });
    expect_nothing_drawn(t, GL_INVALID_OPERATION, "DrawARPElementsARK",
                         [] { gl.DrawARPElementsARK(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, nullptr); });
    gl.EndList();
    expect_nothing_drawn(t, GL_NO_ERROR, "the list", [list] { gl.CallList(list); });
  }
}

void check_other_errors(Test& t) {
  set_up_errors(t, true);
  for (const bool is_enabled : {true, false}) {
    if (!is_enabled) gl.Disable(GL_ARK);
    expect_nothing_drawn(t, GL_INVALID_VALUE, "a negative count", [] { gl.DrawARP(GL_TRIANGLES, 0, -3); });
    expect_nothing_drawn(t, GL_INVALID_VALUE, "a negative first vertex", [] { gl.DrawARP(GL_TRIANGLES, -1, 3); });
    expect_nothing_drawn(t, GL_INVALID_VALUE, "a negative count of indices",
                         [] { gl.DrawARPElementsARK(GL_TRIANGLES, -1, GL_UNSIGNED_BYTE, nullptr); });
    expect_nothing_drawn(t, GL_INVALID_ENUM, "indices that are floats",
                         [] { gl.DrawARPElementsARK(GL_TRIANGLES, 6, GL_FLOAT, nullptr); });
    expect_nothing_drawn(t, GL_INVALID_ENUM, "signed indices",
                         [] { gl.DrawARPElementsARK(GL_TRIANGLES, 6, GL_SHORT, nullptr); });
  }
}

void check_framebuffer_error(Test& t) {
  set_up_errors(t, true);
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  GLuint texture = 0;  // without a size: incomplete
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  t.expect_no_error("set-up");
  gl.DrawARP(GL_TRIANGLES, 0, 6);
  t.expect_error(GL_INVALID_FRAMEBUFFER_OPERATION, "DrawARP to an incomplete framebuffer");
  gl.DrawARPElementsARK(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, nullptr);
  t.expect_error(GL_INVALID_FRAMEBUFFER_OPERATION, "DrawARPElementsARK to an incomplete framebuffer");
  gl.DrawArrays(GL_TRIANGLES, 0, 6);
  t.expect_error(GL_INVALID_FRAMEBUFFER_OPERATION, "DrawArrays to an incomplete framebuffer");
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

// Ordinary commands generate their errors while ARK is enabled too. Commands that draw nothing generate none.
void check_ordinary_errors(Test& t) {
  set_up_errors(t, true);
  const auto expect = [&](GLenum error, const std::string& what, const std::function<void()>& draw) {
    gl.Disable(GL_ARK);
    expect_nothing_drawn(t, error, what + " without refinement", draw);
    gl.Enable(GL_ARK);
    expect_nothing_drawn(t, error, what, draw);
  };
  expect(GL_INVALID_ENUM, "mode 0x1234", [] { gl.DrawArrays(0x1234, 0, 3); });
  expect(GL_INVALID_VALUE, "a negative count", [] { gl.DrawArrays(GL_TRIANGLES, 0, -1); });
  expect(GL_INVALID_VALUE, "a negative number of instances", [] { gl.DrawArraysInstanced(GL_TRIANGLES, 0, 3, -1); });
  expect(GL_INVALID_ENUM, "a type of indices", [] { gl.DrawElements(GL_TRIANGLES, 3, GL_FLOAT, nullptr); });
  expect(GL_INVALID_VALUE, "a range that ends before it begins",
         [] { gl.DrawRangeElements(GL_TRIANGLES, 5, 2, 3, GL_UNSIGNED_BYTE, nullptr); });
  expect(GL_NO_ERROR, "no vertices", [] { gl.DrawArrays(GL_TRIANGLES, 0, 0); });
  expect(GL_NO_ERROR, "too few vertices", [] { gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 2); });
  expect(GL_NO_ERROR, "no instances", [] { gl.DrawArraysInstanced(GL_TRIANGLES, 0, 3, 0); });
  expect(GL_NO_ERROR, "no indices", [] { gl.DrawElements(GL_TRIANGLES, 0, GL_UNSIGNED_BYTE, nullptr); });
}

Case error_case(const char* leaf, std::vector<std::string> clauses, const char* plan, void (*check)(Test&),
                Apis apis = every_api) {
  return {.name = std::string("ark.draw.errors.") + leaf,
          .clauses = std::move(clauses),
          .plan = plan,
          .wrong = "No error; another error; the command draws in spite of the error, or changes ARK.",
          .apis = apis,
          .check = check};
}

}  // namespace

Cases draw_arp_errors_cases() {
  return {
      error_case("modes", {"10.R.2-10"}, "Call DrawARP and DrawARPElementsARK with every mode that has no triangles.",
                 check_bad_modes),
      error_case("before_init", {"10.R.2-11"}, "Call both commands in a context without a pool.", check_before_init),
      error_case("in_list", {"10.R.2-11"}, "Call both commands while a display list is compiled.", check_in_list,
                 compat_only),
      error_case("arguments", {"10.R.2-12", "10.R.2-9"},
                 "Call both commands with arguments that DrawArrays and DrawElements reject.", check_other_errors),
      error_case("framebuffer", {"10.R.2-12", "10.R.2-13"}, "Draw to an incomplete framebuffer.",
                 check_framebuffer_error),
      error_case("ordinary", {"10.R.2-13"},
                 "Call ordinary commands that are rejected, or draw nothing, with and without ARK.",
                 check_ordinary_errors)};
}

}  // namespace glark::conformance
