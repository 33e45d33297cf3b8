// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Assembly vertex programs (ARB_vertex_program) as GLSL vertex shaders, so that they can be derived like others. Text in,
// text out; no GL.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace glark::refine::assembly {

// Uniforms of the shader.
inline constexpr const char* environment_uniform = "assembly_environment";  // vec4[]: program.env of the range
inline constexpr const char* local_uniform = "assembly_local";              // vec4[]: program.local of the range
inline constexpr const char* matrix_uniform_prefix = "assembly_matrix_";    // mat4: GL_MATRIX0_ARB + n

struct ParameterRange {
  int first = 0;
  int count = 0;
};

struct Translation {
  bool ok = false;
  std::string source;  // "#version 330 compatibility"
  ParameterRange environment;
  ParameterRange local;
  std::vector<int> matrices;  // numbers of the program matrices that the shader reads
  std::string error;          // one line: where and why
};

// `clip_planes`: a user clip plane is enabled. The shader computes the same values as the driver, but for rounding. With
// OPTION ARB_position_invariant, its position is the one of fixed_function_vertex_shader(), to the bit.
Translation translate(std::string_view program, bool clip_planes);

}  // namespace glark::refine::assembly
