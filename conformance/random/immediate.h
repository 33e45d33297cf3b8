// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Begin, vertices by any of their commands with other values among them, and End.
#pragma once

#include "conformance/random/row.h"

namespace glark::conformance {

GLenum any_mode(World& w);
// Random values and vertices anywhere, as they are between Begin and End.
void random_vertices(World& w, int count);
// A primitive of any mode. Quadrilaterals and polygons are convex and flat: OpenGL leaves open how others are drawn.
void random_primitive(World& w, int most_vertices);
// Compiles list `name` of random commands. Executing it again changes nothing more than executing it twice.
void compile_random_list(World& w, GLuint name);

inline constexpr GLuint first_list = 1, last_list = 4;  // each may call later ones
inline constexpr GLuint vertex_list = 5;                // values and vertices alone
inline constexpr GLuint nested_vertex_list = 6;         // calls the one before

}  // namespace glark::conformance
