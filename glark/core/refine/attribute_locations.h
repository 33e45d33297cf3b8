// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/gl/types.h"

namespace glark::refine {

// Attribute locations of every derived program.
inline constexpr GLuint lattice_location = 0;
inline constexpr GLuint patch_location = 1;  // the first chunk where pieces need no placement
inline constexpr GLuint first_chunk_location = 2;

}  // namespace glark::refine
