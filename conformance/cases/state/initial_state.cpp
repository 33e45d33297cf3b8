// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The initial value of every state of the extension ("New State"). The context is new, or shares objects with a context
// in use.
#include "conformance/cases/cases.h"
#include "conformance/support/program.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

struct Initial {
  GLenum name;
  double value;
  GLenum below = 0;  // the value of this limit is added to `value`
  std::vector<std::string> further = {};
};

const std::vector<Initial>& initial_values() {
  static const std::vector<Initial> all{
      {GL_ARK, 0, 0, {"11.R.1-13"}},
      {GL_POOL_LEVEL_ARK, -1, 0, {"11.R.1-4"}},
      {GL_CURRENT_DEPTH_TAG_ARK, 0, 0, {"10.R.1-14"}},
      {GL_DEPTH_TAG_ATTRIBUTE_ARK, -1, GL_MAX_VERTEX_ATTRIBS, {"11.R.2-7"}},
      {GL_REFINEMENT_ARK, GL_LINEAR_INPUTS_ARK, 0, {"11.R.2-4"}},
      {GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK, 0, {"11.R.2-5"}},
      {GL_UNIFORM_DEPTH_LEVEL_ARK, 0, 0, {"11.R.2-6"}},
      {GL_POLYGON_SPLIT_ARK, GL_POLYGON_TRIANGLES_ARK, 0, {"11.R.2-8"}},
      {GL_PATTERN_INTERIOR_ARK, GL_MINIMUM_INTERIOR_ARK, 0, {"11.R.2-9"}},
      {GL_EDGE_PIXELS_ARK, 8, 0, {"11.R.2-10"}},
      {GL_EDGE_DEGREES_ARK, 0, 0, {"11.R.2-11"}},
      {GL_SCREEN_ERROR_ARK, 0, 0, {"11.R.2-37"}},
      {GL_TRIANGLE_BUDGET_ARK, 0, 0, {"11.R.2-12"}},
      {GL_DISCONTINUITY_ATTRIBUTE_ARK, -2, GL_MAX_VERTEX_ATTRIBS, {"11.R.2-13"}},
      {GL_SCALAR_TAG_ATTRIBUTE_ARK, -3, GL_MAX_VERTEX_ATTRIBS, {"11.R.2-14"}},
      {GL_DISPLACEMENT_UNIT_ARK, -1, 0, {"11.R.2-15"}},
      {GL_DISPLACEMENT_CHANNEL_ARK, GL_RED, 0, {"11.R.2-16"}},
      {GL_DISPLACEMENT_COORDINATE_ARK, -1, 0, {"11.R.2-17"}},
      {GL_DISPLACEMENT_SCALE_ARK, 1, 0, {"11.R.2-18"}},
      {GL_DISPLACEMENT_BIAS_ARK, 0, 0, {"11.R.2-19"}},
      {GL_GEOMORPH_ARK, GL_FALSE, 0, {"11.R.2-20"}},
      {GL_WELD_ARK, GL_FALSE, 0, {"11.R.2-21"}},
      {GL_DEPTH_TAG_ARRAY_ARK, GL_FALSE},
      {GL_DEPTH_TAG_ARRAY_TYPE_ARK, GL_FLOAT},
      {GL_DEPTH_TAG_ARRAY_STRIDE_ARK, 0},
      {GL_DEPTH_TAG_ARRAY_BUFFER_BINDING_ARK, 0},
  };
  return all;
}

double expected_of(const Initial& initial) {
  return initial.value + (initial.below != 0 ? integer_of(initial.below) : 0);
}

const StateName& state_of(GLenum name) {
  for (const StateName& state : extension_state())
    if (state.name == name) return state;
  throw std::logic_error("no such state");
}

Case initial_case(const Initial& initial) {
  const StateName& state = state_of(initial.name);
  std::vector<std::string> clauses = initial.further;
  clauses.emplace_back(state.clause);
  return {.name = std::string("ark.state.defaults.") + state.leaf,
          .clauses = std::move(clauses),
          .plan = "Ask a new context by GetFloatv and by GetIntegerv.",
          .wrong = "0 for every state; only ARKinit sets an initial value.",
          .check = [initial](Test& t) {
            const double expected = expected_of(initial);
            t.expect_equal(double{number_of(initial.name)}, expected, "GetFloatv");
            t.expect_equal(double(integer_of(initial.name)), expected, "GetIntegerv");
            t.expect_no_error("the queries");
          }};
}

void check_pointer(Test& t) {
  t.expect(pointer_of(GL_DEPTH_TAG_ARRAY_POINTER_ARK) == nullptr, "the pointer is initially NULL");
  t.expect_no_error("GetPointerv");
}

void check_capabilities(Test& t) {
  t.expect_equal(int{gl.IsEnabled(GL_ARK)}, int{GL_FALSE}, "IsEnabled(ARK)");
  t.expect_equal(int{gl.IsEnabled(GL_DEPTH_TAG_ARRAY_ARK)}, int{GL_FALSE}, "IsEnabled(DEPTH_TAG_ARRAY_ARK)");
  t.expect_no_error("IsEnabled");
}

void check_init_sets_the_level_only(Test& t) {
  const Snapshot before = take_snapshot(t);
  gl.ARKinit(3);
  Snapshot after = take_snapshot(t);
  t.expect_equal(after.at("pool_level"), std::string("3"), "POOL_LEVEL_ARK");
  after["pool_level"] = before.at("pool_level");
  expect_unchanged(t, after, before, "the first ARKinit");
}

void check_program(Test& t) {
  const GLuint program = colour_program(t);
  for (const GLenum name : {GL_REFINEMENT_LOG_LENGTH_ARK, GL_REFINEMENT_SOURCE_LENGTH_ARK}) {
    GLint length = -7;
    gl.GetRefinementivARK(program, name, &length);
    t.expect_equal(length, 0, name == GL_REFINEMENT_LOG_LENGTH_ARK ? "length of the log" : "length of the source");
    if (!t.is_compat()) continue;
    length = -7;
    gl.GetRefinementivARK(0, name, &length);
    t.expect_equal(length, 0, "length for the fixed-function vertex stage");
  }
  t.expect_no_error("GetRefinementivARK");
}

void check_sharing_context(Test& t, bool is_shared) {
  set_everything(t);
  const Snapshot before = take_snapshot(t);
  {
    const std::unique_ptr<Context> second = t.create_context(is_shared ? &t.context() : nullptr);
    for (const Initial& initial : initial_values())
      t.expect_equal(double{number_of(initial.name)}, expected_of(initial), state_of(initial.name).leaf);
    check_pointer(t);
    gl.ARKinit(2);
    gl.DepthTag1i(1);
    gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_OUTPUTS_ARK);
    gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 99);
    gl.Disable(GL_ARK);
    t.expect_no_error("commands of the second context");
  }
  t.require(t.context().make_current(), "the first context can be made current again");
  expect_unchanged(t, take_snapshot(t), before, "after another context was used");
}

Case context_case(const char* leaf, bool is_shared) {
  return {.name = std::string("ark.state.context.") + leaf,
          .clauses = {"11.R.1-3", "11.R.1-4", "11.R.1-13"},
          .plan =
              "Set every state and make another context current: it has the initial values. Change them there: the "
              "first context still has its own.",
          .wrong = "State is global, or belongs to the share group: a pool level of 5 in the second context.",
          .check = [is_shared](Test& t) { check_sharing_context(t, is_shared); }};
}

}  // namespace

Cases initial_state_cases() {
  Cases cases{{.name = "ark.state.defaults.depth_tag_array_pointer",
               .clauses = {"state-27"},
               .plan = "Ask a new context by GetPointerv.",
               .check = check_pointer},
              {.name = "ark.state.defaults.capabilities",
               .clauses = {"state-1", "state-23"},
               .plan = "Ask a new context by IsEnabled.",
               .check = check_capabilities},
              {.name = "ark.state.defaults.after_init",
               .clauses = {"11.R.1-2", "11.R.1-8"},
               .plan = "Compare all state before and after the first ARKinit: only the pool level has changed.",
               .wrong = "ARKinit enables refinement, or sets the parameters.",
               .check = check_init_sets_the_level_only},
              {.name = "ark.state.defaults.program",
               .clauses = {"state-30", "state-31", "11.R.9-31"},
               .plan = "Ask for the lengths of refinement source and log of a new program, and of the fixed function.",
               .wrong = "1, for the terminator of an empty string.",
               .check = check_program},
              context_case("separate", false),
              context_case("shared", true)};
  for (const Initial& initial : initial_values()) cases.push_back(initial_case(initial));
  return cases;
}

}  // namespace glark::conformance
