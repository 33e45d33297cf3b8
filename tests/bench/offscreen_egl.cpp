// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench/gl.h"
#include "tests/bench/offscreen.h"
#include "tests/clients/scene/egl_display.h"

namespace glark::bench {

struct Offscreen::Context {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLSurface surface = EGL_NO_SURFACE;
  EGLContext handle = EGL_NO_CONTEXT;
};

Offscreen::Offscreen() : context_(std::make_unique<Context>()) {
  static constexpr EGLint wanted[] = {EGL_SURFACE_TYPE,
                                      EGL_PBUFFER_BIT,
                                      EGL_RENDERABLE_TYPE,
                                      EGL_OPENGL_BIT,
                                      EGL_RED_SIZE,
                                      8,
                                      EGL_GREEN_SIZE,
                                      8,
                                      EGL_BLUE_SIZE,
                                      8,
                                      EGL_ALPHA_SIZE,
                                      8,
                                      EGL_DEPTH_SIZE,
                                      24,
                                      EGL_NONE};
  static constexpr EGLint size[] = {EGL_WIDTH, picture_size, EGL_HEIGHT, picture_size, EGL_NONE};
  auto& [display, surface, handle] = *context_;
  display = open_egl_display();
  EGLConfig config = nullptr;
  EGLint configs = 0;
  if (display == EGL_NO_DISPLAY || eglBindAPI(EGL_OPENGL_API) == EGL_FALSE ||
      eglChooseConfig(display, wanted, &config, 1, &configs) == EGL_FALSE || configs == 0)
    return;
  surface = eglCreatePbufferSurface(display, config, size);
  handle = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
  ready_ = handle != EGL_NO_CONTEXT && eglMakeCurrent(display, surface, surface, handle) == EGL_TRUE;
  if (ready_) set_state();
}

Offscreen::~Offscreen() {
  if (context_->display == EGL_NO_DISPLAY) return;
  eglMakeCurrent(context_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (context_->handle != EGL_NO_CONTEXT) eglDestroyContext(context_->display, context_->handle);
  if (context_->surface != EGL_NO_SURFACE) eglDestroySurface(context_->display, context_->surface);
}

}  // namespace glark::bench
