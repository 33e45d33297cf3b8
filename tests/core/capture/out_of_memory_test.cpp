// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// GL without memory: the core is given a dispatch whose glBufferData fails when told to. Links the core without the
// shim.
#include <GL/osmesa.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "glark/core/context.h"
#include "glark/gl/dispatch.h"
#include "glark/gl/hooks.h"
#include "include/GL/glark.h"

namespace glark::core {
namespace {

constexpr int side = 64;
gl::Dispatch real;
bool no_memory = false;
GLsizeiptr allocated = 0;  // bytes

void buffer_data(GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
  if (no_memory) {
    real.Enable(0xFFFF);  // GL has no command that raises GL_OUT_OF_MEMORY at will: any error of ours stands for it
    return;
  }
  real.BufferData(target, size, data, usage);
  allocated += size;
}

void* get_proc(void* /*user*/, const char* name) { return reinterpret_cast<void*>(OSMesaGetProcAddress(name)); }

class OutOfMemory : public testing::Test {
 public:
  OutOfMemory(const OutOfMemory&) = delete;
  OutOfMemory& operator=(const OutOfMemory&) = delete;

 protected:
  OutOfMemory() {
    const std::array<int, 7> attributes{
        OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_PROFILE, OSMESA_COMPAT_PROFILE, 0};
    window_ = OSMesaCreateContextAttribs(attributes.data(), nullptr);
    OSMesaMakeCurrent(window_, pixels_.data(), GL_UNSIGNED_BYTE, side, side);
    gl::load(real, get_proc, nullptr);
    failing_ = real;
    failing_.BufferData = buffer_data;
    no_memory = false;
    context_ = Context::create(failing_, make_share_group(), ContextOptions{});
  }
  ~OutOfMemory() override {
    no_memory = false;
    context_->release();
    context_.reset();
    OSMesaDestroyContext(window_);
  }

  GLint get(GLenum name) {
    GLint value = -2;
    hook::GetIntegerv(*context_, name, &value);
    return value;
  }
  void draw_triangle() {
    hook::Begin(*context_, GL_TRIANGLES);
    for (const auto& [x, y] : {std::pair{-1.0F, -1.0F}, std::pair{1.0F, -1.0F}, std::pair{0.0F, 1.0F}}) vertex(x, y);
    hook::End(*context_);
    real.Finish();
  }
  // Small triangles side by side, which cover the window. They are not counted before the end.
  void draw_grid(int rows, int columns, bool memory_at_the_end) {
    hook::Begin(*context_, GL_TRIANGLES);
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const auto x = [&](int step) {
          return 2.0F * static_cast<float>(column + step) / static_cast<float>(columns) - 1;
        };
        const auto y = [&](int step) { return 2.0F * static_cast<float>(row + step) / static_cast<float>(rows) - 1; };
        for (const auto& [right, up] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
          vertex(x(right), y(up));
      }
    }
    no_memory = !memory_at_the_end;
    hook::End(*context_);
    no_memory = false;
    real.Finish();
  }
  void vertex(float x, float y) {
    real.Vertex2f(x, y);
    context_->state().immediate().count(3);
  }
  int lit_pixels() const {
    int count = 0;
    for (std::size_t i = 0; i < pixels_.size(); i += 4) count += pixels_[i] != 0 ? 1 : 0;
    return count;
  }

  std::array<GLubyte, std::size_t{side} * side * 4> pixels_{};
  OSMesaContext window_ = nullptr;
  gl::Dispatch failing_;
  std::unique_ptr<Context> context_;
};

TEST_F(OutOfMemory, FirstPoolFails) {
  no_memory = true;
  hook::ARKinit(*context_, 4);
  EXPECT_EQ(hook::GetError(*context_), GLenum{GL_OUT_OF_MEMORY});
  EXPECT_EQ(hook::GetError(*context_), GLenum{GL_NO_ERROR});
  EXPECT_EQ(get(GL_POOL_LEVEL_ARK), -1);
  hook::Enable(*context_, GL_ARK);
  EXPECT_EQ(hook::GetError(*context_), GLenum{GL_INVALID_OPERATION});
}

TEST_F(OutOfMemory, OldPoolIsKept) {
  hook::ARKinit(*context_, 3);
  hook::DepthTag1i(*context_, 3);
  hook::Enable(*context_, GL_ARK);
  no_memory = true;
  hook::ARKinit(*context_, 6);
  no_memory = false;
  EXPECT_EQ(hook::GetError(*context_), GLenum{GL_OUT_OF_MEMORY});
  EXPECT_EQ(get(GL_POOL_LEVEL_ARK), 3);
  const auto refined = statistics().draws_refined.load();
  draw_triangle();
  EXPECT_EQ(statistics().draws_refined.load(), refined + 1);
  EXPECT_GT(lit_pixels(), 1000);
}

TEST_F(OutOfMemory, DrawWithoutRoomIsTheOriginal) {
  hook::ARKinit(*context_, 3);
  hook::DepthTag1i(*context_, 3);
  hook::Enable(*context_, GL_ARK);
  no_memory = true;
  const auto passed = statistics().passed_through[static_cast<std::size_t>(Cause::out_of_memory)].load();
  draw_triangle();
  EXPECT_EQ(statistics().passed_through[static_cast<std::size_t>(Cause::out_of_memory)].load(), passed + 1);
  EXPECT_EQ(hook::GetError(*context_), GLenum{GL_NO_ERROR});
  EXPECT_GT(lit_pixels(), 1000);
}

// The room for the passes over a draw by glBegin is made at its end. Without memory, it is refined in parts.
TEST_F(OutOfMemory, CountedDrawIsRefinedInParts) {
  hook::ARKinit(*context_, 3);
  hook::DepthTag1i(*context_, 2);
  hook::Enable(*context_, GL_ARK);
  for (const bool memory_at_the_end : {false, true}) {
    SCOPED_TRACE(memory_at_the_end);
    pixels_.fill(0);
    const auto coarse = statistics().coarse_triangles.load();
    draw_grid(100, 150, memory_at_the_end);
    EXPECT_EQ(statistics().coarse_triangles.load(), coarse + 30000);
    EXPECT_EQ(lit_pixels(), side * side);
    EXPECT_EQ(hook::GetError(*context_), GLenum{GL_NO_ERROR});
  }
}

TEST_F(OutOfMemory, OneTriangleTakesLittleMoreThanItsCapture) {
  hook::ARKinit(*context_, 3);
  hook::DepthTag1i(*context_, 2);
  hook::Enable(*context_, GL_ARK);
  allocated = 0;
  draw_triangle();
  EXPECT_LT(allocated, GLsizeiptr{48} << 20);
}

}  // namespace
}  // namespace glark::core
