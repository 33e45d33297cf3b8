// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The genuine dlsym, dlvsym and dlopen behind our own, and what is loaded in this process.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace glark::shim {

struct DynamicLinker {
  void* (*dlsym)(void* handle, const char* name) = nullptr;
  void* (*dlvsym)(void* handle, const char* name, const char* version) = nullptr;
  void* (*dlopen)(const char* file, int flags) = nullptr;
};

// Found at the first call, from any thread, also before any constructor has run.
const DynamicLinker& real_linker();

// The symbol in the objects that come after this library in the lookup order of the program; nullptr if there is none.
// Like dlsym it leaves an error for dlerror() when it fails.
void* next_symbol(const char* name);

// The symbol in the GL libraries (libGL, libOpenGL, libGLESv2, libGLX, libEGL, libOSMesa, under any version) that were loaded
// out of sight of RTLD_NEXT, by dlopen(RTLD_LOCAL). They are kept loaded from then on.
void* symbol_of_loaded_gl(const char* name);

// next_symbol, else symbol_of_loaded_gl.
void* find_symbol(const char* name);
template <class Function>
Function find_function(const char* name) {
  return reinterpret_cast<Function>(find_symbol(name));
}

// Whether any such library is loaded at all.
bool gl_is_loaded();

// Whether the address lies in the main program.
bool in_main_program(const void* address);

// Keeps the library of that address loaded for good: we hold pointers into it.
void keep_loaded(const void* address);

}  // namespace glark::shim
