// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Table 11.R: the values that every parameter accepts, at both ends of its range, and the values that it refuses
// (11.R.2).
#include <fmt/core.h>
#include <algorithm>
#include <limits>

#include "conformance/cases/cases.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

constexpr GLint lowest = std::numeric_limits<GLint>::min();
constexpr GLint greatest = std::numeric_limits<GLint>::max();

using Values = std::vector<GLint>;

struct Parameter {
  const char* leaf;  // of support/state.h
  GLenum name;
  const char* clause;
  std::vector<std::string> error_clauses;
  GLenum error;
  std::function<Values(Test&)> accepted;
  std::function<Values(Test&)> refused;
};

std::function<Values(Test&)> these(Values values) {
  return [values = std::move(values)](Test&) { return values; };
}

Values indices(Test& t) {
  const GLint last = integer_of(GL_MAX_VERTEX_ATTRIBS) - 1;
  return t.is_compat() ? Values{1, last, 2} : Values{0, last, 1};
}

Values no_indices(Test& t) {
  const GLint last = integer_of(GL_MAX_VERTEX_ATTRIBS) - 1;
  Values values{-1, last + 1, lowest, greatest};
  if (t.is_compat()) values.push_back(0);
  return values;
}

Values coordinates(Test& t) {
  Values values = indices(t);
  values.push_back(-1);
  return values;
}

Values no_coordinates(Test& t) {
  Values values = no_indices(t);
  values[0] = -2;
  return values;
}

// Adds the tokens of all other parameters to the refused values.
Values no_tokens(const Values& own) {
  Values values{0, 1, -1, greatest};
  for (GLint token = 0x6F11; token <= 0x6F1E; ++token)
    if (std::find(own.begin(), own.end(), token) == own.end()) values.push_back(token);
  for (const GLint token : {GL_MEASURED_DEPTH_ARK, GL_SCALAR_TAGGED_PN_ARK, GL_RED, GL_TRUE, GL_TRIANGLES})
    if (std::find(own.begin(), own.end(), token) == own.end()) values.push_back(token);
  return values;
}

Parameter choice(const char* leaf, GLenum name, const char* clause, const Values& tokens) {
  return {leaf, name, clause, {"11.R.2-22", "errors-7"}, GL_INVALID_ENUM, these(tokens), these(no_tokens(tokens))};
}

std::vector<Parameter> choices() {
  std::vector<Parameter> all{
      choice("refinement", GL_REFINEMENT_ARK, "11.R.2-4",
             {GL_LINEAR_OUTPUTS_ARK, GL_CURVED_PN_ARK, GL_SCALAR_TAGGED_PN_ARK, GL_LINEAR_INPUTS_ARK}),
      choice("depth_source", GL_DEPTH_SOURCE_ARK, "11.R.2-5",
             {GL_UNIFORM_DEPTH_ARK, GL_MEASURED_DEPTH_ARK, GL_DEPTH_TAG_ARK}),
      choice("polygon_split", GL_POLYGON_SPLIT_ARK, "11.R.2-8", {GL_POLYGON_CENTROID_ARK, GL_POLYGON_TRIANGLES_ARK}),
      choice("pattern_interior", GL_PATTERN_INTERIOR_ARK, "11.R.2-9",
             {GL_SMOOTH_INTERIOR_ARK, GL_MINIMUM_INTERIOR_ARK}),
      choice("displacement_channel", GL_DISPLACEMENT_CHANNEL_ARK, "11.R.2-16", {GL_ALPHA, GL_BLUE, GL_GREEN, GL_RED}),
  };
  all.back().refused = these({0, 1, GL_RED - 1, GL_ALPHA + 1, GL_LUMINANCE, GL_RGB, GL_RGBA, -1, greatest});
  return all;
}

std::vector<Parameter> parameters() {
  std::vector<Parameter> all = choices();
  const std::vector<std::string> range{"11.R.2-25", "errors-24"};
  const std::vector<std::string> index{"11.R.2-26", "errors-24"};
  all.insert(
      all.end(),
      {{"uniform_depth_level",
        GL_UNIFORM_DEPTH_LEVEL_ARK,
        "11.R.2-6",
        {"11.R.2-23", "errors-24"},
        GL_INVALID_VALUE,
        these({5, 0, 3}),
        these({6, -1, 11, lowest, greatest})},
       {"depth_tag_attribute",
        GL_DEPTH_TAG_ATTRIBUTE_ARK,
        "11.R.2-7",
        {"11.R.2-24", "errors-24"},
        GL_INVALID_VALUE,
        indices,
        no_indices},
       {"edge_pixels", GL_EDGE_PIXELS_ARK, "11.R.2-10", range, GL_INVALID_VALUE, these({0, 1, 16777217, greatest}),
        these({-1, lowest})},
       {"edge_degrees", GL_EDGE_DEGREES_ARK, "11.R.2-11", range, GL_INVALID_VALUE, these({180, 1, 0}),
        these({-1, 181, lowest, greatest})},
       {"triangle_budget", GL_TRIANGLE_BUDGET_ARK, "11.R.2-12", range, GL_INVALID_VALUE, these({1, 0, greatest}),
        these({-1, lowest})},
       {"discontinuity_attribute", GL_DISCONTINUITY_ATTRIBUTE_ARK, "11.R.2-13", index, GL_INVALID_VALUE, indices,
        no_indices},
       {"scalar_tag_attribute", GL_SCALAR_TAG_ATTRIBUTE_ARK, "11.R.2-14", index, GL_INVALID_VALUE, indices, no_indices},
       {"displacement_unit", GL_DISPLACEMENT_UNIT_ARK, "11.R.2-15", index, GL_INVALID_VALUE,
        [](Test&) {
          return Values{0, integer_of(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS) - 1, -1};
        },
        [](Test&) {
          return Values{-2, integer_of(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS), GL_TEXTURE0, lowest, greatest};
        }},
       {"displacement_coordinate", GL_DISPLACEMENT_COORDINATE_ARK, "11.R.2-17", index, GL_INVALID_VALUE, coordinates,
        no_coordinates},
       {"displacement_scale",
        GL_DISPLACEMENT_SCALE_ARK,
        "11.R.2-18",
        {},
        GL_NO_ERROR,
        these({0, -1, 65536, 7}),
        these({})},
       {"displacement_bias",
        GL_DISPLACEMENT_BIAS_ARK,
        "11.R.2-19",
        {},
        GL_NO_ERROR,
        these({3, -8388607, 0}),
        these({})},
       {"geomorph",
        GL_GEOMORPH_ARK,
        "11.R.2-20",
        {"11.R.2-34", "errors-24"},
        GL_INVALID_VALUE,
        these({GL_TRUE, GL_FALSE}),
        these({2, -1, greatest})},
       {"weld",
        GL_WELD_ARK,
        "11.R.2-21",
        {"11.R.2-34", "errors-24"},
        GL_INVALID_VALUE,
        these({GL_TRUE, GL_FALSE}),
        these({2, -1, greatest})}});
  return all;
}

// Other state that depends on the parameter may change with it.
void forget(Snapshot& snapshot, const Parameter& parameter) {
  snapshot.erase(parameter.leaf);
  if (parameter.name != GL_DEPTH_TAG_ATTRIBUTE_ARK) return;
  for (const char* name :
       {"current_depth_tag", "depth_tag_array", "depth_tag_array_type", "depth_tag_array_stride",
        "depth_tag_array_buffer_binding", "depth_tag_array_pointer", "IsEnabled(DEPTH_TAG_ARRAY_ARK)"})
    snapshot.erase(name);
}

Case accepts(const Parameter& parameter) {
  return {.name = std::string("ark.parameter.") + parameter.leaf + ".accepts",
          .clauses = {"11.R.2-2", "11.R.2-3", parameter.clause},
          .plan =
              "Set every state. Then set the parameter to each value or to both ends of its range, and read it back: "
              "nothing else changes.",
          .wrong = "The last value is refused; another parameter is set.",
          .check = [parameter](Test& t) {
            set_everything(t);
            Snapshot before = take_snapshot(t);
            forget(before, parameter);
            for (const GLint value : parameter.accepted(t)) {
              gl.ARKParameteriARK(parameter.name, value);
              t.expect_no_error(fmt::format("setting to {}", value));
              t.expect_equal(integer_of(parameter.name), value, "the parameter");
            }
            expect_unchanged(t, take_snapshot(t), before, "other state");
          }};
}

Case refuses(const Parameter& parameter) {
  return {.name = std::string("ark.parameter.") + parameter.leaf + ".refuses",
          .clauses = parameter.error_clauses,
          .plan = "Set every state. Then give the parameter values that it does not accept.",
          .wrong = "No error; another error; clamped to the range; the initial value is set.",
          .check = [parameter](Test& t) {
            set_everything(t);
            for (const GLint value : parameter.refused(t))
              expect_refused(t, parameter.error, fmt::format("value {}", value),
                             [&] { gl.ARKParameteriARK(parameter.name, value); });
          }};
}

Case before_init(const Parameter& parameter) {
  return {
      .name = std::string("ark.parameter.") + parameter.leaf + ".before_init",
      .clauses = {"11.R.2-33", "11.R.1-8"},
      .plan = "Set the parameter before the first ARKinit and read it back. Call ARKinit twice and read it back again.",
      .wrong = "INVALID_OPERATION; ARKinit resets the parameters.",
      .check = [parameter](Test& t) {
        const bool is_level = parameter.name == GL_UNIFORM_DEPTH_LEVEL_ARK;
        const Values values = is_level ? Values{0} : parameter.accepted(t);
        for (const GLint value : values) {
          gl.ARKParameteriARK(parameter.name, value);
          t.expect_no_error(fmt::format("setting to {}", value));
          t.expect_equal(integer_of(parameter.name), value, "before ARKinit");
        }
        gl.ARKParameteriARK(parameter.name, values.front());
        for (const GLuint level : {3U, 1U}) {
          gl.ARKinit(level);
          t.expect_equal(integer_of(parameter.name), values.front(), "after ARKinit");
        }
      }};
}

void check_level_before_init(Test& t) {
  for (const GLint value : {1, -1, 11, greatest})
    expect_refused(t, GL_INVALID_VALUE, fmt::format("level {} before ARKinit", value),
                   [&] { gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, value); });
  gl.ARKinit(0);
  expect_refused(t, GL_INVALID_VALUE, "level 1 of a pool of level 0",
                 [] { gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 1); });
  const GLint most = integer_of(GL_MAX_DEPTH_ARK);
  gl.ARKinit(static_cast<GLuint>(most));
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, most);
  t.expect_no_error("MAX_DEPTH_ARK of a pool of that level");
  t.expect_equal(integer_of(GL_UNIFORM_DEPTH_LEVEL_ARK), most, "the level");
}

void check_unknown_names(Test& t) {
  set_everything(t);
  for (const GLint name : {GL_ARK, GL_MAX_DEPTH_ARK, GL_POOL_LEVEL_ARK, GL_CURRENT_DEPTH_TAG_ARK,
                           GL_DEPTH_TAG_ARRAY_ARK, GL_DEPTH_TAG_ARRAY_TYPE_ARK, GL_DEPTH_TAG_ARRAY_STRIDE_ARK,
                           GL_DEPTH_TAG_ARRAY_POINTER_ARK, GL_DEPTH_TAG_ARRAY_BUFFER_BINDING_ARK, GL_LINEAR_INPUTS_ARK,
                           GL_UNIFORM_DEPTH_ARK, GL_REFINEMENT_STATUS_ARK, 0, 0x6F0A, 0x6F3F, GL_TEXTURE_2D})
    expect_refused(t, GL_INVALID_ENUM, fmt::format("ARKParameteriARK of {}", name),
                   [&] { gl.ARKParameteriARK(static_cast<GLenum>(name), 1); });
}

void check_float_names(Test& t) {
  set_everything(t);
  for (const Parameter& parameter : parameters()) {
    if (parameter.error == GL_NO_ERROR) continue;  // the two numbers
    const auto value = static_cast<GLfloat>(parameter.accepted(t).front());
    expect_refused(t, GL_INVALID_ENUM, std::string("ARKParameterfARK of ") + parameter.leaf,
                   [&] { gl.ARKParameterfARK(parameter.name, value); });
  }
  for (const GLenum name : {GL_ARK, GL_POOL_LEVEL_ARK, 0, 0x6F3F})
    expect_refused(t, GL_INVALID_ENUM, "ARKParameterfARK of another name",
                   [&] { gl.ARKParameterfARK(static_cast<GLenum>(name), 1.0F); });
}

void check_float_values(Test& t) {
  set_everything(t);
  using Limits = std::numeric_limits<GLfloat>;
  for (const GLenum name : {GL_DISPLACEMENT_SCALE_ARK, GL_DISPLACEMENT_BIAS_ARK}) {
    for (const GLfloat value : {0.0F, -1.5F, Limits::max(), Limits::lowest(), Limits::min(), 0.1F}) {
      gl.ARKParameterfARK(name, value);
      t.expect_no_error("a finite value");
      t.expect_equal(number_of(name), value, "the parameter");
    }
    for (const GLfloat value : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(), -Limits::quiet_NaN()})
      expect_refused(t, GL_INVALID_VALUE, "infinite or not a number", [&] { gl.ARKParameterfARK(name, value); });
  }
  t.expect_equal(number_of(GL_DISPLACEMENT_SCALE_ARK), 0.1F, "the scale after the bias is set");
}

}  // namespace

Cases parameters_cases() {
  Cases cases{
      {.name = "ark.parameter.uniform_depth_level.pool",
       .clauses = {"11.R.2-23", "11.R.2-6"},
       .plan = "Before ARKinit only 0 is accepted; afterwards the level of the pool is the limit.",
       .wrong = "MAX_DEPTH_ARK is the limit; -1, the level without a pool, makes 0 an error.",
       .check = check_level_before_init},
      {.name = "ark.parameter.unknown",
       .clauses = {"11.R.2-22", "errors-7", "11.R.2-1", "functions-2"},
       .plan = "Names that are not parameters: read-only state, values, numbers between the tokens.",
       .wrong = "No error for a name that GetIntegerv knows.",
       .check = check_unknown_names},
      {.name = "ark.parameter.number.unknown",
       .clauses = {"11.R.2-30", "errors-25", "11.R.2-27", "functions-3"},
       .plan = "Give ARKParameterfARK every parameter that is not a floating-point number.",
       .wrong = "ARKParameterfARK passes on to ARKParameteriARK.",
       .check = check_float_names},
      {.name = "ark.parameter.number.values",
       .clauses = {"11.R.2-38", "11.R.2-31", "errors-25"},
       .plan = "Set both numbers to fractions and the ends of the range; infinities and NaN are refused.",
       .wrong = "Infinity is accepted, because comparisons with limits accept it; scale and bias are exchanged.",
       .check = check_float_values}};
  for (const Parameter& parameter : parameters()) {
    cases.push_back(accepts(parameter));
    if (parameter.error != GL_NO_ERROR)
      cases.push_back(refuses(parameter));
    else
      cases.back().clauses.emplace_back("11.R.2-29");
    cases.push_back(before_init(parameter));
  }
  return cases;
}

}  // namespace glark::conformance
