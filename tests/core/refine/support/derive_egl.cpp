// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/clients/scene/egl_display.h"
#include "tests/core/refine/support/derive_harness.h"

namespace glark::refine::test {

namespace {

template <typename Function>
Function function(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

// Without a surface there is no default framebuffer, and a draw needs one even when it discards everything.
void bind_framebuffer() {
  GLuint framebuffer = 0;
  GLuint color = 0;
  function<PFNGLGENFRAMEBUFFERSPROC>("glGenFramebuffers")(1, &framebuffer);
  function<PFNGLGENRENDERBUFFERSPROC>("glGenRenderbuffers")(1, &color);
  function<PFNGLBINDRENDERBUFFERPROC>("glBindRenderbuffer")(GL_RENDERBUFFER, color);
  function<PFNGLRENDERBUFFERSTORAGEPROC>("glRenderbufferStorage")(GL_RENDERBUFFER, GL_RGBA8, 16, 16);
  function<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer")(GL_FRAMEBUFFER, framebuffer);
  function<PFNGLFRAMEBUFFERRENDERBUFFERPROC>("glFramebufferRenderbuffer")(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                                                                          GL_RENDERBUFFER, color);
}

}  // namespace

bool make_current(Api api) {
  if (api != Api::es) return false;
  const EGLDisplay display = open_egl_display();
  if (display == EGL_NO_DISPLAY) return false;
  eglBindAPI(EGL_OPENGL_ES_API);
  static const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2, EGL_NONE};
  static const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) return false;
  bind_framebuffer();
  return true;
}

void* get_proc(const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); }

}  // namespace glark::refine::test
