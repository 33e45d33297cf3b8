// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Handles of bindless textures reach programs that are derived later. No software renderer has bindless textures, so
// the test notes the calls.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "glark/core/context.h"
#include "glark/core/report/statistics.h"
#include "glark/gl/hooks.h"
#include "tests/core/support/plain_context.h"

namespace glark::core::test {
namespace {

using Handles = std::vector<std::pair<GLuint, GLuint64>>;  // program, handle
Handles handles_set;

void set_handle(GLuint program, GLint location, GLuint64 handle) {
  if (location >= 0) handles_set.emplace_back(program, handle);
}

class BindlessHandles : public testing::Test {
 protected:
  BindlessHandles() : bindless_(window_.gl) {
    handles_set.clear();
    bindless_.ProgramUniformHandleui64ARB = set_handle;
    options_.transparent = true;
    options_.level = 1;
    options_.refinement = Refinement::linear_outputs;
    options_.left_draws = 0;
    context_ = Context::create(bindless_, make_share_group(), options_);
    attach(GL_VERTEX_SHADER, "void main() { gl_Position = gl_Vertex; }\n");
    attach(GL_FRAGMENT_SHADER,
           "uniform sampler2D images[2];\n"
           "void main() { gl_FragColor = texture2D(images[0], vec2(0.5)) + texture2D(images[1], vec2(0.5)); }\n");
    link();
    window_.gl.EnableClientState(GL_VERTEX_ARRAY);
    window_.gl.VertexPointer(2, GL_FLOAT, 0, corners_.data());
  }
  ~BindlessHandles() override {
    context_->release();
    context_.reset();
  }
  void attach(GLenum stage, const char* source) {
    const GLuint shader = window_.gl.CreateShader(stage);
    window_.gl.ShaderSource(shader, 1, &source, nullptr);
    hook::CompileShader(*context_, shader);
    window_.gl.AttachShader(program_, shader);
  }
  void link() {
    hook::LinkProgram(*context_, program_);
    hook::UseProgram(*context_, program_);
  }
  GLint location() { return window_.gl.GetUniformLocation(program_, "images[0]"); }
  Handles draw() {
    const std::uint64_t before = statistics().draws_refined;
    hook::DrawArrays(*context_, GL_TRIANGLES, 0, 3);
    EXPECT_EQ(statistics().draws_refined, before + 1);
    return std::exchange(handles_set, {});
  }
  // Every program that was derived has both handles.
  static void expect_both(const Handles& set, GLuint64 first, GLuint64 second) {
    ASSERT_FALSE(set.empty());
    ASSERT_EQ(set.size() % 2, 0U);
    for (std::size_t i = 0; i < set.size(); i += 2) {
      EXPECT_EQ(set[i].second, first);
      EXPECT_EQ(set[i + 1].second, second);
      EXPECT_EQ(set[i].first, set[i + 1].first);
    }
  }

  const std::array<GLfloat, 6> corners_{-1, -1, 1, -1, 0, 1};
  const std::array<GLuint64, 2> values_{0x100000A00, 0x100000B00};
  PlainContext window_;
  gl::Dispatch bindless_;
  ContextOptions options_;
  std::unique_ptr<Context> context_;
  GLuint program_ = window_.gl.CreateProgram();
};

TEST_F(BindlessHandles, OfTheProgramInUse) {
  context_->state().programs().set_handles(context_->state().bindings(), location(), 2, values_.data());
  const Handles set = draw();
  expect_both(set, values_[0], values_[1]);
  for (const auto& [program, handle] : set) EXPECT_NE(program, program_);
}

TEST_F(BindlessHandles, OfANamedProgram) {
  hook::UseProgram(*context_, 0);
  context_->state().programs().set_handles(context_->state().bindings(), program_, location(), 2, values_.data());
  hook::UseProgram(*context_, program_);
  expect_both(draw(), values_[0], values_[1]);
}

TEST_F(BindlessHandles, EndWithTheNextLink) {
  context_->state().programs().set_handles(context_->state().bindings(), location(), 2, values_.data());
  link();
  EXPECT_TRUE(draw().empty());
}

TEST_F(BindlessHandles, OfNoUniformAreIgnored) {
  context_->state().programs().set_handles(context_->state().bindings(), -1, 2, values_.data());
  EXPECT_TRUE(draw().empty());
}

}  // namespace
}  // namespace glark::core::test
