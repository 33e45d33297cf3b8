// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Answers of GL queries for the extension's state ("New Tokens", chapter 22) and for the values of its tokens.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "conformance/cases/cases.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

// The values that set_everything() of support/state.cpp sets.
double value_set(GLenum name, const EverythingSet& objects) {
  switch (name) {
    case GL_MAX_DEPTH_ARK: return integer_of(GL_MAX_DEPTH_ARK);
    case GL_POOL_LEVEL_ARK: return 5;
    case GL_CURRENT_DEPTH_TAG_ARK: return 3;
    case GL_DEPTH_TAG_ATTRIBUTE_ARK: return 7;
    case GL_REFINEMENT_ARK: return GL_CURVED_PN_ARK;
    case GL_DEPTH_SOURCE_ARK: return GL_UNIFORM_DEPTH_ARK;
    case GL_UNIFORM_DEPTH_LEVEL_ARK: return 4;
    case GL_POLYGON_SPLIT_ARK: return GL_POLYGON_CENTROID_ARK;
    case GL_PATTERN_INTERIOR_ARK: return GL_SMOOTH_INTERIOR_ARK;
    case GL_EDGE_PIXELS_ARK: return 12;
    case GL_EDGE_DEGREES_ARK: return 30;
    case GL_TRIANGLE_BUDGET_ARK: return 1000;
    case GL_DISCONTINUITY_ATTRIBUTE_ARK: return 6;
    case GL_SCALAR_TAG_ATTRIBUTE_ARK: return 5;
    case GL_DISPLACEMENT_UNIT_ARK: return 2;
    case GL_DISPLACEMENT_CHANNEL_ARK: return GL_BLUE;
    case GL_DISPLACEMENT_COORDINATE_ARK: return 4;
    case GL_DISPLACEMENT_SCALE_ARK: return 2.625;
    case GL_DISPLACEMENT_BIAS_ARK: return -0.75;
    case GL_PHONG_SHAPE_ARK: return 0.25;
    case GL_SCREEN_ERROR_ARK: return 1.625;
    case GL_DEPTH_TAG_ARRAY_TYPE_ARK: return GL_UNSIGNED_SHORT;
    case GL_DEPTH_TAG_ARRAY_STRIDE_ARK: return 6;
    case GL_DEPTH_TAG_ARRAY_BUFFER_BINDING_ARK: return objects.buffer;
    default: return GL_TRUE;
  }
}

// A value that an integer cannot hold becomes the nearest one that it can.
template <typename Integer>
double nearest_of(double value) {
  return std::clamp(value, double(std::numeric_limits<Integer>::min()), double(std::numeric_limits<Integer>::max()));
}

void expect_answers(Test& t, GLenum name, double value) {
  const double whole = std::floor(value + 0.5);
  GLboolean boolean = 77;
  gl.GetBooleanv(name, &boolean);
  t.expect_equal(int{boolean}, value != 0 ? int{GL_TRUE} : int{GL_FALSE}, "GetBooleanv");
  GLint integer = -77;
  gl.GetIntegerv(name, &integer);
  t.expect_equal(double(integer), nearest_of<GLint>(whole), "GetIntegerv");
  GLint64 long_integer = -77;
  gl.GetInteger64v(name, &long_integer);
  t.expect_equal(double(long_integer), nearest_of<GLint64>(whole), "GetInteger64v");
  GLfloat number = -77;
  gl.GetFloatv(name, &number);
  t.expect_equal(number, static_cast<GLfloat>(value), "GetFloatv");
  if (!t.is_gles()) {
    GLdouble long_number = -77;
    gl.GetDoublev(name, &long_number);
    t.expect_equal(long_number, value, "GetDoublev");
  }
  t.expect_no_error("the queries");
}

// The query writes one value, not four.
void expect_one_value(Test& t, GLenum name) {
  GLint integers[4] = {-77, -77, -77, -77};
  gl.GetIntegerv(name, integers);
  t.expect(integers[1] == -77 && integers[2] == -77, "GetIntegerv writes one value");
  GLboolean booleans[4] = {7, 7, 7, 7};
  gl.GetBooleanv(name, booleans);
  t.expect(booleans[1] == 7 && booleans[3] == 7, "GetBooleanv writes one byte");
}

const char* group_of(GLenum name) {
  switch (name) {
    case GL_ARK: return "tokens-1";
    case GL_DEPTH_TAG_ARRAY_ARK: return "tokens-10";
    case GL_MAX_DEPTH_ARK:
    case GL_POOL_LEVEL_ARK:
    case GL_CURRENT_DEPTH_TAG_ARK:
    case GL_DEPTH_TAG_ARRAY_TYPE_ARK:
    case GL_DEPTH_TAG_ARRAY_STRIDE_ARK:
    case GL_DEPTH_TAG_ARRAY_BUFFER_BINDING_ARK: return "tokens-3";
    case GL_DISPLACEMENT_SCALE_ARK:
    case GL_DISPLACEMENT_BIAS_ARK:
    case GL_PHONG_SHAPE_ARK:
    case GL_SCREEN_ERROR_ARK: return "tokens-29";
    default: return "tokens-14";
  }
}

Case query_case(const StateName& state) {
  return {.name = std::string("ark.query.state.") + state.leaf,
          .clauses = {group_of(state.name), state.clause},
          .plan =
              "Give every state a different value, and ask for this one by GetBooleanv, GetIntegerv, GetInteger64v, "
              "GetFloatv and, if it exists, GetDoublev.",
          .wrong =
              "INVALID_ENUM, or an untouched pointer, from all queries but GetIntegerv; -1 truncated to 0; four values "
              "written; a number truncated to an integer instead of rounded.",
          .check = [state](Test& t) {
            expect_one_value(t, state.name);
            expect_answers(t, state.name, double{number_of(state.name)});
            const EverythingSet objects = set_everything(t);
            expect_answers(t, state.name, value_set(state.name, objects));
          }};
}

void check_numbers(Test& t, GLenum name) {
  for (const float value :
       {0.0F, 0.25F, -0.25F, 1.75F, -1.75F, 3.0F, 1e6F, 1e-20F, -2000000.75F, 3e9F, -3e9F, 1e12F, 1e38F, -1e38F}) {
    gl.ARKParameterfARK(name, value);
    expect_answers(t, name, double{value});
  }
}

void check_great_integers(Test& t) {
  constexpr GLint greatest = std::numeric_limits<GLint>::max();
  for (const GLenum name : {GL_EDGE_PIXELS_ARK, GL_TRIANGLE_BUDGET_ARK})
    for (const GLint value : {greatest, 16777217, 65536}) {
      gl.ARKParameteriARK(name, value);
      expect_answers(t, name, value);
    }
}

void check_negative(Test& t) {
  for (const GLenum name : {GL_POOL_LEVEL_ARK, GL_DISPLACEMENT_UNIT_ARK, GL_DISPLACEMENT_COORDINATE_ARK})
    expect_answers(t, name, -1);
}

// The values of the tokens are written out here, so that a wrong value in the registry cannot hide itself.
struct TokenValue {
  GLenum value;
  GLenum of_header;
  const char* clause;
  GLenum parameter = 0;  // of ARKParameteriARK, which takes the token
};

const std::vector<TokenValue>& parameter_values() {
  static const std::vector<TokenValue> all{
      {0x6F11, GL_LINEAR_INPUTS_ARK, "tokens-35", 0x6F10},    {0x6F12, GL_LINEAR_OUTPUTS_ARK, "tokens-36", 0x6F10},
      {0x6F13, GL_CURVED_PN_ARK, "tokens-37", 0x6F10},        {0x6F30, GL_SCALAR_TAGGED_PN_ARK, "tokens-38", 0x6F10},
      {0x6F15, GL_DEPTH_TAG_ARK, "tokens-40", 0x6F14},        {0x6F16, GL_UNIFORM_DEPTH_ARK, "tokens-41", 0x6F14},
      {0x6F23, GL_MEASURED_DEPTH_ARK, "tokens-42", 0x6F14},   {0x6F19, GL_POLYGON_TRIANGLES_ARK, "tokens-44", 0x6F18},
      {0x6F1A, GL_POLYGON_CENTROID_ARK, "tokens-45", 0x6F18}, {0x6F1C, GL_MINIMUM_INTERIOR_ARK, "tokens-47", 0x6F1B},
      {0x6F1D, GL_SMOOTH_INTERIOR_ARK, "tokens-48", 0x6F1B},
  };
  return all;
}

const char* group_of_parameter(GLenum parameter) {
  switch (parameter) {
    case 0x6F10: return "tokens-34";
    case 0x6F14: return "tokens-39";
    case 0x6F18: return "tokens-43";
    default: return "tokens-46";
  }
}

Case value_case(const TokenValue& token) {
  return {
      .name = fmt::format("ark.query.token.x{:x}", token.value),
      .clauses = {token.clause, group_of_parameter(token.parameter)},
      .plan =
          "Give the parameter this value, written as a number, and read it back; then the same with the token's name.",
      .wrong = "Another value of the token; INVALID_ENUM.",
      .check = [token](Test& t) {
        t.expect_equal(token.of_header, token.value, "the token's value");
        for (const TokenValue& other : parameter_values())
          if (other.parameter == token.parameter && other.value != token.value)
            gl.ARKParameteriARK(token.parameter, static_cast<GLint>(other.value));
        gl.ARKParameteriARK(token.parameter, static_cast<GLint>(token.value));
        t.expect_no_error("ARKParameteriARK");
        t.expect_equal(integer_of(token.parameter), static_cast<GLint>(token.value), "the parameter");
      }};
}

void check_names(Test& t) {
  constexpr GLenum values[] = {0x6F00, 0x6F01, 0x6F02, 0x6F03, 0x6F09, 0x6F10, 0x6F14, 0x6F17, 0x6F18, 0x6F1B,
                               0x6F24, 0x6F25, 0x6F26, 0x6F31, 0x6F32, 0x6F33, 0x6F34, 0x6F35, 0x6F36, 0x6F37,
                               0x6F2F, 0x6F3C, 0x6F39, 0x6F3D, 0x6F04, 0x6F05, 0x6F06, 0x6F08};
  const EverythingSet objects = set_everything(t);
  for (std::size_t i = 0; i < std::size(values); ++i) {
    const StateName& state = extension_state()[i];
    t.expect_equal(state.name, values[i], std::string("the value of token ") + state.leaf);
    t.expect_equal(double{number_of(values[i])}, value_set(state.name, objects), state.leaf);
  }
  t.expect_equal(pointer_of(0x6F07), reinterpret_cast<const void*>(std::size_t{4}), "GetPointerv(0x6F07)");
  const GLuint program = gl.CreateProgram();
  for (const GLenum name : {0x6F22, 0x6F21, 0x6F20}) {  // the status comes last, since it writes a log
    GLint value = -7;
    gl.GetRefinementivARK(program, name, &value);
    t.expect_equal(value, 0, fmt::format("GetRefinementivARK({:#x})", name));
  }
  t.expect_no_error("queries by number");
}

std::vector<std::string> name_clauses() {
  std::vector<std::string> clauses{"tokens-12", "tokens-13", "tokens-49", "tokens-50", "tokens-51", "tokens-52"};
  for (const StateName& state : extension_state()) clauses.emplace_back(state.token_clause);
  return clauses;
}

void check_array_states(Test& t) {
  set_everything(t);
  const auto expect_all = [&](GLuint attribute, const std::string& what) {
    t.expect_equal(integer_of(GL_DEPTH_TAG_ARRAY_TYPE_ARK), array_state(attribute, GL_VERTEX_ATTRIB_ARRAY_TYPE), what);
    t.expect_equal(integer_of(GL_DEPTH_TAG_ARRAY_STRIDE_ARK), array_state(attribute, GL_VERTEX_ATTRIB_ARRAY_STRIDE),
                   what);
    t.expect_equal(integer_of(GL_DEPTH_TAG_ARRAY_BUFFER_BINDING_ARK),
                   array_state(attribute, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING), what);
    void* pointer = nullptr;
    gl.GetVertexAttribPointerv(attribute, GL_VERTEX_ATTRIB_ARRAY_POINTER, &pointer);
    t.expect_equal(pointer_of(GL_DEPTH_TAG_ARRAY_POINTER_ARK), static_cast<const void*>(pointer), what);
  };
  expect_all(7, "after DepthTagPointerARK");
  gl.VertexAttribPointer(7, 3, GL_BYTE, GL_TRUE, 20, reinterpret_cast<const void*>(std::size_t{12}));
  expect_all(7, "after VertexAttribPointer");
  t.expect_equal(integer_of(GL_DEPTH_TAG_ARRAY_TYPE_ARK), GLint{GL_BYTE}, "a type that only VertexAttribPointer takes");
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  expect_all(7, "after the buffer was unbound from ARRAY_BUFFER");
  gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, 9);
  expect_all(9, "of another attribute");
  t.expect_equal(integer_of(GL_DEPTH_TAG_ARRAY_STRIDE_ARK), 0, "stride of another attribute");
  t.expect_no_error("the queries");
}

void check_not_accepted(Test& t) {
  GLint value = -7;
  for (const GLenum name : {GL_DEPTH_TAG_ARRAY_POINTER_ARK, GL_LINEAR_INPUTS_ARK, GL_UNIFORM_DEPTH_ARK,
                            GL_REFINEMENT_STATUS_ARK, GL_MINIMUM_INTERIOR_ARK, 0x6F3F}) {
    gl.GetIntegerv(static_cast<GLenum>(name), &value);
    t.expect_error(GL_INVALID_ENUM, fmt::format("GetIntegerv of {:#x}", name));
    t.expect_equal(value, -7, "GetIntegerv left the value alone");
  }
  for (const GLenum name : {GL_POOL_LEVEL_ARK, GL_GEOMORPH_ARK, GL_WELD_ARK, GL_DEPTH_TAG_ARK}) {
    const std::string token = fmt::format(" of {:#x}", name);
    t.expect_equal(int{gl.IsEnabled(static_cast<GLenum>(name))}, int{GL_FALSE}, "IsEnabled" + token);
    t.expect_error(GL_INVALID_ENUM, "IsEnabled" + token);
    gl.Enable(static_cast<GLenum>(name));
    t.expect_error(GL_INVALID_ENUM, "Enable" + token);
    gl.Disable(static_cast<GLenum>(name));
    t.expect_error(GL_INVALID_ENUM, "Disable" + token);
  }
  void* pointer = &value;
  gl.GetPointerv(GL_DEPTH_TAG_ARRAY_ARK, &pointer);
  t.expect_error(GL_INVALID_ENUM, "GetPointerv of DEPTH_TAG_ARRAY_ARK");
  t.expect(pointer == &value, "GetPointerv left the pointer alone");
}

void check_is_enabled(Test& t) {
  gl.ARKinit(2);
  for (const GLenum name : {GL_ARK, GL_DEPTH_TAG_ARRAY_ARK}) {
    if (t.api() != Api::gl_compat) {
      GLuint array = 0;
      gl.GenVertexArrays(1, &array);
      gl.BindVertexArray(array);
    }
    gl.Enable(name);
    t.expect_equal(int{gl.IsEnabled(name)}, int{GL_TRUE}, "IsEnabled after Enable");
    expect_answers(t, name, GL_TRUE);
    gl.Enable(name);
    gl.Disable(name);
    t.expect_equal(int{gl.IsEnabled(name)}, int{GL_FALSE}, "IsEnabled after two Enables and a Disable");
    expect_answers(t, name, GL_FALSE);
  }
}

void check_strings(Test& t) {
  GLint count = 0;
  gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
  t.require(count > 0, "there are extensions");
  GLint64 long_count = 0;
  GLfloat number = 0;
  gl.GetInteger64v(GL_NUM_EXTENSIONS, &long_count);
  gl.GetFloatv(GL_NUM_EXTENSIONS, &number);
  t.expect_equal(long_count, GLint64{count}, "GetInteger64v");
  t.expect_equal(number, static_cast<GLfloat>(count), "GetFloatv");
  int named = 0;
  for (GLint i = 0; i < count; ++i) {
    const auto* const name = reinterpret_cast<const char*>(gl.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
    if (!t.expect(name != nullptr, "extension " + as_text(i) + " has a name")) return;
    named += std::strcmp(name, "GL_ARK_adaptive_refinement") == 0 ? 1 : 0;
  }
  t.expect_equal(named, 1, "the extension is named once");
  t.expect_no_error("names within the number of extensions");
  for (const GLuint index : {static_cast<GLuint>(count), static_cast<GLuint>(count) + 1, 0xffffffffU}) {
    t.expect(gl.GetStringi(GL_EXTENSIONS, index) == nullptr, "no name beyond the last");
    t.expect_error(GL_INVALID_VALUE, "an index beyond the last");
  }
}

}  // namespace

Cases queries_cases() {
  Cases cases{
      {.name = "ark.query.number.scale",
       .clauses = {"state-18", "tokens-29"},
       .plan = "Set DISPLACEMENT_SCALE_ARK to fractions, whole numbers and large numbers, and ask by every query.",
       .wrong =
           "Kept as an integer; truncated to an integer by GetIntegerv; cut to 32 bits by GetInteger64v; FALSE for "
           "a fraction.",
       .check = [](Test& t) { check_numbers(t, GL_DISPLACEMENT_SCALE_ARK); }},
      {.name = "ark.query.number.bias",
       .clauses = {"state-19", "tokens-29"},
       .plan = "Set DISPLACEMENT_BIAS_ARK to fractions, whole numbers and large numbers, and ask by every query.",
       .wrong = "Kept as an integer; truncated to an integer by GetIntegerv; FALSE for a fraction.",
       .check = [](Test& t) { check_numbers(t, GL_DISPLACEMENT_BIAS_ARK); }},
      {.name = "ark.query.great_integers",
       .clauses = {"state-10", "state-12", "11.R.2-10", "11.R.2-12", "tokens-14"},
       .plan = "Set EDGE_PIXELS_ARK and TRIANGLE_BUDGET_ARK to the greatest integer, and ask by every query.",
       .wrong = "Kept in 16 bits or as a float.",
       .check = check_great_integers},
      {.name = "ark.query.negative",
       .clauses = {"state-2", "state-15", "state-17"},
       .plan = "Ask for the states that are initially -1 by every query.",
       .wrong = "4294967295 by GetInteger64v or GetFloatv; FALSE by GetBooleanv.",
       .check = check_negative},
      {.name = "ark.query.token.names",
       .clauses = name_clauses(),
       .plan = "Compare the tokens' values with those of the text, and ask for each state by its number.",
       .wrong = "Two tokens exchanged.",
       .check = check_names},
      {.name = "ark.query.array",
       .clauses = {"chapter-22-5", "tokens-12", "10.R.1-2"},
       .plan = "Compare the array's states with those of the generic attribute, with every way to specify it, and "
               "after a change of DEPTH_TAG_ATTRIBUTE_ARK.",
       .wrong = "A copy that DepthTagPointerARK makes; the current buffer instead of the buffer at specification.",
       .check = check_array_states},
      {.name = "ark.query.not_accepted",
       .clauses = {"tokens-1", "tokens-12", "tokens-14"},
       .plan = "Give tokens of the extension to commands that do not accept them: INVALID_ENUM.",
       .wrong = "Every number of the block is accepted.",
       .check = check_not_accepted},
      {.name = "ark.query.strings",
       .clauses = {"name-1"},
       .plan = "Ask for the number of extensions in every way, then for names beyond the last.",
       .wrong = "One query gives the number without this extension; any index gives a name.",
       .check = check_strings},
      {.name = "ark.query.is_enabled",
       .clauses = {"tokens-1", "tokens-10", "11.R.1-12", "state-1", "state-23"},
       .plan = "Enable twice and disable once, for both capabilities; ask by IsEnabled and every query.",
       .wrong = "A counter; IsEnabled and GetBooleanv read different state.",
       .check = check_is_enabled},
  };
  for (const StateName& state : extension_state()) cases.push_back(query_case(state));
  for (const TokenValue& token : parameter_values()) cases.push_back(value_case(token));
  return cases;
}

}  // namespace glark::conformance
