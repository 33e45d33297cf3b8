// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reads the names in an argument of glCallLists, for each type that it takes.
#pragma once

#include "glark/gl/types.h"

namespace glark::core::track {

bool is_name_type(GLenum type);
// The name at index i of `lists`, whose type is_name_type().
GLuint name_at(GLenum type, const void* lists, GLsizei i);

}  // namespace glark::core::track
