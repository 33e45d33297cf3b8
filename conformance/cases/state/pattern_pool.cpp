// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The pattern pool: ARKinit, and Enable and Disable of ARK (11.R.1).
#include <fmt/core.h>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

std::size_t triangles_drawn(Test& t) {
  return capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }).size() / 3;
}

void draws_one_triangle(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(one_triangle());
  t.expect_equal(triangles_drawn(t), 1U, "triangles of the coarse draw");
}

void check_levels(Test& t) {
  draws_one_triangle(t);
  const GLint most = integer_of(GL_MAX_DEPTH_ARK);
  t.expect(most >= 11, "MAX_DEPTH_ARK is at least 11");
  for (GLint level = 0; level <= most; ++level) {
    gl.ARKinit(static_cast<GLuint>(level));
    t.expect_no_error(fmt::format("ARKinit({})", level));
    t.expect_equal(integer_of(GL_POOL_LEVEL_ARK), level, "POOL_LEVEL_ARK");
    gl.DepthTag1i(static_cast<GLuint>(level));
    t.expect_no_error("DepthTag1i of the level");
    t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), level, "CURRENT_DEPTH_TAG_ARK");
  }
}

void check_finest(Test& t) {
  gl.UseProgram(capture_program(t));
  gl.ARKinit(static_cast<GLuint>(integer_of(GL_MAX_DEPTH_ARK)));
  gl.Enable(GL_ARK);
  upload(one_triangle({11, 11, 0}));
  constexpr std::size_t expected = 31 * 30 + 2048 + 32 + 32 - 2;  // with m = 5, 11.R.5
  t.expect_equal(triangles_drawn(t), expected, "triangles for the depths 11, 5 and 5");
}

void check_great_levels(Test& t) {
  const auto most = static_cast<GLuint>(integer_of(GL_MAX_DEPTH_ARK));
  for (const bool is_first : {true, false}) {
    for (const GLuint level : {most + 1, 100U, 0x7FFFFFFFU, 0x80000000U, 0xFFFFFFFFU})
      expect_refused(t, GL_INVALID_VALUE, std::string(is_first ? "first " : "") + "ARKinit(" + as_text(level) + ")",
                     [&] { gl.ARKinit(level); });
    if (is_first) set_everything(t);
  }
}

void check_draws_after_refusal(Test& t) {
  draws_one_triangle(t);
  refine_uniformly(2);
  t.expect_equal(triangles_drawn(t), 16U, "triangles at level 2");
  gl.ARKinit(0xFFFFFFFFU);
  t.expect_error(GL_INVALID_VALUE, "ARKinit of a great level");
  t.expect_equal(triangles_drawn(t), 16U, "triangles after it");
}

void check_replaced(Test& t) {
  draws_one_triangle(t);
  upload(one_triangle({7, 7, 7}));
  gl.ARKinit(2);
  gl.Enable(GL_ARK);
  for (const GLuint level : {2U, 4U, 1U, 0U, 3U}) {
    gl.ARKinit(level);
    t.expect_equal(triangles_drawn(t), std::size_t{1} << (2 * level), "triangles at level " + as_text(level));
    t.expect_equal(int{gl.IsEnabled(GL_ARK)}, int{GL_TRUE}, "refinement stays enabled");
  }
}

void expect_tag(Test& t, GLint tag, const std::string& what) {
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), tag, "CURRENT_DEPTH_TAG_ARK " + what);
}

void check_tag_lowered(Test& t) {
  gl.ARKinit(6);
  gl.DepthTag1i(5);
  gl.ARKinit(5);
  expect_tag(t, 5, "at the level");
  gl.ARKinit(3);
  expect_tag(t, 3, "above the level");
  const auto attribute = static_cast<GLuint>(integer_of(GL_DEPTH_TAG_ATTRIBUTE_ARK));
  t.expect_equal(current_value(attribute)[0], 3.0F, "the attribute's first component");
  gl.ARKinit(6);
  expect_tag(t, 3, "after the level was raised again");
  gl.ARKinit(0);
  gl.ARKinit(6);
  expect_tag(t, 0, "after a pool of level 0");
}

void check_attribute_lowered(Test& t) {
  gl.ARKinit(6);
  const auto attribute = static_cast<GLuint>(integer_of(GL_DEPTH_TAG_ATTRIBUTE_ARK));
  gl.VertexAttrib4f(attribute, 5, 6, 7, 8);
  gl.ARKinit(2);
  expect_tag(t, 2, "above the level");
  gl.ARKinit(6);
  expect_tag(t, 2, "the value that VertexAttrib set, after the level was raised again");
}

void check_attribute_kept(Test& t) {
  gl.ARKinit(6);
  const auto attribute = static_cast<GLuint>(integer_of(GL_DEPTH_TAG_ATTRIBUTE_ARK));
  gl.DepthTag1i(5);
  gl.VertexAttrib4f(attribute, 1.25F, 6, 7, 8);
  gl.ARKinit(2);
  expect_tag(t, 1, "a value below the level");
  t.expect(current_value(attribute) == std::vector<float>{1.25F, 6, 7, 8}, "the attribute is left alone");
  gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, 5);
  gl.DepthTag1i(2);
  gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, static_cast<GLint>(attribute));
  gl.ARKinit(1);
  expect_tag(t, 1, "of the attribute in use");
  t.expect_equal(current_value(5)[0], 2.0F, "the attribute that is not in use any more");
}

void check_level_lowered(Test& t) {
  gl.ARKinit(6);
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 5);
  for (const auto& [level, expected] : {std::pair{5U, 5}, {6U, 5}, {2U, 2}, {6U, 2}, {0U, 0}, {6U, 0}}) {
    gl.ARKinit(level);
    t.expect_equal(integer_of(GL_UNIFORM_DEPTH_LEVEL_ARK), expected,
                   "UNIFORM_DEPTH_LEVEL_ARK after ARKinit(" + as_text(level) + ")");
  }
}

void check_nothing_else(Test& t) {
  set_everything(t);
  Snapshot expected = take_snapshot(t);
  expected["pool_level"] = "9";
  gl.ARKinit(9);
  expect_unchanged(t, take_snapshot(t), expected, "ARKinit of a higher level");
  gl.ARKinit(2);
  expected["pool_level"] = "2";
  expected["current_depth_tag"] = "2";
  expected["attribute 7 value"] = "2 0 0 1 ";
  expected["uniform_depth_level"] = "2";
  expect_unchanged(t, take_snapshot(t), expected, "ARKinit of a lower level");
}

void check_enable_first(Test& t) {
  expect_refused(t, GL_INVALID_OPERATION, "Enable(ARK) before ARKinit", [] { gl.Enable(GL_ARK); });
  gl.Disable(GL_ARK);
  t.expect_no_error("Disable(ARK) before ARKinit");
  gl.ARKinit(0xFFFFU);
  t.expect_error(GL_INVALID_VALUE, "ARKinit that fails");
  expect_refused(t, GL_INVALID_OPERATION, "Enable(ARK) after an ARKinit that failed", [] { gl.Enable(GL_ARK); });
  gl.ARKinit(0);
  gl.Enable(GL_ARK);
  t.expect_no_error("Enable(ARK) with a pool of level 0");
  t.expect_equal(int{gl.IsEnabled(GL_ARK)}, int{GL_TRUE}, "IsEnabled(ARK)");
}

void check_enable_draws(Test& t) {
  draws_one_triangle(t);
  gl.ARKinit(3);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 3);
  t.expect_equal(triangles_drawn(t), 1U, "triangles before Enable(ARK)");
  gl.Enable(GL_ARK);
  t.expect_equal(triangles_drawn(t), 64U, "triangles after Enable(ARK)");
  gl.Disable(GL_ARK);
  t.expect_equal(triangles_drawn(t), 1U, "triangles after Disable(ARK)");
}

}  // namespace

Cases pattern_pool_cases() {
  return {
      {.name = "ark.pool.levels",
       .clauses = {"11.R.1-1", "11.R.1-2", "11.R.1-9", "functions-1", "limits-1", "tokens-4", "tokens-5"},
       .plan = "Call ARKinit with every level from 0 to MAX_DEPTH_ARK. The depth tag may be as large as the level.",
       .wrong = "MAX_DEPTH_ARK itself is refused; a level of 0 is refused.",
       .check = check_levels},
      {.name = "ark.pool.finest",
       .clauses = {"11.R.1-2", "limits-1"},
       .plan = "With a pool of level MAX_DEPTH_ARK, draw a triangle with the tags 11, 11 and 0, and count.",
       .wrong = "An edge of depth 11 has fewer segments.",
       .control = draws_one_triangle,
       .check = check_finest},
      {.name = "ark.pool.too_great",
       .clauses = {"11.R.1-9", "errors-3"},
       .plan = "Pass levels above MAX_DEPTH_ARK before and after a successful ARKinit: INVALID_VALUE, and no state "
               "changes.",
       .wrong = "Clamped; a signed comparison accepts 0x80000000; POOL_LEVEL_ARK is -1 again.",
       .check = check_great_levels},
      {.name = "ark.pool.kept_after_error",
       .clauses = {"11.R.1-9", "errors-2"},
       .plan = "Draw before and after an ARKinit that fails: the number of triangles is the same.",
       .wrong = "The pool is gone: only the coarse triangle.",
       .control = draws_one_triangle,
       .check = check_draws_after_refusal},
      {.name = "ark.pool.replaced",
       .clauses = {"11.R.1-5"},
       .plan = "With tags above all levels draw with pools of level 2, 4, 1, 0 and 3.",
       .wrong = "The first pool stays, or only grows; ARKinit disables refinement.",
       .control = draws_one_triangle,
       .check = check_replaced},
      {.name = "ark.pool.lowers_tag",
       .clauses = {"11.R.1-6"},
       .plan = "Lower the level below the current depth tag and raise it again: ARKinit has set the tag.",
       .wrong = "The tag is only clamped when it is read, and comes back; it becomes 0.",
       .check = check_tag_lowered},
      {.name = "ark.pool.lowers_attribute",
       .clauses = {"11.R.1-6", "10.R.1-16"},
       .plan = "The same with a tag that VertexAttrib4f set.",
       .wrong = "Only a tag that DepthTag1i set counts.",
       .check = check_attribute_lowered},
      {.name = "ark.pool.keeps_attribute",
       .clauses = {"11.R.1-6", "11.R.1-8"},
       .plan = "DepthTag1i sets a large tag, VertexAttrib4f a small one; then the same with another attribute's value.",
       .wrong = "The last tag of DepthTag1i is compared with the level instead of the current one.",
       .check = check_attribute_kept},
      {.name = "ark.pool.lowers_uniform_level",
       .clauses = {"11.R.1-7"},
       .plan = "Lower the level below UNIFORM_DEPTH_LEVEL_ARK and raise it again.",
       .wrong = "Clamped only when it is read; 0; raised with the level.",
       .check = check_level_lowered},
      {.name = "ark.pool.changes_nothing_else",
       .clauses = {"11.R.1-8"},
       .plan = "Set every state, call ARKinit with a higher and a lower level, and compare all state.",
       .wrong = "Parameters are reset; refinement or the array is disabled.",
       .check = check_nothing_else},
      {.name = "ark.pool.enable_first",
       .clauses = {"11.R.1-14", "errors-2", "errors-5"},
       .plan = "Call Enable(ARK) before ARKinit, and after an ARKinit that failed.",
       .wrong = "Enabled without a pool; Disable generates an error too.",
       .check = check_enable_first},
      {.name = "ark.pool.enable",
       .clauses = {"11.R.1-12", "11.R.1-13"},
       .plan = "Count triangles before Enable(ARK), after it and after Disable(ARK).",
       .wrong = "Refined as soon as ARKinit is called.",
       .control = draws_one_triangle,
       .check = check_enable_draws},
  };
}

}  // namespace glark::conformance
