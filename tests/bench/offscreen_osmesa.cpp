// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <vector>

#include "tests/bench/gl.h"
#include "tests/bench/offscreen.h"

#include <GL/osmesa.h>

namespace glark::bench {

struct Offscreen::Context {
  OSMesaContext handle = nullptr;
  std::vector<std::uint32_t> pixels = std::vector<std::uint32_t>(std::size_t{picture_size} * picture_size);
};

Offscreen::Offscreen() : context_(std::make_unique<Context>()) {
  context_->handle = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
  ready_ = context_->handle != nullptr && OSMesaMakeCurrent(context_->handle, context_->pixels.data(), GL_UNSIGNED_BYTE,
                                                            picture_size, picture_size) != GL_FALSE;
  if (ready_) set_state();
}

Offscreen::~Offscreen() {
  if (context_->handle != nullptr) OSMesaDestroyContext(context_->handle);
}

}  // namespace glark::bench
