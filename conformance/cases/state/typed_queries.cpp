// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// State of GL that an implementation may have to change while it refines, read by each query of GL between refined
// draws: as between unrefined ones.
#include <fmt/core.h>

#include <functional>
#include <map>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

struct TypedQuery {
  const char* leaf;
  std::string (*read)(GLenum name);
  bool is_desktop;
};

template <typename Value, typename Get>
std::string read_by(const Get& get, GLenum name) {
  std::array<Value, 16> values{};
  values.fill(static_cast<Value>(77));
  get(name, values.data());
  return fmt::format("{} {}", as_text(values[0]), as_text(values[1]));
}

constexpr TypedQuery typed_queries[] = {
    {"boolean", [](GLenum name) { return read_by<GLboolean>(gl.GetBooleanv, name); }, false},
    {"integer", [](GLenum name) { return read_by<GLint>(gl.GetIntegerv, name); }, false},
    {"integer64", [](GLenum name) { return read_by<GLint64>(gl.GetInteger64v, name); }, false},
    {"float", [](GLenum name) { return read_by<GLfloat>(gl.GetFloatv, name); }, false},
    {"double", [](GLenum name) { return read_by<GLdouble>(gl.GetDoublev, name); }, true},
};

struct TypedState {
  const char* name;
  GLenum token;
  bool is_compat = false;
};

constexpr TypedState typed_states[] = {{"TRANSFORM_FEEDBACK_PAUSED", GL_TRANSFORM_FEEDBACK_PAUSED},
                                       {"TRANSFORM_FEEDBACK_ACTIVE", GL_TRANSFORM_FEEDBACK_ACTIVE},
                                       {"TRANSFORM_FEEDBACK_BINDING", GL_TRANSFORM_FEEDBACK_BINDING},
                                       {"TRANSFORM_FEEDBACK_BUFFER_BINDING", GL_TRANSFORM_FEEDBACK_BUFFER_BINDING},
                                       {"CURRENT_PROGRAM", GL_CURRENT_PROGRAM},
                                       {"PROGRAM_PIPELINE_BINDING", GL_PROGRAM_PIPELINE_BINDING},
                                       {"VERTEX_ARRAY_BINDING", GL_VERTEX_ARRAY_BINDING},
                                       {"ARRAY_BUFFER_BINDING", GL_ARRAY_BUFFER_BINDING},
                                       {"RASTERIZER_DISCARD", GL_RASTERIZER_DISCARD},
                                       {"NUM_EXTENSIONS", GL_NUM_EXTENSIONS},
                                       {"LIST_INDEX", GL_LIST_INDEX, true},
                                       {"LIST_MODE", GL_LIST_MODE, true},
                                       {"LIST_BASE", GL_LIST_BASE, true}};

using Readings = std::vector<std::pair<std::string, std::string>>;

void read_state(const Test& t, const TypedQuery& query, const std::string& when, Readings& into) {
  for (const TypedState& state : typed_states)
    if (!state.is_compat || t.is_compat())
      into.emplace_back(fmt::format("{} {}", state.name, when), query.read(state.token));
}

// The state of the feedback by its name, which only later versions have.
void read_feedback(const Test& t, GLuint feedback, const std::string& when, Readings& into) {
  if (t.is_gles() || t.version() < 45) return;
  for (const GLenum name : {GL_TRANSFORM_FEEDBACK_PAUSED, GL_TRANSFORM_FEEDBACK_ACTIVE}) {
    GLint value = -1;
    gl.GetTransformFeedbackiv(feedback, name, &value);
    into.emplace_back(fmt::format("GetTransformFeedbackiv({:#x}) {}", name, when), as_text(value));
  }
}

constexpr GLsizeiptr feedback_bytes = 100000;

Readings readings_of_feedback(const Test& t, const TypedQuery& query, GLuint feedback) {
  Readings readings;
  const auto read = [&](const std::string& when) {
    read_state(t, query, when, readings);
    read_feedback(t, feedback, when, readings);
  };
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  read("before the feedback");
  gl.BeginTransformFeedback(GL_TRIANGLES);
  read("before the first draw");
  for (const char* const when : {"after a draw", "after two draws"}) {
    draw();
    read(when);
  }
  gl.PauseTransformFeedback();
  read("while it is paused");
  draw();
  read("after a draw while it is paused");
  gl.ResumeTransformFeedback();
  read("after it is resumed");
  draw();
  read("after the last draw");
  gl.EndTransformFeedback();
  read("after the feedback");
  return readings;
}

void expect_same(Test& t, const Readings& refined, const Readings& plain) {
  t.require(refined.size() == plain.size(), "the same state is read");
  for (std::size_t i = 0; i < plain.size(); ++i) t.expect_equal(refined[i].second, plain[i].second, plain[i].first);
  t.expect_no_error("the queries");
}

void check_feedback_state(Test& t, const TypedQuery& query, bool has_object) {
  gl.UseProgram(capture_program(t));
  upload(one_triangle());
  GLuint feedback = 0;
  if (has_object) {
    gl.GenTransformFeedbacks(1, &feedback);
    gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback);
  }
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, feedback_bytes, nullptr, GL_STREAM_READ);
  refine_uniformly(1);
  gl.Disable(GL_ARK);
  const Readings plain = readings_of_feedback(t, query, feedback);
  gl.Enable(GL_ARK);
  for (int again = 0; again < 2; ++again) expect_same(t, readings_of_feedback(t, query, feedback), plain);
}

Readings readings_of_list(const Test& t, const TypedQuery& query, GLenum mode) {
  Readings readings;
  const auto triangle = [] {
    gl.Begin(GL_TRIANGLES);
    for (const GLfloat x : {-0.5F, 0.5F, 0.0F}) gl.Vertex2f(x, x * x);
    gl.End();
  };
  read_state(t, query, "before the list", readings);
  gl.NewList(3, mode);
  read_state(t, query, "in an empty list", readings);
  gl.Color3f(1, 0, 0);
  triangle();
  read_state(t, query, "after a triangle in the list", readings);
  gl.CallList(7);
  triangle();
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  read_state(t, query, "after a call and an array in the list", readings);
  gl.EndList();
  read_state(t, query, "after the list", readings);
  gl.CallList(3);
  read_state(t, query, "after the call of the list", readings);
  return readings;
}

void check_list_state(Test& t, const TypedQuery& query) {
  gl.UseProgram(colour_program(t));
  upload(one_triangle());
  refine_uniformly(1);
  gl.NewList(7, GL_COMPILE);
  gl.Color3f(0, 1, 0);
  gl.EndList();
  gl.ListBase(11);
  for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE}) {
    gl.Disable(GL_ARK);
    const Readings plain = readings_of_list(t, query, mode);
    gl.Enable(GL_ARK);
    for (int again = 0; again < 2; ++again) expect_same(t, readings_of_list(t, query, mode), plain);
  }
}

}  // namespace

Cases typed_queries_cases() {
  Cases cases;
  for (const TypedQuery& query : typed_queries) {
    const Apis apis = query.is_desktop ? desktop_apis : every_api;
    for (const bool has_object : {false, true})
      cases.push_back({.name = fmt::format("ark.query.feedback.{}.{}", query.leaf, has_object ? "object" : "default"),
                       .clauses = {"10.R.2-6", "chapter-14-5"},
                       .plan = "Capture refined draws, and between them read state by this query: as between unrefined "
                               "ones.",
                       .wrong = "The feedback counts as paused between draws, by this query or by all.",
                       .apis = apis,
                       .check = [&query, has_object](Test& t) { check_feedback_state(t, query, has_object); }});
    cases.push_back({.name = fmt::format("ark.query.list.{}", query.leaf),
                     .clauses = {"10.R.2-6", "chapter-21-4"},
                     .plan = "Compile lists with draws, and between them read state by this query: as while ARK is "
                             "disabled.",
                     .wrong = "The name or the mode of another list, which the implementation compiles instead.",
                     .apis = compat_only,
                     .check = [&query](Test& t) { check_list_state(t, query); }});
  }
  return cases;
}

}  // namespace glark::conformance
