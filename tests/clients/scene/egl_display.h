// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A display of EGL that needs no window system, for C and C++.
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

// Mesa's surfaceless platform, or else the default display: drivers of graphics cards give one without an X server.
// Returns EGL_NO_DISPLAY if there is neither. The display is initialized.
static inline EGLDisplay open_egl_display(void) {
  EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, 0);
  if (display != EGL_NO_DISPLAY && eglInitialize(display, 0, 0)) return display;
  display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  return display != EGL_NO_DISPLAY && eglInitialize(display, 0, 0) ? display : EGL_NO_DISPLAY;
}
