// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Names for buffers of ours that no application is likely to choose. A compatibility context and OpenGL ES let the
// application bind names that glGenBuffers never gave it, and old programs choose small ones.
#pragma once

#include "glark/gl/dispatch.h"

namespace glark::core {

// Makes a buffer object, as glGenBuffers and a first glBindBuffer to GL_COPY_WRITE_BUFFER do. It stays bound there.
GLuint bind_new_buffer(const gl::Dispatch& gl);

}  // namespace glark::core
