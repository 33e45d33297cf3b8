// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A GL context of OSMesa for tests that link the core without the shim.
#pragma once

#include <GL/osmesa.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "glark/gl/dispatch.h"

namespace glark::core::test {

inline constexpr int plain_side = 128;  // of the picture, in pixels

class PlainContext {
 public:
  PlainContext() {
    const std::array<int, 7> attributes{
        OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_PROFILE, OSMESA_COMPAT_PROFILE, 0};
    window_ = OSMesaCreateContextAttribs(attributes.data(), nullptr);
    if (OSMesaMakeCurrent(window_, pixels_.data(), GL_UNSIGNED_BYTE, plain_side, plain_side) == GL_FALSE) {
      std::fputs("no OSMesa context\n", stderr);
      std::abort();
    }
    gl::load(
        gl, [](void* /*user*/, const char* name) { return reinterpret_cast<void*>(OSMesaGetProcAddress(name)); },
        nullptr);
  }
  ~PlainContext() { OSMesaDestroyContext(window_); }
  PlainContext(const PlainContext&) = delete;
  PlainContext& operator=(const PlainContext&) = delete;

  gl::Dispatch gl;

 private:
  std::vector<GLubyte> pixels_ = std::vector<GLubyte>(static_cast<std::size_t>(4) * plain_side * plain_side);
  OSMesaContext window_ = nullptr;
};

}  // namespace glark::core::test
