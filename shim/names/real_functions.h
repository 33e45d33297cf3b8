// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The real functions of GLX, EGL and OSMesa behind our wrappers.
#pragma once

#include "shim/names/window_functions.h"

namespace glark::shim {

enum class WindowFunction {
#define GLARK_WINDOW_FUNCTION(function) function,
#include "shim/names/window_functions.inc"
#undef GLARK_WINDOW_FUNCTION
  count_
};

// Returns the real function. If nothing in the process has it, returns a function that does nothing and returns 0.
void* real_window_function(WindowFunction function);

// Keeps `real`, which the program itself found, as the real function unless another is already in use. Ignores our
// wrappers.
void note_real_window_function(const char* name, void* real);

// GLARK_REAL(glXSwapBuffers)(display, drawable)
#define GLARK_REAL(function)                \
  (reinterpret_cast<decltype(&::function)>( \
      ::glark::shim::real_window_function(::glark::shim::WindowFunction::function)))

// Returns what a GetProcAddress of the program shall return: our wrapper if the real function exists or the function is
// one of GL_ARK_adaptive_refinement, else `real`.
void* wrapper_or(const char* name, void* real);

}  // namespace glark::shim
