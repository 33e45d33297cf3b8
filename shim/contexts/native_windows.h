// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The windows behind the surfaces of GLX and EGL: keys and pointer belong to them. They are
// noted only if the user wants keys. Any thread may call these functions.
#pragma once

#include <cstdint>
#include <string>

#include "shim/contexts/provider.h"
#include "shim/contexts/surface.h"

namespace glark::shim {

struct NativeWindow {
  enum class System { none, x11, wayland };
  System system = System::none;
  std::uint64_t number = 0;      // of an EGL surface: a surface that is made later has another one
  std::string x11_display = {};  // as in $DISPLAY; empty: that of the environment
  std::uint32_t x11_window = 0;
  void* wayland_display = nullptr;
  void* wayland_surface = nullptr;  // null: unknown
};

// `platform`: EGL_PLATFORM_..., or 0 for eglGetDisplay, which guesses it.
void note_egl_display(unsigned platform, void* native, void* display);
// `native` as in eglCreateWindowSurface, or, if `indirect`, as in eglCreatePlatformWindowSurface.
void note_egl_window(void* display, void* native, bool indirect, void* surface);
void note_glx_window(unsigned long window, unsigned long drawable);
void note_glx_visual(void* context, const void* visual);  // XVisualInfo, as in glXCreateContext
unsigned long glx_visual_of(void* context);               // 0: it was made for a configuration

NativeWindow native_window_of(Provider provider, const Surface& surface);

}  // namespace glark::shim
