// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/assembly/translate.h"

#include <gtest/gtest.h>

#include "glark/core/refine/fixed_function/fixed_function.h"

namespace glark::refine::assembly {
namespace {

Translation translation_of(const std::string& body, bool clip_planes = false) {
  Translation translation = translate("!!ARBvp1.0\n" + body + "END\n", clip_planes);
  EXPECT_TRUE(translation.ok) << translation.error;
  return translation;
}

bool has(const Translation& translation, std::string_view text) {
  return translation.source.find(text) != std::string::npos;
}

TEST(AssemblyTranslation, AWholeProgram) {
  const Translation translation = translation_of(
      "TEMP r0;\nDP4 r0.x, program.local[4], vertex.position;\nMOV result.position, r0.x;\n"
      "MAD result.color.xy, -r0, vertex.attrib[3], 0.5;\n");
  EXPECT_EQ(translation.source,
            "#version 330 compatibility\ninvariant gl_Position;\n"
            "layout(location = 3) in vec4 assembly_attribute_3;\nuniform vec4 assembly_local[1];\n"
            "\nvoid main() {\n  vec4 t0_r0 = vec4(0.0);\n"
            "  gl_FrontColor = vec4(0.0);\n"
            "  t0_r0.x = (vec4(dot(assembly_local[0], gl_Vertex))).x;\n"
            "  gl_Position = t0_r0.xxxx;\n"
            "  gl_FrontColor.xy = ((-t0_r0) * assembly_attribute_3 + vec4(0.5)).xy;\n}\n");
}

TEST(AssemblyTranslation, ThePositionOfTheFixedFunction) {
  const Translation translation =
      translation_of("OPTION ARB_position_invariant; MOV result.color, vertex.color;\n", true);
  const std::string fixed_function = fixed_function_vertex_shader({.clip_planes = true});
  for (const std::string_view text :
       {"invariant gl_Position;", "gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;"}) {
    EXPECT_TRUE(has(translation, text));
    EXPECT_NE(fixed_function.find(text), std::string::npos) << text;
  }
  EXPECT_TRUE(has(translation, "gl_ClipVertex = gl_ModelViewMatrix * gl_Vertex;"));
}

TEST(AssemblyTranslation, ClipPlanesAreInEyeSpace) {
  EXPECT_FALSE(has(translation_of("MOV result.position, vertex.position;\n"), "gl_ClipVertex"));
  EXPECT_TRUE(has(translation_of("MOV result.position, vertex.position;\n", true),
                  "gl_ClipVertex = gl_ProjectionMatrixInverse * gl_Position;"));
}

TEST(AssemblyTranslation, RangesOfParameters) {
  const Translation translation = translation_of(
      "MOV result.position, program.env[7]; ADD result.color, program.env[3], program.local[2];\n"
      "MOV result.texcoord, state.matrix.program[5].row[1];\n");
  EXPECT_EQ(translation.environment.first, 3);
  EXPECT_EQ(translation.environment.count, 5);
  EXPECT_EQ(translation.local.first, 2);
  EXPECT_EQ(translation.local.count, 1);
  EXPECT_EQ(translation.matrices, std::vector<int>{5});
  EXPECT_TRUE(has(translation, "gl_Position = assembly_environment[4];"));
}

TEST(AssemblyTranslation, ArraysOfEachKind) {
  const Translation translation = translation_of(
      "ADDRESS A; PARAM bones[] = { program.env[10..20] }; PARAM c[] = { {1}, {2} };\n"
      "PARAM mixed[] = { {3}, program.env[2] };\n"
      "MOV result.position, bones[A.x + 1]; MOV result.color, c[A.x]; MOV result.texcoord, mixed[A.x - 1];\n");
  EXPECT_TRUE(has(translation, "gl_Position = assembly_environment[a0_A + 9];"));
  EXPECT_TRUE(has(translation, "const vec4 assembly_array_1[2] = vec4[2](vec4(1.0, 0.0, 0.0, 1.0), "));
  EXPECT_TRUE(
      has(translation, "  vec4 assembly_array_2[2] = vec4[2](vec4(3.0, 0.0, 0.0, 1.0), assembly_environment[0]);"));
  EXPECT_TRUE(has(translation, "gl_TexCoord[0] = assembly_array_2[a0_A + -1];"));
}

TEST(AssemblyTranslation, ResultsThatAreFloats) {
  const Translation translation = translation_of(
      "MOV result.position, vertex.position; MOV result.fogcoord, vertex.position.z; MOV result.pointsize.x, 2.0;\n"
      "MOV result.fogcoord.yz, vertex.position;\n");
  EXPECT_TRUE(has(translation, "gl_FogFragCoord = (gl_Vertex.zzzz).x;"));
  EXPECT_TRUE(has(translation, "gl_PointSize = (vec4(2.0)).x;"));
  EXPECT_FALSE(has(translation, "gl_FogFragCoord.yz"));
}

TEST(AssemblyTranslation, NamesThatGlslForbids) {
  const Translation translation =
      translation_of("TEMP gl_Position, $, a__b; MOV gl_Position, 1.0; MOV a__b, gl_Position; MOV $, a__b;\n");
  EXPECT_TRUE(has(translation, "t0_glPosition = vec4(1.0);"));
  EXPECT_TRUE(has(translation, "t2_ab = t0_glPosition;"));
  EXPECT_TRUE(has(translation, "t1_register = t2_ab;"));
}

TEST(AssemblyTranslation, AnErrorSaysWhere) {
  const Translation translation = translate("!!ARBvp1.0\nOPTION NV_vertex_program2;\nEND", false);
  EXPECT_FALSE(translation.ok);
  EXPECT_EQ(translation.error, "line 2: glark does not know the option NV_vertex_program2");
}

}  // namespace
}  // namespace glark::refine::assembly
