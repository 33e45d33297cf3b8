// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Several transform feedback objects, each of which captures while the others are paused.
#include <fmt/core.h>

#include <array>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

constexpr std::size_t feedback_objects = 3;
constexpr GLsizei most_vertices = 4096;
constexpr GLuint object_level = 2;
constexpr std::size_t object_refined = 1U << (2 * object_level);
constexpr float untouched = -77;

// Each captures what is drawn while it is bound and not paused.
struct Captures {
  std::array<GLuint, feedback_objects> names{};
  std::array<GLuint, feedback_objects> buffers{};
};

Captures make_captures() {
  Captures made;
  gl.GenTransformFeedbacks(feedback_objects, made.names.data());
  gl.GenBuffers(feedback_objects, made.buffers.data());
  const std::vector<CapturedVertex> empty(most_vertices, CapturedVertex{{0, 0, 0, 0}, {0, 0, 0}, untouched});
  for (std::size_t i = 0; i < feedback_objects; ++i) {
    gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, made.names[i]);
    gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, made.buffers[i]);
    gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, static_cast<GLsizeiptr>(empty.size() * sizeof(CapturedVertex)),
                  empty.data(), GL_DYNAMIC_READ);
  }
  return made;
}

// The coarse triangles of the captured ones, in order, each run of equal ones once; then how many there are.
std::string captured_text(GLuint buffer) {
  std::vector<CapturedVertex> vertices(most_vertices);
  gl.BindBuffer(GL_COPY_READ_BUFFER, buffer);
  const auto bytes = static_cast<GLsizeiptr>(vertices.size() * sizeof(CapturedVertex));
  std::memcpy(vertices.data(), gl.MapBufferRange(GL_COPY_READ_BUFFER, 0, bytes, GL_MAP_READ_BIT),
              static_cast<std::size_t>(bytes));
  gl.UnmapBuffer(GL_COPY_READ_BUFFER);
  std::string text;
  float last = untouched;
  std::size_t count = 0;
  for (const CapturedVertex& vertex : vertices) {
    if (vertex.triangle == untouched) break;
    if (vertex.triangle != last) text += fmt::format("{:.0f} ", vertex.triangle);
    last = vertex.triangle;
    ++count;
  }
  return text + fmt::format("({} triangles)", count / 3);
}

std::string text_of_triangles(const std::vector<int>& triangles) {
  std::string text;
  for (const int each : triangles) text += fmt::format("{} ", each);
  return text + fmt::format("({} triangles)", triangles.size() * object_refined);
}

// Steps, each a letter and the number of an object: b begins its feedback, d draws, p pauses, r resumes, e ends it.
struct ObjectOrder {
  const char* leaf;
  std::string_view steps;
};
constexpr ObjectOrder object_orders[] = {
    {"second_ends_first", "b0 d0 p0 b1 d1 e1 r0 d0 e0"},
    {"interleaved", "b0 d0 p0 b1 d1 p1 r0 d0 e0 r1 d1 e1"},
    {"nothing_before_pause", "b0 p0 b1 p1 r0 d0 p0 r1 d1 e1 e0"},
    {"three", "b0 d0 p0 b1 d1 p1 b2 d2 e2 r1 d1 p1 r0 d0 e0 e1 b2 d2 e2"},
};

// `is_aside`: while the feedback is paused, something else is drawn that nobody captures.
void check_order(Test& t, const ObjectOrder& order, bool is_aside) {
  gl.UseProgram(capture_program(t));
  Mesh mesh;
  for (int i = 0; i < 20; ++i)
    for (const MeshVertex& vertex : one_triangle()) mesh.push_back(vertex);
  number_triangles(mesh);
  upload(mesh, false);
  const Captures captures = make_captures();
  refine_uniformly(object_level);
  std::array<std::vector<int>, feedback_objects> expected;
  int next = 0;
  const auto draw = [](int triangle) { gl.DrawArrays(GL_TRIANGLES, 3 * triangle, 3); };
  std::size_t bound = feedback_objects;
  for (std::size_t at = 0; at < order.steps.size(); at += 3) {
    const char step = order.steps[at];
    const auto object = static_cast<std::size_t>(order.steps[at + 1] - '0');
    if (bound != object) gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, captures.names[object]);
    bound = object;
    if (step == 'b') {
      expected[object].clear();
      gl.BeginTransformFeedback(GL_TRIANGLES);
    }
    if (step == 'd') {
      expected[object].push_back(next);
      draw(next++);
    }
    if (step == 'p') {
      gl.PauseTransformFeedback();
      if (is_aside) draw(19);
    }
    if (step == 'r') gl.ResumeTransformFeedback();
    if (step == 'e') gl.EndTransformFeedback();
    t.expect_no_error("step " + std::string(order.steps.substr(at, 2)));
    GLint state[2] = {};
    gl.GetIntegerv(GL_TRANSFORM_FEEDBACK_ACTIVE, &state[0]);
    gl.GetIntegerv(GL_TRANSFORM_FEEDBACK_PAUSED, &state[1]);
    t.expect_equal(state[0] != 0, step != 'e', "the object is active");
    t.expect_equal(state[1] != 0, step == 'p', "the object is paused");
  }
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
  for (std::size_t i = 0; i < feedback_objects; ++i)
    t.expect_equal(captured_text(captures.buffers[i]), text_of_triangles(expected[i]), fmt::format("object {}", i));
}

}  // namespace

Cases two_objects_cases() {
  Cases cases;
  for (const ObjectOrder& order : object_orders)
    for (const bool is_aside : {false, true})
      cases.push_back({.name = fmt::format("ark.after_vertex.objects.{}.{}", order.leaf, is_aside ? "aside" : "alone"),
                       .clauses = {"chapter-14-5", "10.R.2-13"},
                       .plan = "Feedback objects take turns; each captures its refined triangles.",
                       .wrong = "ResumeTransformFeedback is refused, or one object captures the triangles of another.",
                       .check = [&order, is_aside](Test& t) { check_order(t, order, is_aside); }});
  return cases;
}

}  // namespace glark::conformance
