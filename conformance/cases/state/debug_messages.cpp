// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Messages of debug output: errors, and what a draw does not get (chapter 20).
#include <algorithm>
#include <array>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/cases/programs/refinement_source.h"
#include "conformance/cases/state/listener.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

// The control: a message of the application arrives.
void control(Test& t) {
  Messages messages;
  gl.Enable(GL_DEBUG_OUTPUT);
  gl.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  gl.DebugMessageCallback(note, &messages);
  gl.DebugMessageInsert(GL_DEBUG_SOURCE_THIRD_PARTY, GL_DEBUG_TYPE_OTHER, 77, GL_DEBUG_SEVERITY_MEDIUM, -1, "hello");
  gl.DebugMessageCallback(nullptr, nullptr);
  t.expect(messages.size() == 1 && messages[0].id == 77 && messages[0].text == "hello", "a message that is inserted");
}

void check_errors(Test& t) {
  Listener listener;
  gl.ARKinit(4099);
  t.expect_error(GL_INVALID_VALUE, "ARKinit of a great level");
  Messages messages = listener.take(1);
  expect_message(t, messages, true);
  t.expect(has(messages[0].text, "ARKinit"), "the message names the command");
  t.expect(has(messages[0].text, "INVALID_VALUE"), "the message names the error");
  t.expect(has(messages[0].text, "4099"), "the message has the value");
  gl.ARKinit(2);
  t.expect(listener.take(1).empty(), "no message without an error");
  for (const GLuint tag : {77U, 77U}) {
    gl.DepthTag1i(tag);
    t.expect_error(GL_INVALID_VALUE, "DepthTag1i of a great tag");
    messages = listener.take(1);
    expect_message(t, messages, true);
    t.expect(has(messages[0].text, "DepthTag1i") && has(messages[0].text, "77"), "the command and the value");
  }
  gl.DrawARP(GL_POINTS, 0, 3);
  t.expect_error(GL_INVALID_ENUM, "DrawARP of points");
  messages = listener.take(1);
  expect_message(t, messages, true);
  t.expect(has(messages[0].text, "DrawARP") && has(messages[0].text, "INVALID_ENUM"), "the command and the error");
}

void check_filters(Test& t) {
  Listener listener;
  gl.DebugMessageControl(GL_DEBUG_SOURCE_THIRD_PARTY, GL_DEBUG_TYPE_ERROR, GL_DONT_CARE, 0, nullptr, GL_FALSE);
  gl.ARKinit(4099);
  t.expect(listener.take(1).empty(), "no message that DebugMessageControl excludes");
  gl.DebugMessageControl(GL_DEBUG_SOURCE_THIRD_PARTY, GL_DEBUG_TYPE_ERROR, GL_DONT_CARE, 0, nullptr, GL_TRUE);
  gl.Disable(GL_DEBUG_OUTPUT);
  gl.ARKinit(4099);
  gl.Enable(GL_DEBUG_OUTPUT);
  t.expect(listener.take(1).empty(), "no message while DEBUG_OUTPUT is disabled");
  gl.DebugMessageCallback(nullptr, nullptr);
  std::array<GLchar, 2000> text{};
  GLuint id = 0;
  while (gl.GetDebugMessageLog(1, 2000, nullptr, nullptr, &id, nullptr, nullptr, text.data()) > 0) {
  }
  gl.ARKinit(4099);
  GLenum source = 0;
  const GLuint count = gl.GetDebugMessageLog(1, 2000, &source, nullptr, &id, nullptr, nullptr, text.data());
  t.expect(count == 1 && source == GL_DEBUG_SOURCE_THIRD_PARTY && id == 1,
           "without a callback, the log has the message");
  t.expect(has(text.data(), "4099"), "the log has the value");
  t.expect_error(GL_INVALID_VALUE, "ARKinit");
}

void check_begin_end(Test& t) {
  gl.ARKinit(2);
  Listener listener;
  gl.Begin(GL_TRIANGLES);
  gl.ARKinit(1);
  gl.End();
  t.expect_error(GL_INVALID_OPERATION, "ARKinit between Begin and End");
  t.expect(listener.take(1).empty(), "no message between Begin and End");
}

void draw() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

GLuint position_program(Test& t, const std::string& position) {
  return build_program(t, {.vertex = "layout(location = 0) in vec4 position; out vec4 colour;\n"
                                     "void main() { colour = vec4(1.0); gl_Position = " +
                                     position + "; }\n"});
}

// Draws twice with each of two programs. Each program is told of once, by a message with this id.
void expect_told(Test& t, GLuint id, const std::string& position, const std::function<void(GLuint)>& prepare) {
  upload(one_triangle());
  Listener listener;
  for (int number = 0; number < 2; ++number) {
    const GLuint program = position_program(t, position);
    prepare(program);
    gl.UseProgram(program);
    draw();
    expect_message(t, listener.take(id), false);
    draw();
    t.expect(listener.take(id).empty(), "one message for each program");
  }
  t.expect_no_error("the draws");
}

void check_unrefined(Test& t) {
  refine_uniformly(1);
  upload(one_triangle());
  Listener listener;
  const GLuint program = colour_program(t);
  gl.UseProgram(program);
  draw();
  t.expect(listener.take(2).empty(), "no message about a refined draw");
  give(program, "void refine() { position.x += not_declared; }");
  draw();
  const Messages messages = listener.take(2);
  expect_message(t, messages, false);
  t.expect(has(messages[0].text, "not_declared"), "the message includes the log");
  draw();
  t.expect(listener.take(2).empty(), "one message for a reason");
}

void check_no_normal(Test& t) {
  for (const GLenum refinement : {GL_CURVED_PN_ARK, GL_SCALAR_TAGGED_PN_ARK, GL_PHONG_ARK}) {
    refine_uniformly(1, refinement);
    expect_told(t, 3, "position", [](GLuint) {});
  }
  refine_uniformly(1, GL_LINEAR_INPUTS_ARK);
  upload(one_triangle());
  Listener listener;
  gl.UseProgram(position_program(t, "position"));
  draw();
  t.expect(listener.take(3).empty(), "no message without a curved refinement");
}

void check_corners_only(Test& t) {
  const std::string numbered = "position + vec4(0.001 * float(gl_VertexID))";
  for (const GLenum refinement : {GL_LINEAR_INPUTS_ARK, GL_CURVED_PN_ARK}) {
    refine_uniformly(1, refinement);
    expect_told(t, 3, numbered, [](GLuint) {});
  }
  refine_uniformly(1, GL_LINEAR_OUTPUTS_ARK);
  upload(one_triangle());
  Listener listener;
  gl.UseProgram(position_program(t, numbered));
  draw();
  t.expect(listener.take(3).empty(), "no message if outputs are wanted");
}

// A program that was linked again, or has another refinement shader, is told of again.
void check_again(Test& t) {
  upload(one_triangle());
  refine_uniformly(1, GL_CURVED_PN_ARK);
  Listener listener;
  const GLuint program = position_program(t, "position");
  gl.UseProgram(program);
  const auto expect_once = [&](const std::string& what) {
    draw();
    t.expect_equal(listener.take(3).size(), 1U, what);
    draw();
    t.expect(listener.take(3).empty(), what + ": no message for the second draw");
  };
  expect_once("the first draw");
  gl.LinkProgram(program);
  gl.UseProgram(program);
  expect_once("after LinkProgram");
  give(program, "void refine() { position.x += 0.0; }");
  expect_once("after RefinementShaderSourceARK");
}

void check_ignored_shader(Test& t) {
  refine_uniformly(1);
  expect_told(t, 4, "position + vec4(0.001 * float(gl_VertexID))",
              [](GLuint program) { give(program, "void refine() { position.x += 0.1; }"); });
  upload(one_triangle());
  Listener listener;
  const GLuint program = position_program(t, "position");
  give(program, "void refine() { position.x += 0.1; }");
  gl.UseProgram(program);
  draw();
  t.expect(listener.take(4).empty(), "no message about a shader that is executed");
}

void check_not_displaced(Test& t) {
  refine_uniformly(1);
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 0);
  expect_told(t, 5, "position", [](GLuint) {});
}

using Counts = std::array<std::size_t, 3>;

// The number of messages 3, 4 and 5 since the last call.
Counts count_messages(Listener& listener) {
  Counts counts{};
  for (const Message& message : listener.take_all())
    if (message.id >= 3 && message.id <= 5) ++counts[message.id - 3];
  return counts;
}

// Makes the next draw generate message 3, 4 or 5.
void cause(GLuint program, GLuint message) {
  if (message == 3) gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  if (message == 4) give(program, "void refine() { position.x += 0.1; }");
  if (message == 5) gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 0);
}

// Each step causes some of the messages. An implementation may generate message 3 earlier, since it refines outputs
// where the vertex stage reads gl_VertexID.
void expect_steps(Test& t, const std::string& position, const std::vector<std::vector<GLuint>>& steps) {
  refine_uniformly(1, GL_LINEAR_INPUTS_ARK);
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, -1);
  Listener listener;
  const GLuint program = position_program(t, position);
  gl.UseProgram(program);
  std::size_t earlier = 0;
  std::string name = "after";
  for (const auto& step : steps) {
    for (const GLuint message : step) {
      cause(program, message);
      name += " " + as_text(message);
    }
    draw();
    const Counts counts = count_messages(listener);
    for (const GLuint message : step)
      if (message != 3 || earlier == 0) t.expect_equal(counts[message - 3], 1U, name + ": message " + as_text(message));
    earlier += counts[0];
    draw();
    t.expect(count_messages(listener) == Counts{}, name + ": no message is generated again");
  }
}

// One program causes several messages: one after another, or at once.
void check_each_of_three(Test& t) {
  upload(one_triangle());
  for (const auto& steps : std::vector<std::vector<std::vector<GLuint>>>{{{3}, {5}}, {{5}, {3}}, {{3, 5}}})
    expect_steps(t, "position", steps);
  for (const auto& steps : std::vector<std::vector<std::vector<GLuint>>>{{{3}, {4}, {5}},
                                                                         {{3}, {5}, {4}},
                                                                         {{4}, {3}, {5}},
                                                                         {{4}, {5}, {3}},
                                                                         {{5}, {3}, {4}},
                                                                         {{5}, {4}, {3}},
                                                                         {{3, 4}, {5}},
                                                                         {{4, 5}, {3}},
                                                                         {{5, 3}, {4}},
                                                                         {{3}, {4, 5}},
                                                                         {{4}, {5, 3}},
                                                                         {{5}, {3, 4}},
                                                                         {{3, 4, 5}}})
    expect_steps(t, "position + vec4(0.001 * float(gl_VertexID))", steps);
  t.expect_no_error("the draws");
}

// Message 3 is generated once for each program, not for each refinement.
void check_other_refinement_once(Test& t) {
  upload(one_triangle());
  refine_uniformly(1);
  Listener listener;
  const std::array<GLenum, 3> refinements = {GL_CURVED_PN_ARK, GL_SCALAR_TAGGED_PN_ARK, GL_PHONG_ARK};
  for (std::size_t first = 0; first < 3; ++first) {
    gl.UseProgram(position_program(t, "position"));
    for (std::size_t i = 0; i < 3; ++i) {
      gl.ARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(refinements[(first + i) % 3]));
      draw();
      t.expect_equal(listener.take(3).size(), i == 0 ? 1U : 0U, "messages with refinement number " + as_text(i + 1));
    }
  }
}

constexpr Area message_case{"ark.message.", control};

}  // namespace

Cases debug_messages_cases() {
  return {
      message_case("error", {"chapter-20-2", "chapter-20-3", "chapter-20-4", "chapter-20-10", "chapter-20-11"},
                   "Generate errors of three commands; compare what the callback gets.",
                   "An error without a message; a message that is told once only; the source of the application.",
                   check_errors),
      message_case("filters", {"chapter-20-2", "chapter-20-9"},
                   "Generate an error while DebugMessageControl excludes it, while DEBUG_OUTPUT is disabled, and "
                   "without a callback.",
                   "Messages that cannot be switched off, or that the log lacks.", check_filters),
      message_case("begin_end", {"chapter-20-12"}, "Call ARKinit between Begin and End.",
                   "The message generates another error.", check_begin_end, compat_only),
      message_case("unrefined", {"chapter-20-5", "chapter-20-22", "chapter-20-15"},
                   "Draw twice with a refinement shader that has an error.",
                   "Silence; a message for each draw; a message without the error.", check_unrefined),
      message_case("no_normal", {"chapter-20-6", "chapter-20-20", "chapter-20-21"},
                   "Draw with each curved refinement and a vertex stage without a normal.",
                   "Silence; a message for each draw; one message for all programs.", check_no_normal),
      message_case("corners_only", {"11.R.10-3", "chapter-20-6", "chapter-20-20"},
                   "Draw with a vertex stage that reads gl_VertexID, with each kind of refinement.",
                   "The inputs are not refined, in silence; a message although outputs are wanted.",
                   check_corners_only),
      message_case("again", {"chapter-20-21"}, "Link a program again, and give it a refinement shader.",
                   "A program that was changed stays silent.", check_again),
      message_case("ignored_shader", {"chapter-20-7", "chapter-20-17", "chapter-20-21"},
                   "Draw with a refinement shader and a vertex stage that reads gl_VertexID.",
                   "The shader is ignored in silence.", check_ignored_shader),
      message_case("each_of_three", {"chapter-20-20", "chapter-20-17", "chapter-20-18", "chapter-20-21"},
                   "One program causes messages 3, 4 and 5, in each order, one at a time and several at once.",
                   "After one of these messages, a program generates none of the others; only one is generated where "
                   "several apply.",
                   check_each_of_three),
      message_case("other_refinement_once", {"chapter-20-20", "chapter-20-21"},
                   "Draw with one program and all curved refinements in turn.", "A message for each refinement.",
                   check_other_refinement_once),
      message_case("not_displaced", {"chapter-20-8", "chapter-20-18", "chapter-20-21"},
                   "Displace with a vertex stage without a normal and a texture coordinate.",
                   "Nothing is displaced, in silence.", check_not_displaced),
  };
}

}  // namespace glark::conformance
