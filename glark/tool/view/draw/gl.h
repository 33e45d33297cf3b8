// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The OpenGL functions of the viewer, from GLFW, EGL or OSMesa, whichever made the context. glad generates the loader.
#pragma once

#include <glad/gl.h>

namespace glark::tool {

extern GladGLContext gl;

// Loads the functions of the current context. Throws std::runtime_error if the context is below OpenGL 3.0.
void load_gl(GLADloadfunc loader);

}  // namespace glark::tool
