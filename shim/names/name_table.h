// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Every function that this library wraps, by name.
#pragma once

#include <string_view>

namespace glark::shim {

enum class NameKind {
  gl,             // a function of OpenGL that the driver has
  ours,           // a function of GL_ARK_adaptive_refinement
  window_system,  // GLX, EGL, OSMesa
  linker,         // dlsym, dlvsym, dlopen
};

struct Name {
  const char* name;
  void* wrapper;
  NameKind kind;
};

// Returns nullptr for a function that is not wrapped.
const Name* find_name(std::string_view name);

}  // namespace glark::shim
