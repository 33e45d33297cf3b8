// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Several transform feedback feedback_objects, each of which captures while the others are paused.
#include <fmt/core.h>

#include <array>
#include <cstring>
#include <string>
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

// A step on an object. Names are those of GL's commands.
enum class ObjectCall { begin, draw, pause, resume, end };
struct ObjectStep {
  std::size_t object;
  ObjectCall what;
};

struct ObjectOrder {
  const char* leaf;
  std::vector<ObjectStep> steps;
};

const std::vector<ObjectOrder>& object_orders() {
  static const std::vector<ObjectOrder> all = {
      {"second_ends_first",
       {{0, ObjectCall::begin},
        {0, ObjectCall::draw},
        {0, ObjectCall::pause},
        {1, ObjectCall::begin},
        {1, ObjectCall::draw},
        {1, ObjectCall::end},
        {0, ObjectCall::resume},
        {0, ObjectCall::draw},
        {0, ObjectCall::end}}},
      {"interleaved",
       {{0, ObjectCall::begin},
        {0, ObjectCall::draw},
        {0, ObjectCall::pause},
        {1, ObjectCall::begin},
        {1, ObjectCall::draw},
        {1, ObjectCall::pause},
        {0, ObjectCall::resume},
        {0, ObjectCall::draw},
        {0, ObjectCall::end},
        {1, ObjectCall::resume},
        {1, ObjectCall::draw},
        {1, ObjectCall::end}}},
      {"nothing_before_pause",
       {{0, ObjectCall::begin},
        {0, ObjectCall::pause},
        {1, ObjectCall::begin},
        {1, ObjectCall::pause},
        {0, ObjectCall::resume},
        {0, ObjectCall::draw},
        {0, ObjectCall::pause},
        {1, ObjectCall::resume},
        {1, ObjectCall::draw},
        {1, ObjectCall::end},
        {0, ObjectCall::end}}},
      {"three",
       {{0, ObjectCall::begin},
        {0, ObjectCall::draw},
        {0, ObjectCall::pause},
        {1, ObjectCall::begin},
        {1, ObjectCall::draw},
        {1, ObjectCall::pause},
        {2, ObjectCall::begin},
        {2, ObjectCall::draw},
        {2, ObjectCall::end},
        {1, ObjectCall::resume},
        {1, ObjectCall::draw},
        {1, ObjectCall::pause},
        {0, ObjectCall::resume},
        {0, ObjectCall::draw},
        {0, ObjectCall::end},
        {1, ObjectCall::end},
        {2, ObjectCall::begin},
        {2, ObjectCall::draw},
        {2, ObjectCall::end}}},
  };
  return all;
}

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
  for (const ObjectStep& step : order.steps) {
    if (bound != step.object) gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, captures.names[step.object]);
    bound = step.object;
    switch (step.what) {
      case ObjectCall::begin:
        expected[step.object].clear();
        gl.BeginTransformFeedback(GL_TRIANGLES);
        break;
      case ObjectCall::draw:
        expected[step.object].push_back(next);
        draw(next++);
        break;
      case ObjectCall::pause:
        gl.PauseTransformFeedback();
        if (is_aside) draw(19);
        break;
      case ObjectCall::resume: gl.ResumeTransformFeedback(); break;
      case ObjectCall::end: gl.EndTransformFeedback(); break;
    }
    t.expect_no_error(fmt::format("step {} of object {}", static_cast<int>(step.what), step.object));
    GLint state[2] = {};
    gl.GetIntegerv(GL_TRANSFORM_FEEDBACK_ACTIVE, &state[0]);
    gl.GetIntegerv(GL_TRANSFORM_FEEDBACK_PAUSED, &state[1]);
    t.expect_equal(state[0] != 0, step.what != ObjectCall::end, "the object is active");
    t.expect_equal(state[1] != 0, step.what == ObjectCall::pause, "the object is paused");
  }
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
  for (std::size_t i = 0; i < feedback_objects; ++i)
    t.expect_equal(captured_text(captures.buffers[i]), text_of_triangles(expected[i]), fmt::format("object {}", i));
}

}  // namespace

Cases two_objects_cases() {
  Cases cases;
  for (const ObjectOrder& order : object_orders())
    for (const bool is_aside : {false, true})
      cases.push_back({.name = fmt::format("ark.after_vertex.objects.{}.{}", order.leaf, is_aside ? "aside" : "alone"),
                       .clauses = {"chapter-14-5", "10.R.2-13"},
                       .plan = "Feedback feedback_objects take turns; each captures its refined triangles.",
                       .wrong = "ResumeTransformFeedback is refused, or one object captures the triangles of another.",
                       .check = [&order, is_aside](Test& t) { check_order(t, order, is_aside); }});
  return cases;
}

}  // namespace glark::conformance
