// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The real dlsym, dlvsym and dlopen behind ours, and the libraries that are loaded in this process.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glark::shim {

struct DynamicLinker {
  void* (*dlsym)(void* handle, const char* name) = nullptr;
  void* (*dlvsym)(void* handle, const char* name, const char* version) = nullptr;
  void* (*dlopen)(const char* file, int flags) = nullptr;
};

// The first call finds the functions. It may come from any thread, and before any constructor has run.
const DynamicLinker& real_linker();

// Returns the symbol from the objects after this library in the program's lookup order, or nullptr. Like dlsym, it sets
// an error for dlerror() when it fails.
void* next_symbol(const char* name);

// Returns the symbol from the GL libraries (libGL, libOpenGL, libGLESv2, libGLX, libEGL, libOSMesa, of any version)
// that dlopen(RTLD_LOCAL) has hidden from RTLD_NEXT. They stay loaded from then on.
void* symbol_of_loaded_gl(const char* name);

// The same for one library whose file name begins with `library`, for example "libxcb.so".
void* symbol_of_loaded(std::string_view library, const char* name);

// Tries next_symbol, then symbol_of_loaded_gl.
void* find_symbol(const char* name);
template <class Function>
Function find_function(const char* name) {
  return reinterpret_cast<Function>(find_symbol(name));
}

// If the program was linked with this library behind a GL library that defines one of the names, returns the path of
// that GL library: its functions are called instead of ours. Else returns an empty text.
std::string gl_library_before_us(std::span<const char* const> names);

// Returns whether any GL library is loaded.
bool gl_is_loaded();

// Returns whether the address lies in the main program.
bool in_main_program(const void* address);

// Keeps the library of this address loaded, because we hold pointers into it.
void keep_loaded(const void* address);

}  // namespace glark::shim
