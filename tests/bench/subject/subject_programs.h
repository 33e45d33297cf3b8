// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The measured application: a program with lighting per vertex, the same program with tessellation stages, and the
// fixed function.
#pragma once

#include "tests/bench/gl.h"

namespace glark::bench {

enum class Shading { glsl, fixed_function };

// Locations of the vertex inputs.
inline constexpr GLuint position_input = 1;
inline constexpr GLuint normal_input = 2;
inline constexpr GLuint uv_input = 3;

enum class View {
  sphere,  // the unit sphere fills the picture
  plane,   // from above the plane y = 0, towards the horizon
  culled,  // like sphere, but no triangle is rasterised
};

// Builds the program at its first use, in the only context. Throws std::runtime_error if the program does not link.
GLuint shaded_program();
GLuint tessellation_program();

void use_shading(Shading shading, View view);
void use_tessellation(View view, unsigned level);

}  // namespace glark::bench
