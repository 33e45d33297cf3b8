// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "tests/refine/derive_harness.h"

namespace glark::refine::test {

bool make_current(Api api) {
  if (api != Api::es) return false;
  const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE) return false;
  eglBindAPI(EGL_OPENGL_ES_API);
  static const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2, EGL_NONE};
  static const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
}

void* get_proc(const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); }

}  // namespace glark::refine::test
