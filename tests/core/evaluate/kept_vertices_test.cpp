// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Counts the draws that use kept refined vertices. Links the core without the shim, so that each test has its own options
// and reads the counters.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <vector>

#include "glark/core/context.h"
#include "glark/core/report/statistics.h"
#include "glark/core/stages.h"
#include "glark/gl/hooks.h"
#include "tests/core/support/plain_context.h"

namespace glark::core::test {
namespace {

class KeptVerticesCounted : public testing::Test {
 protected:
  KeptVerticesCounted() { start({}); }
  ~KeptVerticesCounted() override { context_->release(); }

  void start(ContextOptions options) {
    if (context_ != nullptr) context_->release();
    options.transparent = true;
    options.level = 2;
    context_ = Context::create(window_.gl, make_share_group(), options);
  }
  // A buffer with that many triangles.
  GLuint make_triangles(int triangles) {
    GLuint buffer = 0;
    const std::vector<GLfloat> corners(static_cast<std::size_t>(triangles) * 9, 0.25F);
    window_.gl.GenBuffers(1, &buffer);
    hook::BindBuffer(*context_, GL_ARRAY_BUFFER, buffer);
    window_.gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(GLfloat)), corners.data(),
                          GL_STATIC_DRAW);
    return buffer;
  }
  void write(GLuint buffer) {
    const std::array<GLfloat, 3> corner{0.5F, 0.5F, 0.5F};
    hook::BindBuffer(*context_, GL_ARRAY_BUFFER, buffer);
    window_.gl.BufferSubData(GL_ARRAY_BUFFER, 0, sizeof(corner), corner.data());
    context_->writes().to_target(GL_ARRAY_BUFFER);
  }
  void draw(GLuint buffer, int triangles) {
    hook::Enable(*context_, GL_DEPTH_TEST);
    hook::BindBuffer(*context_, GL_ARRAY_BUFFER, buffer);
    hook::VertexPointer(*context_, 3, GL_FLOAT, 0, nullptr);
    hook::EnableClientState(*context_, GL_VERTEX_ARRAY);
    hook::DrawArrays(*context_, GL_TRIANGLES, 0, 3 * triangles);
  }
  // Draws that many frames. Returns how many of the draws had kept vertices.
  std::uint64_t kept_of(int frames, GLuint buffer, int triangles) {
    const std::uint64_t before = statistics().draws_of_kept_vertices;
    for (int frame = 0; frame < frames; ++frame) {
      draw(buffer, triangles);
      context_->frame_finished();
    }
    EXPECT_EQ(window_.gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    return statistics().draws_of_kept_vertices - before;
  }

  // The memory of one draw of 20 triangles. Each has 15 vertices (position and colour) and 48 indices.
  static constexpr std::uint64_t budget_of_one = 20 * (15 * 8 * sizeof(GLfloat) + 48 * sizeof(GLuint));

  PlainContext window_;
  std::unique_ptr<Context> context_;
};

// The first frame captures, the second one keeps the capture, and four frames reuse it.
TEST_F(KeptVerticesCounted, FromTheSixthFrameOn) {
  const GLuint buffer = make_triangles(20);
  EXPECT_EQ(kept_of(5, buffer, 20), 0U);
  const std::uint64_t refined = statistics().refined_triangles;
  EXPECT_EQ(kept_of(3, buffer, 20), 3U);
  EXPECT_EQ(statistics().refined_triangles, refined + 3 * 20 * 16);
}

TEST_F(KeptVerticesCounted, ProgramsWithoutFramesRepeatMoreOften) {
  const GLuint buffer = make_triangles(20);
  const std::uint64_t before = statistics().draws_of_kept_vertices;
  for (int i = 0; i < 19; ++i) draw(buffer, 20);
  EXPECT_EQ(statistics().draws_of_kept_vertices, before);
  for (int i = 0; i < 5; ++i) draw(buffer, 20);
  EXPECT_EQ(statistics().draws_of_kept_vertices, before + 5);
}

TEST_F(KeptVerticesCounted, NotWhereTheBufferChangesInEveryFrame) {
  const GLuint buffer = make_triangles(20);
  for (int frame = 0; frame < 12; ++frame) {
    write(buffer);
    EXPECT_EQ(kept_of(1, buffer, 20), 0U);
  }
}

TEST_F(KeptVerticesCounted, AWriteDropsThem) {
  const GLuint buffer = make_triangles(20);
  EXPECT_GT(kept_of(6, buffer, 20), 0U);
  write(buffer);
  EXPECT_EQ(kept_of(5, buffer, 20), 0U);
  EXPECT_GT(kept_of(2, buffer, 20), 0U);
}

TEST_F(KeptVerticesCounted, NoMoreThanTheUserAllows) {
  constexpr std::uint64_t bytes = budget_of_one;
  for (const std::uint64_t most : {std::uint64_t{0}, bytes - 1, bytes}) {
    start({.kept_vertex_bytes = most});
    EXPECT_EQ(kept_of(6, make_triangles(20), 20) > 0, most == bytes) << most;
  }
}

// The vertices of a draw that is no longer repeated make room.
TEST_F(KeptVerticesCounted, OldOnesMakeRoom) {
  start({.kept_vertex_bytes = budget_of_one});
  const GLuint old = make_triangles(20);
  EXPECT_GT(kept_of(6, old, 20), 0U);
  EXPECT_GT(kept_of(12, make_triangles(20), 20), 0U);
  EXPECT_EQ(kept_of(1, old, 20), 0U);
}

// Two levels in turn would be evaluated again for each draw.
TEST_F(KeptVerticesCounted, NotWhereTheLevelAlternates) {
  const GLuint buffer = make_triangles(20);
  for (int frame = 0; frame < 24; ++frame) {
    context_->options().level = 2 + frame % 2;
    EXPECT_EQ(kept_of(1, buffer, 20), 0U);
  }
}

// The evaluation would count in the query.
TEST_F(KeptVerticesCounted, NotMadeDuringAQuery) {
  const GLuint buffer = make_triangles(20);
  GLuint query = 0;
  window_.gl.GenQueries(1, &query);
  hook::BeginQuery(*context_, GL_PRIMITIVES_GENERATED, query);
  EXPECT_EQ(kept_of(8, buffer, 20), 0U);
  hook::EndQuery(*context_, GL_PRIMITIVES_GENERATED);
  EXPECT_EQ(kept_of(8, buffer, 20) > 0, true);
}

}  // namespace
}  // namespace glark::core::test
