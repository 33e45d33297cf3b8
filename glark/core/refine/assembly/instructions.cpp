// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Based on: ARB_vertex_program, section 2.14.5.
#include "glark/core/refine/assembly/instructions.h"

#include <algorithm>
#include <iterator>

namespace glark::refine::assembly {
namespace {

// The specification leaves the w component of XPD undefined; Mesa gives 1.
constexpr InstructionRow rows[] = {
    {"ABS", 1, "abs(@0)"},
    {"ADD", 2, "@0 + @1"},
    {"ARL", 1, "int(floor(@0.x))"},
    {"DP3", 2, "vec4(dot(@0.xyz, @1.xyz))"},
    {"DP4", 2, "vec4(dot(@0, @1))"},
    {"DPH", 2, "vec4(dot(@0.xyz, @1.xyz) + @1.w)"},
    {"DST", 2, "vec4(1.0, @0.y * @1.y, @0.z, @1.w)"},
    {"EX2", 1, "vec4(exp2(@0.x))"},
    {"EXP", 1, "assembly_exp(@0.x)"},
    {"FLR", 1, "floor(@0)"},
    {"FRC", 1, "fract(@0)"},
    {"LG2", 1, "vec4(log2(@0.x))"},
    {"LIT", 1, "assembly_lit(@0)"},
    {"LOG", 1, "assembly_log(@0.x)"},
    {"MAD", 3, "@0 * @1 + @2"},
    {"MAX", 2, "max(@0, @1)"},
    {"MIN", 2, "min(@0, @1)"},
    {"MOV", 1, "@0"},
    {"MUL", 2, "@0 * @1"},
    {"POW", 2, "vec4(pow(@0.x, @1.x))"},
    {"RCP", 1, "vec4(1.0 / @0.x)"},
    {"RSQ", 1, "vec4(inversesqrt(abs(@0.x)))"},
    {"SGE", 2, "vec4(greaterThanEqual(@0, @1))"},
    {"SLT", 2, "vec4(lessThan(@0, @1))"},
    {"SUB", 2, "@0 - @1"},
    {"SWZ", 1, "@0"},
    {"XPD", 2, "vec4(cross(@0.xyz, @1.xyz), 1.0)"},
};

}  // namespace

const InstructionRow* find_instruction(std::string_view opcode) {
  const auto* const found =
      std::find_if(std::begin(rows), std::end(rows), [&](const InstructionRow& row) { return row.opcode == opcode; });
  return found != std::end(rows) ? found : nullptr;
}

}  // namespace glark::refine::assembly
