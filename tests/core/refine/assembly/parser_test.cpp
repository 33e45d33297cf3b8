// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/assembly/parser.h"

#include <gtest/gtest.h>

namespace glark::refine::assembly {
namespace {

Program program_of(const std::string& body) {
  const Parsed parsed = parse("!!ARBvp1.0\n" + body + "END\n");
  EXPECT_TRUE(parsed.ok) << parsed.error;
  return parsed.program;
}

std::string error_of(const std::string& body) {
  const Parsed parsed = parse("!!ARBvp1.0\n" + body + "END\n");
  EXPECT_FALSE(parsed.ok);
  return parsed.error;
}

TEST(AssemblyParser, AnInstruction) {
  const Program program = program_of("TEMP r; ADD r.xz, -vertex.position.wzyx, {1, 2.5};\n");
  ASSERT_EQ(program.instructions.size(), 1U);
  const Instruction& add = program.instructions[0];
  EXPECT_EQ(add.row->opcode, "ADD");
  EXPECT_EQ(add.target.kind, Target::Kind::temporary);
  EXPECT_EQ(add.target.mask, "xz");
  EXPECT_EQ(add.sources[0].vector.text, "gl_Vertex");
  EXPECT_EQ(add.sources[0].swizzle, (Swizzle{{'w', 'z', 'y', 'x'}, {true, true, true, true}}));
  EXPECT_EQ(add.sources[1].vector.text, "vec4(1.0, 2.5, 0.0, 1.0)");
}

TEST(AssemblyParser, AScalarFillsAConstant) {
  const Program program = program_of("PARAM half = 0.5; MOV result.color, half; MOV result.position.x, -2;\n");
  EXPECT_EQ(program.instructions[0].sources[0].vector.text, "vec4(0.5)");
  EXPECT_EQ(program.instructions[1].sources[0].vector.text, "vec4(2.0)");
  EXPECT_TRUE(program.instructions[1].sources[0].swizzle.negated[0]);
}

TEST(AssemblyParser, ExtendedSwizzle) {
  const Program program = program_of("TEMP r; SWZ r, r, x, -y, 0, -1;\n");
  EXPECT_EQ(program.instructions[0].sources[0].swizzle, (Swizzle{{'x', 'y', '0', '1'}, {false, true, false, true}}));
}

TEST(AssemblyParser, TheLastPartOfAPathIsASwizzleUnlessThePathIsABinding) {
  const Program program =
      program_of("MOV result.color.back.x, state.light[2].position.w; MOV result.color, state.texgen[1].eye.r;\n");
  EXPECT_EQ(program.instructions[0].target.output, "gl_BackColor");
  EXPECT_EQ(program.instructions[0].target.mask, "x");
  EXPECT_EQ(program.instructions[0].sources[0].vector.text, "gl_LightSource[2].position");
  EXPECT_EQ(program.instructions[0].sources[0].swizzle.component[0], 'w');
  EXPECT_EQ(program.instructions[1].sources[0].vector.text, "gl_EyePlaneR[1]");
}

TEST(AssemblyParser, ElementsOfAnArray) {
  const Program program = program_of(
      "ADDRESS A; PARAM p[] = { program.local[3..5], {1, 2, 3, 4}, state.matrix.mvp.row[1] };\n"
      "ARL A.x, vertex.attrib[1].x; MOV result.color, p[3]; MOV result.position, p[A.x - 2].y;\n");
  EXPECT_EQ(program.instructions[0].target.kind, Target::Kind::address);
  EXPECT_EQ(program.instructions[1].sources[0].vector.text, "vec4(1.0, 2.0, 3.0, 4.0)");
  const Source& relative = program.instructions[2].sources[0];
  EXPECT_EQ(relative.kind, Source::Kind::element);
  EXPECT_EQ(relative.offset, -2);
  ASSERT_EQ(program.arrays.size(), 1U);
  ASSERT_EQ(program.arrays[0].size(), 5U);
  EXPECT_EQ(program.arrays[0][1].bank, Bank::local);
  EXPECT_EQ(program.arrays[0][1].index, 4);
  EXPECT_EQ(program.arrays[0][4].text, "gl_ModelViewProjectionMatrixTranspose[1]");
}

TEST(AssemblyParser, AMatrixHasFourRows) {
  const Program program = program_of(
      "ADDRESS A; PARAM m[4] = { state.matrix.texture[2].invtrans }; PARAM e[] = { program.env[1] };\n"
      "MOV result.position, m[A.x]; MOV result.color, e[A.x];\n");
  ASSERT_EQ(program.arrays.size(), 2U);
  ASSERT_EQ(program.arrays[0].size(), 4U);
  EXPECT_EQ(program.arrays[0][3].text, "gl_TextureMatrixInverse[2][3]");
  EXPECT_EQ(program.arrays[1][0].bank, Bank::environment);
}

TEST(AssemblyParser, NamesOfAll) {
  const Program program = program_of(
      "OPTION ARB_position_invariant;  # as the fixed function\n"
      "ATTRIB tint = vertex.color; OUTPUT out = result.texcoord[3]; TEMP a, b; ALIAS c = b;\n"
      "MOV c, tint; MOV out, c;\n");
  EXPECT_TRUE(program.position_invariant);
  EXPECT_EQ(program.instructions[0].target.number, 1);
  EXPECT_EQ(program.instructions[0].sources[0].vector.text, "gl_Color");
  EXPECT_EQ(program.instructions[1].target.output, "gl_TexCoord[3]");
}

TEST(AssemblyParser, WhatItDoesNotKnow) {
  EXPECT_EQ(error_of("OPTION NV_vertex_program3;\n"), "line 2: glark does not know the option NV_vertex_program3");
  EXPECT_EQ(error_of("TEMP r;\nBRA r, r;\n"), "line 3: glark does not know the instruction BRA");
  EXPECT_EQ(error_of("MOV result.color, vertex.weight;\n"), "line 2: glark does not know 'vertex'");
  EXPECT_EQ(error_of("PARAM p = state.matrix.palette[1].row[0];\n"), "line 2: glark does not know this parameter");
  EXPECT_EQ(error_of("MOV result.clip[0], vertex.position;\n"), "line 2: 'result' cannot be written");
}

TEST(AssemblyParser, TextsThatAreNoPrograms) {
  for (const std::string text :
       {"", "!!ARBfp1.0\nEND", "!!ARBvp1.0\nMOV", "!!ARBvp1.0\nMOV result, {", "!!VP1.0 END"}) {
    const Parsed parsed = parse(text);
    EXPECT_FALSE(parsed.ok) << text;
    EXPECT_FALSE(parsed.error.empty()) << text;
  }
  EXPECT_NE(error_of("PARAM p[] = { program.env[0..2000000000] };\n"), "");
  EXPECT_NE(error_of("TEMP r; TEMP r;\n"), "");
  EXPECT_NE(error_of("MOV result.color, p[1];\n"), "");
  EXPECT_NE(error_of("PARAM p[1] = { {1} }; MOV result.color, p[1];\n"), "");
}

}  // namespace
}  // namespace glark::refine::assembly
