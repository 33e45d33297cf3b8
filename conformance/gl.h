// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The GL of the implementation under test, by name: gl.DrawArrays(...). Nothing is linked; every function is asked for by
// the window system's own means, as any program would, so that whatever implementation the loader finds is the one that is judged.
#pragma once

#define GL_GLEXT_PROTOTYPES  // for the types alone
#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>

namespace glark::conformance {

struct Functions {
#define GLARK_FUNCTION(name) decltype(&::gl##name) name = nullptr;
#include "conformance/functions.inc"
#undef GLARK_FUNCTION
};

// Of the first context of the process; null where the implementation has none.
extern Functions gl;

// `address` is what eglGetProcAddress and its kin are.
template <typename Address>
void load_functions(Address&& address) {
#define GLARK_FUNCTION(name) gl.name = reinterpret_cast<decltype(gl.name)>(address("gl" #name));
#include "conformance/functions.inc"
#undef GLARK_FUNCTION
}

}  // namespace glark::conformance
