// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Display lists on a driver like NVIDIA's (580): it compiles no instanced draws, and it refuses to call an empty list
// during transform feedback.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <set>

#include "glark/core/context.h"
#include "glark/core/report/statistics.h"
#include "glark/gl/hooks.h"
#include "tests/core/support/plain_context.h"

namespace glark::core::test {
namespace {

const gl::Dispatch* real = nullptr;
GLuint open_list = 0;
std::set<GLuint> lists_that_draw;

constexpr GLenum no_such_name = 0xBAD;
void refuse() { real->GetString(no_such_name); }  // GL_INVALID_ENUM, also while a list is compiled

void new_list(GLuint list, GLenum mode) {
  open_list = list;
  lists_that_draw.erase(list);
  real->NewList(list, mode);
}
void end_list() {
  open_list = 0;
  real->EndList();
}
void draw_arrays(GLenum mode, GLint first, GLsizei count) {
  lists_that_draw.insert(open_list);
  real->DrawArrays(mode, first, count);
}
void draw_arrays_instanced(GLenum mode, GLint first, GLsizei count, GLsizei instances) {
  open_list != 0 ? refuse() : real->DrawArraysInstanced(mode, first, count, instances);
}
void call_list(GLuint list) {
  GLboolean active = GL_FALSE;
  GLboolean paused = GL_FALSE;
  real->GetBooleanv(GL_TRANSFORM_FEEDBACK_ACTIVE, &active);
  real->GetBooleanv(GL_TRANSFORM_FEEDBACK_PAUSED, &paused);
  const bool captures = active != GL_FALSE && paused == GL_FALSE;
  open_list == 0 && captures && !lists_that_draw.contains(list) ? refuse() : real->CallList(list);
}

class RefusedCalls : public testing::Test {
 protected:
  RefusedCalls() : strange_(window_.gl) {
    real = &window_.gl;
    lists_that_draw.clear();
    strange_.NewList = new_list;
    strange_.EndList = end_list;
    strange_.DrawArrays = draw_arrays;
    strange_.DrawArraysInstanced = draw_arrays_instanced;
    strange_.CallList = call_list;
    options_.transparent = true;
    options_.level = 2;
    options_.refinement = Refinement::linear_outputs;
    options_.left_draws = 0;
    context_ = Context::create(strange_, make_share_group(), options_);
    window_.gl.EnableClientState(GL_VERTEX_ARRAY);
    window_.gl.VertexPointer(2, GL_FLOAT, 0, corners_.data());
  }
  ~RefusedCalls() override {
    context_->release();
    context_.reset();
  }
  GLenum error() { return hook::GetError(*context_); }

  // A program that captures its positions into a buffer.
  void use_capturing_program() {
    const char* const source = "void main() { gl_Position = gl_Vertex; }\n";
    const char* const captured = "gl_Position";
    const GLuint shader = real->CreateShader(GL_VERTEX_SHADER);
    const GLuint program = real->CreateProgram();
    GLuint buffer = 0;
    real->ShaderSource(shader, 1, &source, nullptr);
    hook::CompileShader(*context_, shader);
    real->AttachShader(program, shader);
    real->TransformFeedbackVaryings(program, 1, &captured, GL_INTERLEAVED_ATTRIBS);
    hook::LinkProgram(*context_, program);
    hook::UseProgram(*context_, program);
    real->GenBuffers(1, &buffer);
    real->BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
    real->BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 4096, nullptr, GL_DYNAMIC_COPY);
    context_->state().forget_bindings();
  }

  const std::array<GLfloat, 6> corners_{-1, -1, 1, -1, 0, 1};
  PlainContext window_;
  gl::Dispatch strange_;
  ContextOptions options_;
  std::unique_ptr<Context> context_;
};

// ARB_draw_instanced: the error is raised while the list is compiled, and the list stays empty.
TEST_F(RefusedCalls, DrawsAreNotInTheList) {
  hook::NewList(*context_, 1, GL_COMPILE);
  hook::DrawArraysInstanced(*context_, GL_TRIANGLES, 0, 3, 2);
  EXPECT_EQ(error(), static_cast<GLenum>(GL_INVALID_ENUM));
  EXPECT_EQ(error(), static_cast<GLenum>(GL_NO_ERROR));
  hook::EndList(*context_);
  const std::uint64_t seen = statistics().draws_seen;
  hook::CallList(*context_, 1);
  EXPECT_EQ(error(), static_cast<GLenum>(GL_NO_ERROR));
  EXPECT_EQ(statistics().draws_seen, seen);
}

TEST_F(RefusedCalls, ListsAreCalledDuringFeedback) {
  use_capturing_program();
  hook::NewList(*context_, 1, GL_COMPILE);
  hook::DrawArrays(*context_, GL_TRIANGLES, 0, 3);
  hook::EndList(*context_);
  GLuint query = 0;
  GLuint triangles = 0;
  real->GenQueries(1, &query);
  real->BeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, query);
  hook::BeginTransformFeedback(*context_, GL_TRIANGLES);
  hook::CallList(*context_, 1);
  EXPECT_EQ(error(), static_cast<GLenum>(GL_NO_ERROR));
  hook::EndTransformFeedback(*context_);
  real->EndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
  real->GetQueryObjectuiv(query, GL_QUERY_RESULT, &triangles);
  EXPECT_EQ(triangles, 1U);
}

}  // namespace
}  // namespace glark::core::test
