// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// DrawTransformFeedback and its relatives, with so many captured triangles or instances that an implementation cannot
// have room for all of them by chance.
#include <fmt/core.h>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

struct FeedbackCommand {
  const char* leaf;
  void (*draw)(GLuint object, GLsizei instances);
  bool is_instanced;
};

constexpr FeedbackCommand feedback_commands[] = {
    {"plain", [](GLuint object, GLsizei) { gl.DrawTransformFeedback(GL_TRIANGLES, object); }, false},
    {"instanced", [](GLuint object, GLsizei n) { gl.DrawTransformFeedbackInstanced(GL_TRIANGLES, object, n); }, true},
    {"stream", [](GLuint object, GLsizei) { gl.DrawTransformFeedbackStream(GL_TRIANGLES, object, 0); }, false},
    {"stream_instanced",
     [](GLuint object, GLsizei n) { gl.DrawTransformFeedbackStreamInstanced(GL_TRIANGLES, object, 0, n); }, true}};

// Captures so many triangles, and makes them the array of positions.
GLuint capture_triangles(Test& t, GLsizei triangles) {
  gl.UseProgram(build_program(t, {.vertex = "layout(location = 0) in vec4 position; out vec4 colour; out vec4 place;\n"
                                            "void main() { place = position; colour = vec4(1.0);\n"
                                            "  gl_Position = position; }\n",
                                  .captured = {"place"}}));
  gl.Disable(GL_ARK);
  upload(one_triangle(), false);
  GLuint object = 0;
  GLuint buffer = 0;
  GLuint array = 0;
  gl.GenTransformFeedbacks(1, &object);
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, object);
  gl.GenBuffers(1, &buffer);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, GLsizeiptr{3} * triangles * static_cast<GLsizeiptr>(sizeof(Vec4)),
                nullptr, GL_STATIC_DRAW);
  gl.Enable(GL_RASTERIZER_DISCARD);
  gl.BeginTransformFeedback(GL_TRIANGLES);
  gl.DrawArraysInstanced(GL_TRIANGLES, 0, 3, triangles);
  gl.EndTransformFeedback();
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
  gl.GenVertexArrays(1, &array);
  gl.BindVertexArray(array);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.VertexAttribPointer(at_position, 4, GL_FLOAT, GL_FALSE, sizeof(Vec4), nullptr);
  gl.EnableVertexAttribArray(at_position);
  return object;
}

void check_feedback_command(Test& t, const FeedbackCommand& command, bool is_uniform) {
  for (const auto& [triangles, instances] :
       {std::pair<GLsizei, GLsizei>{3, 1}, {20000, 1}, {20000, 5}, {2, 40000}, {1, 3}, {20000, 2}}) {
    if (instances > 1 && !command.is_instanced) continue;
    const GLuint object = capture_triangles(t, triangles);
    is_uniform ? refine_uniformly(1) : refine_by_tags(1);
    gl.DepthTag1i(1);
    for (int again = 0; again < 2; ++again)
      t.expect_equal(count_generated([&, count = instances] { command.draw(object, count); }),
                     static_cast<GLuint>(4 * triangles * instances),
                     fmt::format("{} instances of {}", instances, triangles));
    gl.DeleteTransformFeedbacks(1, &object);
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases many_instances_cases() {
  Cases cases;
  for (const FeedbackCommand& command : feedback_commands)
    for (const bool is_uniform : {true, false})
      cases.push_back({.name = std::string("ark.feedback.many.") + command.leaf + (is_uniform ? ".uniform" : ".tags"),
                       .clauses = {"10.R.2-2"},
                       .plan =
                           "Draw 20 000 captured triangles several times in one command, and few triangles in 40 000 "
                           "instances; count the refined triangles.",
                       .wrong = "As many as there was memory for; one instance.",
                       .apis = desktop_apis,
                       .check = [&command, is_uniform](Test& t) { check_feedback_command(t, command, is_uniform); }});
  return cases;
}

}  // namespace glark::conformance
