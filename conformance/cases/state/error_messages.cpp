// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Message 1 (chapter 20) of every command of the extension and for every kind of wrong argument: it names the command and
// the error, and has the wrong value. Between Begin and End there is none.
#include <fmt/core.h>
#include <algorithm>
#include <cctype>
#include <limits>

#include "conformance/cases/cases.h"
#include "conformance/cases/state/listener.h"
#include "conformance/support/capture.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

// How a message may write a value: in lower case.
using Spellings = std::vector<std::string>;

Spellings spellings_of(GLint value) {
  Spellings all = {fmt::format("{}", value)};
  if (value >= 0) all.push_back(fmt::format("0x{:x}", value));
  if (value >= 0) all.push_back(fmt::format("0x{:04x}", value));
  return all;
}

Spellings spellings_of(GLenum value, const char* token) {
  Spellings all = spellings_of(static_cast<GLint>(value));
  all.emplace_back(token);
  return all;
}

struct WrongCall {
  std::string command;  // without "gl"
  GLenum error;
  Spellings values;  // one of them must be there; empty: no value is wrong
  std::function<void()> call;
  std::string what = {};
};
using WrongCalls = std::vector<WrongCall>;

std::string in_lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// Whether the text has the spelling, and not as a part of a longer number or word.
bool has_word(const std::string& text, const std::string& word) {
  const auto joins = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !joins(text[at - 1])) && (end == text.size() || !joins(text[end]))) return true;
  }
  return false;
}

void expect_told(Test& t, Listener& listener, const WrongCall& wrong) {
  const std::string what = wrong.command + (wrong.what.empty() ? "" : " of " + wrong.what);
  for (int again = 0; again < 2; ++again) {
    wrong.call();
    t.expect_error(wrong.error, what);
    const Messages messages = listener.take(1);
    if (!t.expect_equal(messages.size(), 1U, what + ": messages")) return;
    expect_message(t, messages, true, what);
    const std::string& text = messages[0].text;
    t.expect(has(text, wrong.command), what + ": the message names the command: " + text);
    t.expect(has(text, error_name(wrong.error).substr(error_name(wrong.error).find("INVALID"))),
             what + ": the message names the error: " + text);
    const std::string lower = in_lower_case(text);
    t.expect(wrong.values.empty() || std::any_of(wrong.values.begin(), wrong.values.end(),
                                                 [&](const std::string& value) { return has_word(lower, value); }),
             what + ": the message has the value " + (wrong.values.empty() ? "" : wrong.values[0]) + ": " + text);
  }
}

void expect_all_told(Test& t, const WrongCalls& calls) {
  Listener listener;
  for (const WrongCall& each : calls) expect_told(t, listener, each);
}

void check_number_values(Test& t) {
  gl.ARKinit(3);
  constexpr GLfloat infinity = std::numeric_limits<GLfloat>::infinity();
  WrongCalls calls;
  const auto add = [&](GLenum name, GLfloat value, const Spellings& spellings) {
    calls.push_back({"ARKParameterfARK", GL_INVALID_VALUE, spellings, [=] { gl.ARKParameterfARK(name, value); },
                     fmt::format("0x{:x}, {}", name, value)});
  };
  for (const GLenum name :
       {GL_PHONG_SHAPE_ARK, GL_SCREEN_ERROR_ARK, GL_DISPLACEMENT_SCALE_ARK, GL_DISPLACEMENT_BIAS_ARK}) {
    add(name, infinity, {"inf", "infinity", "infinite"});
    add(name, -infinity, {"inf", "infinity", "infinite"});
    add(name, std::numeric_limits<GLfloat>::quiet_NaN(), {"nan", "not a number"});
  }
  add(GL_PHONG_SHAPE_ARK, 7.25F, {"7.25"});
  add(GL_PHONG_SHAPE_ARK, -0.625F, {"-0.625"});
  add(GL_SCREEN_ERROR_ARK, -3.75F, {"-3.75"});
  for (const GLenum name : {GLenum{0x1234}, GLenum{GL_DEPTH_TEST}})
    calls.push_back({"ARKParameterfARK", GL_INVALID_ENUM, spellings_of(static_cast<GLint>(name)),
                     [=] { gl.ARKParameterfARK(name, 0.5F); }, "a name of no parameter"});
  calls.push_back({"ARKParameterfARK", GL_INVALID_ENUM, spellings_of(GL_GEOMORPH_ARK, "gl_geomorph_ark"),
                   [] { gl.ARKParameterfARK(GL_GEOMORPH_ARK, 1.0F); }, "a parameter that is no number"});
  calls.push_back({"ARKParameterfARK", GL_INVALID_ENUM, spellings_of(GL_EDGE_PIXELS_ARK, "gl_edge_pixels_ark"),
                   [] { gl.ARKParameterfARK(GL_EDGE_PIXELS_ARK, 2.0F); }, "a parameter of integers"});
  expect_all_told(t, calls);
}

void check_integer_values(Test& t) {
  gl.ARKinit(3);
  WrongCalls calls;
  const auto add = [&](GLenum error, GLenum name, GLint value) {
    calls.push_back({"ARKParameteriARK", error, spellings_of(value), [=] { gl.ARKParameteriARK(name, value); },
                     fmt::format("0x{:x}, {}", name, value)});
  };
  for (const GLint value : {43210, -77}) {
    for (const GLenum name : {GL_REFINEMENT_ARK, GL_DEPTH_SOURCE_ARK, GL_POLYGON_SPLIT_ARK, GL_PATTERN_INTERIOR_ARK,
                              GL_DISPLACEMENT_CHANNEL_ARK})
      add(GL_INVALID_ENUM, name, value);
    for (const GLenum name : {GL_UNIFORM_DEPTH_LEVEL_ARK, GL_DEPTH_TAG_ATTRIBUTE_ARK, GL_EDGE_DEGREES_ARK,
                              GL_DISCONTINUITY_ATTRIBUTE_ARK, GL_SCALAR_TAG_ATTRIBUTE_ARK, GL_DISPLACEMENT_UNIT_ARK,
                              GL_DISPLACEMENT_COORDINATE_ARK, GL_GEOMORPH_ARK, GL_WELD_ARK, GL_PHONG_SHAPE_ARK})
      add(GL_INVALID_VALUE, name, value);
  }
  for (const GLenum name : {GL_EDGE_PIXELS_ARK, GL_TRIANGLE_BUDGET_ARK, GL_SCREEN_ERROR_ARK})
    add(GL_INVALID_VALUE, name, -77);
  calls.push_back({"ARKParameteriARK", GL_INVALID_ENUM, spellings_of(0x1234), [] { gl.ARKParameteriARK(0x1234, 1); },
                   "a name of no parameter"});
  calls.push_back({"ARKParameteriARK", GL_INVALID_ENUM, spellings_of(GL_POOL_LEVEL_ARK),
                   [] { gl.ARKParameteriARK(GL_POOL_LEVEL_ARK, 1); }, "a state that is no parameter"});
  expect_all_told(t, calls);
}

void check_tag_values(Test& t) {
  expect_all_told(t, {{"DepthTag1i", GL_INVALID_VALUE, {}, [] { gl.DepthTag1i(7); }, "7 before ARKinit"},
                      {"ARKinit", GL_INVALID_VALUE, spellings_of(4099), [] { gl.ARKinit(4099); }, "4099"}});
  gl.ARKinit(3);
  upload(one_triangle());
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  static const GLfloat tags[3] = {};
  expect_all_told(t,
                  {{"DepthTag1i", GL_INVALID_VALUE, spellings_of(4), [] { gl.DepthTag1i(4); }, "a tag above the level"},
                   {"DepthTag1i", GL_INVALID_VALUE, {"4294967221"}, [] { gl.DepthTag1i(4294967221U); }, "a great tag"},
                   {"DepthTagPointerARK", GL_INVALID_ENUM, spellings_of(GL_DOUBLE, "gl_double"),
                    [] { gl.DepthTagPointerARK(GL_DOUBLE, 0, nullptr); }, "DOUBLE"},
                   {"DepthTagPointerARK", GL_INVALID_ENUM, spellings_of(GL_SHORT, "gl_short"),
                    [] { gl.DepthTagPointerARK(GL_SHORT, 0, nullptr); }, "SHORT"},
                   {"DepthTagPointerARK", GL_INVALID_VALUE, spellings_of(-77),
                    [] { gl.DepthTagPointerARK(GL_FLOAT, -77, nullptr); }, "a negative stride"},
                   {"DepthTagPointerARK",
                    GL_INVALID_OPERATION,
                    {},
                    [] { gl.DepthTagPointerARK(GL_FLOAT, 0, tags); },
                    "client memory"}});
}

void check_great_stride(Test& t) {
  GLint limit = 0;
  gl.GetIntegerv(GL_MAX_VERTEX_ATTRIB_STRIDE, &limit);
  while (gl.GetError() != GL_NO_ERROR) {
  }
  if (limit == 0) t.not_supported("no MAX_VERTEX_ATTRIB_STRIDE");
  gl.ARKinit(3);
  upload(one_triangle());
  const GLint stride = limit + 4321;
  expect_all_told(t, {{"DepthTagPointerARK", GL_INVALID_VALUE, spellings_of(stride),
                       [=] { gl.DepthTagPointerARK(GL_FLOAT, stride, nullptr); }, "a great stride"}});
}

void check_draw_values(Test& t) {
  upload(one_triangle());
  gl.UseProgram(colour_program(t));
  expect_all_told(t, {{"DrawARP", GL_INVALID_OPERATION, {}, [] { gl.DrawARP(GL_TRIANGLES, 0, 3); }, "before ARKinit"},
                      {"DrawARPElementsARK",
                       GL_INVALID_OPERATION,
                       {},
                       [] { gl.DrawARPElementsARK(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, nullptr); },
                       "before ARKinit"}});
  gl.ARKinit(2);
  WrongCalls calls;
  for (const auto& [mode, token] : {std::pair<GLenum, const char*>{GL_PATCHES, "gl_patches"},
                                    {GL_TRIANGLES_ADJACENCY, "gl_triangles_adjacency"},
                                    {GL_LINE_STRIP, "gl_line_strip"},
                                    {0x4321, "0x4321"}}) {
    const GLenum bad = mode;
    calls.push_back({"DrawARP", GL_INVALID_ENUM, spellings_of(bad, token), [=] { gl.DrawARP(bad, 0, 3); }, token});
    calls.push_back({"DrawARPElementsARK", GL_INVALID_ENUM, spellings_of(bad, token),
                     [=] { gl.DrawARPElementsARK(bad, 3, GL_UNSIGNED_SHORT, nullptr); }, token});
  }
  calls.push_back(
      {"DrawARP", GL_INVALID_VALUE, spellings_of(-77), [] { gl.DrawARP(GL_TRIANGLES, -77, 3); }, "a negative first"});
  calls.push_back(
      {"DrawARP", GL_INVALID_VALUE, spellings_of(-78), [] { gl.DrawARP(GL_TRIANGLES, 0, -78); }, "a negative count"});
  expect_all_told(t, calls);
}

// The errors that DrawElements generates as well.
void check_element_values(Test& t) {
  upload(one_triangle());
  gl.UseProgram(colour_program(t));
  gl.ARKinit(2);
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  constexpr GLushort indices[] = {0, 1, 2};
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
  expect_all_told(t,
                  {{"DrawARPElementsARK", GL_INVALID_VALUE, spellings_of(-77),
                    [] { gl.DrawARPElementsARK(GL_TRIANGLES, -77, GL_UNSIGNED_SHORT, nullptr); }, "a negative count"},
                   {"DrawARPElementsARK", GL_INVALID_ENUM, spellings_of(GL_FLOAT, "gl_float"),
                    [] { gl.DrawARPElementsARK(GL_TRIANGLES, 3, GL_FLOAT, nullptr); }, "FLOAT"}});
}

void check_listed_draws(Test& t) {
  gl.ARKinit(2);
  Listener listener;  // Enable would be compiled
  gl.NewList(1, GL_COMPILE);
  for (const auto& [command, call] :
       {std::pair<const char*, void (*)()>{"DrawARP", [] { gl.DrawARP(GL_TRIANGLES, 0, 3); }},
        {"DrawARPElementsARK", [] { gl.DrawARPElementsARK(GL_TRIANGLES, 0, GL_UNSIGNED_SHORT, nullptr); }}})
    expect_told(t, listener, {command, GL_INVALID_OPERATION, {}, call, "a list"});
  gl.EndList();
  t.expect_no_error("the list");
}

void check_program_values(Test& t) {
  gl.ARKinit(2);
  const GLuint good = colour_program(t);
  const GLuint shader = gl.CreateShader(GL_VERTEX_SHADER);
  static const char* const source = "void refine() { }";
  WrongCalls calls;
  const auto add = [&](GLuint program, GLenum error, const Spellings& values, const char* what) {
    calls.push_back({"RefinementShaderSourceARK", error, values,
                     [=] { gl.RefinementShaderSourceARK(program, 1, &source, nullptr); }, what});
    calls.push_back({"GetRefinementivARK", error, values,
                     [=] {
                       GLint value = 0;
                       gl.GetRefinementivARK(program, GL_REFINEMENT_SOURCE_LENGTH_ARK, &value);
                     },
                     what});
    calls.push_back({"GetRefinementInfoLogARK", error, values,
                     [=] {
                       GLchar log[4];
                       gl.GetRefinementInfoLogARK(program, sizeof(log), nullptr, log);
                     },
                     what});
  };
  add(7654321, GL_INVALID_VALUE, spellings_of(7654321), "an unknown name");
  add(shader, GL_INVALID_OPERATION, spellings_of(static_cast<GLint>(shader)), "a shader");
  if (!t.is_compat()) add(0, GL_INVALID_VALUE, {"0"}, "program 0");
  calls.push_back({"RefinementShaderSourceARK", GL_INVALID_VALUE, spellings_of(-77),
                   [=] { gl.RefinementShaderSourceARK(good, -77, &source, nullptr); }, "a negative count"});
  calls.push_back({"GetRefinementInfoLogARK", GL_INVALID_VALUE, spellings_of(-77),
                   [=] {
                     GLchar log[4];
                     gl.GetRefinementInfoLogARK(good, -77, nullptr, log);
                   },
                   "a negative bufSize"});
  calls.push_back({"GetRefinementivARK", GL_INVALID_ENUM, spellings_of(0x1234),
                   [=] {
                     GLint value = 0;
                     gl.GetRefinementivARK(good, 0x1234, &value);
                   },
                   "a name of no property"});
  expect_all_told(t, calls);
}

// Each call is an error between Begin and End, and would be none, or another one, outside.
void check_within_begin(Test& t) {
  gl.ARKinit(2);
  static const char* const source = "void refine() { }";
  static GLint value = 0;
  static GLchar log[4];
  const std::pair<const char*, void (*)()> calls[] = {
      {"ARKinit", [] { gl.ARKinit(1); }},
      {"ARKinit of 4099", [] { gl.ARKinit(4099); }},
      {"ARKParameteriARK", [] { gl.ARKParameteriARK(GL_GEOMORPH_ARK, 1); }},
      {"ARKParameteriARK of a wrong value", [] { gl.ARKParameteriARK(GL_GEOMORPH_ARK, 77); }},
      {"ARKParameterfARK", [] { gl.ARKParameterfARK(GL_PHONG_SHAPE_ARK, 0.5F); }},
      {"ARKParameterfARK of a wrong value", [] { gl.ARKParameterfARK(GL_PHONG_SHAPE_ARK, 7.25F); }},
      {"DepthTagPointerARK", [] { gl.DepthTagPointerARK(GL_FLOAT, 0, nullptr); }},
      {"DepthTagPointerARK of a wrong type", [] { gl.DepthTagPointerARK(GL_DOUBLE, 0, nullptr); }},
      {"DrawARP", [] { gl.DrawARP(GL_TRIANGLES, 0, 3); }},
      {"DrawARP of points", [] { gl.DrawARP(GL_POINTS, 0, 3); }},
      {"DrawARPElementsARK", [] { gl.DrawARPElementsARK(GL_TRIANGLES, 0, GL_UNSIGNED_SHORT, nullptr); }},
      {"RefinementShaderSourceARK", [] { gl.RefinementShaderSourceARK(0, 1, &source, nullptr); }},
      {"GetRefinementivARK", [] { gl.GetRefinementivARK(0, GL_REFINEMENT_SOURCE_LENGTH_ARK, &value); }},
      {"GetRefinementivARK of a wrong name", [] { gl.GetRefinementivARK(0, 0x1234, &value); }},
      {"GetRefinementInfoLogARK", [] { gl.GetRefinementInfoLogARK(0, sizeof(log), nullptr, log); }},
      {"DepthTag1i of a great tag", [] { gl.DepthTag1i(77); }},
  };
  Listener listener;
  for (const auto& [what, call] : calls) {
    const Snapshot before = take_snapshot(t);
    listener.take_all();
    gl.Begin(GL_TRIANGLES);
    call();
    gl.End();
    const bool is_tag = std::string(what).starts_with("DepthTag1i");
    t.expect_error(is_tag ? GL_INVALID_VALUE : GL_INVALID_OPERATION, what);
    t.expect_equal(listener.take(1).size(), 0U, std::string(what) + ": messages");
    expect_unchanged(t, take_snapshot(t), before, what);
    gl.ARKinit(4099);  // afterwards there are messages again
    t.expect_error(GL_INVALID_VALUE, "ARKinit");
    t.expect_equal(listener.take(1).size(), 1U, std::string("a message after ") + what);
  }
}

constexpr Area value_case{"ark.message.values."};
constexpr const char* without_value =
    "A message without the value; one that is told only once; another command's name.";

}  // namespace

Cases error_messages_cases() {
  const std::vector<std::string> clauses = {"chapter-20-4", "chapter-20-10", "chapter-20-11"};
  return {
      value_case("numbers", clauses, "Give each parameter that is a number every kind of wrong value.", without_value,
                 check_number_values),
      value_case("integers", clauses, "Give each parameter of ARKParameteriARK wrong values.", without_value,
                 check_integer_values),
      value_case("tags", clauses, "Wrong levels, tags, types and strides.", without_value, check_tag_values),
      optional(value_case("great_stride", clauses, "A stride above the limit.", without_value, check_great_stride)),
      value_case("draws", clauses, "Wrong modes, negative numbers, and draws before ARKinit.", without_value,
                 check_draw_values),
      value_case("elements", clauses, "A negative count and a wrong type of indices.",
                 "The error comes from DrawElements, without a message.", check_element_values),
      value_case("listed", clauses, "Draw while a list is compiled.", "The error comes without a message.",
                 check_listed_draws, compat_only),
      value_case("programs", clauses, "Wrong names, counts, sizes and properties for the three commands of programs.",
                 without_value, check_program_values),
      value_case("within_begin", {"chapter-20-12", "errors-1", "errors-2"},
                 "Call each command between Begin and End, right and wrong.",
                 "A message there, or after End; the message is another error; no message ever after.",
                 check_within_begin, compat_only),
  };
}

}  // namespace glark::conformance
