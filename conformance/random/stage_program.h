// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The programs of random programs. Their pictures show every input and every uniform.
#pragma once

#include <string>
#include <vector>

#include "conformance/random/world.h"

namespace glark::conformance {

// The uniforms of a program are arrays of two, called by their types: "u_3f" has two vec3, "u_2x3f" two mat2x3.
const std::vector<const char*>& uniform_types(bool is_desktop);
inline constexpr GLsizei uniform_elements = 2;

// The two programs of a world differ by `salt`.
GLuint stage_program(Test& t, WorldKind kind, unsigned salt);

inline constexpr GLuint colour_block_binding = 3;
inline constexpr GLintptr colour_block_bytes = 256;  // from one block in World::blocks to the next
inline constexpr int colour_blocks = 4;

}  // namespace glark::conformance
