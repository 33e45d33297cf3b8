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

void buffer_data(GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
  if (no_memory) {
    real.Enable(0xFFFF);  // GL has no command that raises GL_OUT_OF_MEMORY at will: any error of ours stands for it
    return;
  }
  real.BufferData(target, size, data, usage);
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
    for (const auto& [x, y] : {std::pair{-1.0F, -1.0F}, std::pair{1.0F, -1.0F}, std::pair{0.0F, 1.0F}}) {
      real.Vertex2f(x, y);
      context_->state().immediate().count(3);
    }
    hook::End(*context_);
    real.Finish();
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

}  // namespace
}  // namespace glark::core
