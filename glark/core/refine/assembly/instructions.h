// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The instructions of assembly vertex programs and their GLSL.
#pragma once

#include <string_view>

namespace glark::refine::assembly {

struct InstructionRow {
  std::string_view opcode;
  int sources;
  std::string_view glsl;  // a vec4; "@0" is the first source, a vec4
};

// Null: there is no such instruction. ARL has an int.
const InstructionRow* find_instruction(std::string_view opcode);

// GLSL functions that some rows call.
inline constexpr std::string_view instruction_functions = R"(
vec4 assembly_exp(float x) {
  float whole = floor(x);
  return vec4(exp2(whole), x - whole, exp2(x), 1.0);
}
vec4 assembly_log(float x) {
  float size = abs(x);
  float exponent = floor(log2(size));
  return vec4(exponent, size * exp2(-exponent), log2(size), 1.0);
}
vec4 assembly_lit(vec4 v) {
  float specular = pow(max(v.y, 0.0), clamp(v.w, -128.0, 128.0));
  return vec4(1.0, max(v.x, 0.0), v.x > 0.0 ? specular : 0.0, 1.0);
}
)";

}  // namespace glark::refine::assembly
