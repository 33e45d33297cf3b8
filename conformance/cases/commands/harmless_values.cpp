// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Colour indices and edge flags, by each command, for vertices and as current values, directly and in lists. Neither
// has an effect on filled triangles in RGBA mode: each draw is that without the command.
#include <fmt/core.h>

#include "conformance/cases/cases.h"
#include "conformance/cases/commands/as_plain.h"

namespace glark::conformance {
namespace {

constexpr GLuint harmless_list = 45;

struct HarmlessCommand {
  const char* leaf;
  void (*set)(int turn);
  GLenum current;
};

template <typename Number>
constexpr Number index_of_turn(int turn) {
  return static_cast<Number>(3 + 5 * turn);
}

constexpr HarmlessCommand harmless_commands[] = {
    {"EdgeFlag", [](int turn) { gl.EdgeFlag(turn % 2 == 0 ? GL_TRUE : GL_FALSE); }, GL_EDGE_FLAG},
    {"EdgeFlagv",
     [](int turn) {
       const GLboolean flag = turn % 2 == 0 ? GL_TRUE : GL_FALSE;
       gl.EdgeFlagv(&flag);
     },
     GL_EDGE_FLAG},
    {"Indexd", [](int turn) { gl.Indexd(index_of_turn<GLdouble>(turn)); }, GL_CURRENT_INDEX},
    {"Indexdv",
     [](int turn) {
       const auto index = index_of_turn<GLdouble>(turn);
       gl.Indexdv(&index);
     },
     GL_CURRENT_INDEX},
    {"Indexf", [](int turn) { gl.Indexf(index_of_turn<GLfloat>(turn)); }, GL_CURRENT_INDEX},
    {"Indexfv",
     [](int turn) {
       const auto index = index_of_turn<GLfloat>(turn);
       gl.Indexfv(&index);
     },
     GL_CURRENT_INDEX},
    {"Indexi", [](int turn) { gl.Indexi(index_of_turn<GLint>(turn)); }, GL_CURRENT_INDEX},
    {"Indexiv",
     [](int turn) {
       const auto index = index_of_turn<GLint>(turn);
       gl.Indexiv(&index);
     },
     GL_CURRENT_INDEX},
    {"Indexs", [](int turn) { gl.Indexs(index_of_turn<GLshort>(turn)); }, GL_CURRENT_INDEX},
    {"Indexsv",
     [](int turn) {
       const auto index = index_of_turn<GLshort>(turn);
       gl.Indexsv(&index);
     },
     GL_CURRENT_INDEX},
    {"Indexub", [](int turn) { gl.Indexub(index_of_turn<GLubyte>(turn)); }, GL_CURRENT_INDEX},
    {"Indexubv",
     [](int turn) {
       const auto index = index_of_turn<GLubyte>(turn);
       gl.Indexubv(&index);
     },
     GL_CURRENT_INDEX},
};

GLfloat harmless_current(GLenum name) {
  GLfloat value = -1;
  gl.GetFloatv(name, &value);
  return value;
}

// `set` is null: the draw without the command.
void harmless_strip(const HarmlessCommand* command) {
  gl.Begin(GL_TRIANGLE_STRIP);
  for (int i = 0; i < 6; ++i) {
    gl.Color3f(0.9F - 0.1F * static_cast<float>(i), 0.3F, 0.2F + 0.1F * static_cast<float>(i % 3));
    if (command != nullptr) command->set(i);
    gl.Vertex2f(-0.8F + 0.3F * static_cast<float>(i), i % 2 == 0 ? -0.7F : 0.6F + 0.05F * static_cast<float>(i));
  }
  gl.End();
}

void check_harmless(Test& t, const HarmlessCommand& command) {
  const GLfloat places[] = {-0.75F, -0.5F, 0.75F, -0.75F, 0.25F, 0.75F};
  const auto of_arrays = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  const auto strip = [&command] { harmless_strip(&command); };
  const auto call = [] { gl.CallList(harmless_list); };
  gl.VertexPointer(2, GL_FLOAT, 0, places);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  const PlainDraw plain = plain_draw([] { harmless_strip(nullptr); });
  command.set(5);
  const GLfloat left = harmless_current(command.current);
  expect_as_plain(t, plain, strip, "between Begin and End", {.is_often = true});
  t.expect_equal(harmless_current(command.current), left, "the value after End");
  gl.NewList(harmless_list, GL_COMPILE);
  strip();
  gl.EndList();
  expect_as_plain(t, plain, call, "in a list", {.is_often = true});
  command.set(0);
  gl.CallList(harmless_list);
  t.expect_equal(harmless_current(command.current), left, "the value after a list");
  const PlainDraw arrays = plain_draw(of_arrays);
  for (int turn = 0; turn < 4; ++turn) {
    command.set(turn);
    const GLfloat value = harmless_current(command.current);
    expect_as_plain(t, arrays, of_arrays, fmt::format("the current value {}", turn), {.is_often = turn == 1});
    t.expect_equal(harmless_current(command.current), value, "the value after array draws");
  }
  t.expect_no_error("the draws");
}

// An array of indices, of each type, whose content and pointer change between draws that repeat.
void check_harmless_array(Test& t) {
  const GLfloat places[] = {-0.75F, -0.5F, 0.75F, -0.75F, 0.25F, 0.75F};
  const GLdouble content[] = {3, 7, 11, 13, 17, 19};
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  gl.VertexPointer(2, GL_FLOAT, 0, places);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  const PlainDraw plain = plain_draw(draw);
  for (const GLenum type : {GL_UNSIGNED_BYTE, GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE})
    for (const std::size_t first : {std::size_t{0}, std::size_t{3}}) {
      const std::string what = fmt::format("type 0x{:x}, element {}", type, first);
      gl.IndexPointer(type, 0, content + first);
      gl.EnableClientState(GL_INDEX_ARRAY);
      expect_as_plain(t, plain, draw, what, {.is_often = true});
      t.expect(gl.IsEnabled(GL_INDEX_ARRAY) == GL_TRUE, what + ": the array is enabled");
      gl.DisableClientState(GL_INDEX_ARRAY);
      expect_as_plain(t, plain, draw, what + ", disabled");
    }
  t.expect_no_error("the draws");
}

}  // namespace

Cases harmless_values_cases() {
  Cases cases;
  for (const HarmlessCommand& command : harmless_commands)
    cases.push_back({.name = fmt::format("ark.command.harmless.{}", leaf_of_command(command.leaf)),
                     .clauses = {"10.R.2-1", "11.R.13-1"},
                     .plan =
                         "Give vertices a colour index or an edge flag, directly and in a list, and change the current "
                         "one between array draws: the picture and the count are those without it.",
                     .wrong = "The command counts as a vertex, or ends the primitive; its value is lost after a draw.",
                     .apis = compat_only,
                     .check = [&command](Test& t) { check_harmless(t, command); }});
  cases.push_back({.name = "ark.command.harmless.indexpointer",
                   .clauses = {"10.R.2-1", "11.R.13-1"},
                   .plan = "Enable an array of colour indices, of each type, between draws that repeat.",
                   .wrong = "The draw is refused or changes; the array is disabled.",
                   .apis = compat_only,
                   .check = check_harmless_array});
  return cases;
}

}  // namespace glark::conformance
