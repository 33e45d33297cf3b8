// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The limits of the cache, over a GL that only hands out names.
#include "glark/core/keep/draw_cache.h"

#include <gtest/gtest.h>

#include <memory>

namespace glark::core {
namespace {

constexpr GLsizeiptr megabyte = GLsizeiptr{1} << 20;
int buffers_alive = 0;

gl::Dispatch names_only() {
  gl::Dispatch gl;
  gl.GenBuffers = [](GLsizei, GLuint* name) { *name = static_cast<GLuint>(++buffers_alive); };
  gl.DeleteBuffers = [](GLsizei, const GLuint*) { --buffers_alive; };
  gl.BindBuffer = [](GLenum, GLuint) {};
  gl.BufferData = [](GLenum, GLsizeiptr, const void*, GLenum) {};
  gl.GetString = [](GLenum) -> const GLubyte* { return nullptr; };
  gl.GetIntegerv = [](GLenum name, GLint* value) {
    *value = name == GL_CONTEXT_PROFILE_MASK ? GL_CONTEXT_CORE_PROFILE_BIT : 0;
  };
  gl.GetError = []() -> GLenum { return GL_NO_ERROR; };
  return gl;
}

class DrawCacheBounds : public testing::Test {
 protected:
  DrawCacheBounds() { buffers_alive = 0; }
  DrawCache::Answer draw(std::uint64_t number) {
    DrawKey key;
    key.add(number);
    const auto [answer, entry] = cache_.look_up(gl_, key, *stamps_);
    last_ = entry;
    return answer;
  }
  bool keep(std::uint64_t number, GLsizeiptr bytes) {
    while (draw(number) == DrawCache::Answer::fresh) {
    }
    last_->filled = cache_.make_room(gl_, *last_, bytes) && cache_.allocate(gl_, *last_, bytes);
    return last_->filled;
  }

  gl::Dispatch gl_ = names_only();
  std::unique_ptr<BufferStamps> stamps_ = std::make_unique<BufferStamps>();
  DrawCache cache_;
  DrawCache::Entry* last_ = nullptr;
};

TEST_F(DrawCacheBounds, DrawsInTurnDoNotPushOneAnotherOut) {
  for (std::uint64_t number = 0; number < 4; ++number) EXPECT_TRUE(keep(number, 60 * megabyte));
  for (int turn = 0; turn < 3; ++turn) {
    EXPECT_FALSE(keep(4, 60 * megabyte));
    for (std::uint64_t number = 0; number < 4; ++number) EXPECT_EQ(draw(number), DrawCache::Answer::kept);
  }
}

TEST_F(DrawCacheBounds, WhatIsNoLongerDrawnMakesRoom) {
  for (std::uint64_t number = 0; number < 4; ++number) EXPECT_TRUE(keep(number, 60 * megabyte));
  for (int i = 0; i < 20; ++i) draw(4);
  EXPECT_TRUE(keep(4, 60 * megabyte));
  EXPECT_EQ(draw(3), DrawCache::Answer::kept);
  EXPECT_EQ(draw(0), DrawCache::Answer::fresh);
  EXPECT_EQ(buffers_alive, 4);
}

TEST_F(DrawCacheBounds, FramesWithoutADrawDropIt) {
  EXPECT_TRUE(keep(0, megabyte));
  EXPECT_TRUE(keep(1, megabyte));
  for (int frame = 0; frame < 130; ++frame) {
    draw(1);
    cache_.frame_finished(gl_);
  }
  EXPECT_EQ(buffers_alive, 1);
  EXPECT_EQ(draw(1), DrawCache::Answer::kept);
  cache_.release(gl_);
  EXPECT_EQ(buffers_alive, 0);
}

TEST_F(DrawCacheBounds, FreshDrawsAreBounded) {
  EXPECT_TRUE(keep(0, megabyte));
  for (std::uint64_t number = 1; number < 10000; ++number) draw(number);
  EXPECT_EQ(buffers_alive, 0);
  EXPECT_EQ(draw(9999), DrawCache::Answer::keep);
}

TEST_F(DrawCacheBounds, WrittenBuffersAndTheirNeighbours) {
  DrawKey key;
  key.add_buffer(5, 0);
  const auto ask = [&] { return cache_.look_up(gl_, key, *stamps_).first; };
  ask();
  EXPECT_EQ(ask(), DrawCache::Answer::keep);
  stamps_->wrote(6, 1);
  EXPECT_EQ(ask(), DrawCache::Answer::keep);
  stamps_->wrote(5, 2);
  EXPECT_EQ(ask(), DrawCache::Answer::fresh);
  stamps_->gpu_wrote(3);  // the buffer was never bound for GPU writes
  EXPECT_EQ(ask(), DrawCache::Answer::keep);
  stamps_->gpu_may_write(5);
  EXPECT_EQ(ask(), DrawCache::Answer::fresh);
  EXPECT_EQ(ask(), DrawCache::Answer::keep);
  stamps_->gpu_wrote(4);
  EXPECT_EQ(ask(), DrawCache::Answer::fresh);
  stamps_->wrote_any(5);
  EXPECT_EQ(ask(), DrawCache::Answer::fresh);
}

}  // namespace
}  // namespace glark::core
