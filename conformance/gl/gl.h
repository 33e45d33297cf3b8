// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The GL of the implementation under test, by name: gl.DrawArrays(...). The suite links to no GL: it asks the window system for
// every function, as any program would, and so judges the implementation that the dynamic linker finds.
//
// glad generates the types, the names and the loader at build time, from Khronos' gl.xml and the extension's own registry,
// glark/gl/glark.xml. The functions of the extension are there only if GetStringi(EXTENSIONS) has its name.
#pragma once

#include <glad/gl.h>

#include "conformance/gl/function_source.h"

namespace glark::conformance {

// The functions of the current context; null where the implementation has none.
extern GladGLContext gl;

// Loads the functions of the current context.
void load_functions(FunctionSource& source, bool is_gles);

}  // namespace glark::conformance
