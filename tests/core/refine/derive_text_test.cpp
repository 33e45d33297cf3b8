// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Properties of the derived text that can be checked without a driver.
#include <gtest/gtest.h>

#include "glark/core/refine/derive.h"
#include "glark/core/refine/glsl/tokens.h"

namespace glark::refine {
namespace {

DeriveRequest request(const std::string& source) {
  DeriveRequest r;
  r.vertex_sources = {source};
  capture::Field field;
  field.name = "a";
  field.type = GL_FLOAT_VEC3;
  field.words = 3;
  r.layout.fields = {field};
  r.layout.corner_words = 3;
  return r;
}

std::string derived(const DeriveRequest& r) {
  const Derivation derivation = derive_vertex_stage(r);
  EXPECT_TRUE(derivation.ok) << derivation.error;
  return derivation.ok ? derivation.vertex_sources[0] : "";
}

TEST(DeriveText, ChunksAreInputsInTheLanguagesWay) {
  const std::string old_text = derived(request("attribute vec3 a; void main() { gl_Position = vec4(a, 1.0); }"));
  EXPECT_NE(old_text.find("attribute vec4 glark_chunk2;"), std::string::npos);
  EXPECT_EQ(old_text.find("glark_chunk3"), std::string::npos);
  EXPECT_EQ(old_text.find("attribute vec3"), std::string::npos);
  const std::string new_text = derived(request("#version 330\nin vec3 a; void main() { gl_Position = vec4(a, 1.0); }"));
  EXPECT_NE(new_text.find("in vec4 glark_chunk2;"), std::string::npos);
  EXPECT_EQ(new_text.find("in vec3 a"), std::string::npos);
}

TEST(DeriveText, VersionStaysFirstAndExtensionsPrecedeEverything) {
  DeriveRequest r = request(
      "#version 150\n#extension GL_ARB_gpu_shader_fp64 : enable\nin vec3 a; void main() { gl_Position = vec4(a, "
      "gl_VertexID); }");
  r.refinement_source = "#extension GL_ARB_shading_language_packing : enable\nvoid refine() {}";
  const Tokens tokens = tokenize(derived(r));
  EXPECT_EQ(directive_name(tokens[0]), "version");
  bool code_begun = false;
  for (const Token& token : tokens) {
    if (token.kind != TokenKind::directive) code_begun = true;
    EXPECT_FALSE(code_begun && directive_name(token) == "extension") << token.text;
  }
}

TEST(DeriveText, PreciseWhereTheLanguageHasIt) {
  EXPECT_NE(derived(request("#version 400\nin vec3 a; void main() { gl_Position = vec4(a, 1.0); }"))
                .find("#define glark_precise precise"),
            std::string::npos);
  const std::string early = derived(request("#version 150\nin vec3 a; void main() { gl_Position = vec4(a, 1.0); }"));
  EXPECT_NE(early.find("#ifdef GL_ARB_gpu_shader5"), std::string::npos);
  const std::string taken =
      derived(request("#version 150\nin vec3 a; void main() { vec3 sample = a; gl_Position = vec4(sample, 1.0); }"));
  EXPECT_EQ(taken.find("GL_ARB_gpu_shader5"), std::string::npos);
}

TEST(DeriveText, AUniformThatTakesOurNameIsRefused) {
  const Derivation derivation = derive_vertex_stage(
      request("uniform vec3 glark_patch; attribute vec3 a; void main() { gl_Position = vec4(a + glark_patch, 1.0); }"));
  EXPECT_FALSE(derivation.ok);
  EXPECT_NE(derivation.error.find("'glark_patch'"), std::string::npos);
}

TEST(DeriveText, TheSameRequestGivesTheSameText) {
  DeriveRequest r = request(
      "#version 150 compatibility\nin vec3 a; out vec3 b; void main() { b = a + gl_Normal; gl_Position = gl_Vertex; "
      "gl_FrontColor = gl_Color; }");
  r.refinement = core::Refinement::linear_outputs;
  EXPECT_EQ(derived(r), derived(r));
}

}  // namespace
}  // namespace glark::refine
