// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// An attribute with a divisor is the same at all corners of a triangle. A vertex stage that uses it as a number runs
// between the corners, but only while the array has the divisor.
#include <gtest/gtest.h>

#include <memory>

#include "glark/core/context.h"
#include "glark/gl/hooks.h"
#include "tests/core/support/plain_context.h"

namespace glark::core::test {
namespace {

constexpr char vertex[] =
    "#version 430\nlayout(location = 0) in vec4 p; layout(location = 3) in int place;\n"
    "uniform vec4 places[4];\nvoid main() { gl_Position = p + places[place]; }\n";
constexpr char fragment[] = "#version 430\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n";

class InstancedDraws : public testing::Test {
 public:
  InstancedDraws(const InstancedDraws&) = delete;
  InstancedDraws& operator=(const InstancedDraws&) = delete;

 protected:
  InstancedDraws()
      : context_(Context::create(plain_.gl, make_share_group(),
                                 ContextOptions{.transparent = true, .level = 1, .left_draws = 0})) {
    const GLuint program = plain_.gl.CreateProgram();
    for (const auto& [stage, text] : {std::pair(GL_VERTEX_SHADER, vertex), std::pair(GL_FRAGMENT_SHADER, fragment)}) {
      const GLuint shader = plain_.gl.CreateShader(static_cast<GLenum>(stage));
      plain_.gl.ShaderSource(shader, 1, &text, nullptr);
      hook::CompileShader(*context_, shader);
      plain_.gl.AttachShader(program, shader);
    }
    hook::LinkProgram(*context_, program);
    hook::UseProgram(*context_, program);
    plain_.gl.VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, corners_);
    plain_.gl.VertexAttribIPointer(3, 1, GL_INT, 0, places_);
    plain_.gl.EnableVertexAttribArray(0);
    plain_.gl.EnableVertexAttribArray(3);
  }
  ~InstancedDraws() override { context_->release(); }

  // Returns whether the stage ran between the corners.
  bool runs_between_corners(GLuint divisor) {
    plain_.gl.VertexAttribDivisor(3, divisor);
    context_->state().arrays().vertex_arrays().forget_current();
    const auto unsound = static_cast<std::size_t>(RefinementFallback::unsound_stage);
    const std::uint64_t refined = statistics().draws_refined;
    const std::uint64_t fallen_back = statistics().fallen_back[unsound];
    hook::DrawArraysInstanced(*context_, GL_TRIANGLES, 0, 3, 4);
    EXPECT_EQ(statistics().draws_refined, refined + 1);
    return statistics().fallen_back[unsound] == fallen_back;
  }

 private:
  PlainContext plain_;
  std::unique_ptr<Context> context_;
  GLfloat corners_[12] = {-1, -1, 0, 1, 1, -1, 0, 1, 0, 1, 0, 1};
  GLint places_[4] = {3, 2, 1, 0};
};

TEST_F(InstancedDraws, AreConstantWhileTheyHaveADivisor) {
  EXPECT_FALSE(runs_between_corners(0));
  EXPECT_TRUE(runs_between_corners(1));
  EXPECT_TRUE(runs_between_corners(2));
  EXPECT_FALSE(runs_between_corners(0));
}

}  // namespace
}  // namespace glark::core::test
