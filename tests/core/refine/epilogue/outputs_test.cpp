// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Refinement::linear_outputs: the application's vertex stage runs on the corners, its outputs are interpolated.
#include <gtest/gtest.h>

#include <bit>

#include "tests/core/refine/support/derive_harness.h"

namespace glark::refine::test {
namespace {

// a = 0, 8, 4 at the corners: the square at (1/4, 1/2, 1/4) interpolates to 36, where the interpolated a would give 25.
Experiment experiment(const std::string& source, const std::vector<std::string>& varyings, int words) {
  Experiment e;
  e.request.vertex_sources = {source};
  e.request.refinement = core::Refinement::linear_outputs;
  e.record = make_record(
      {{"a", GL_FLOAT, {{{0}, {8}, {4}}}}, {"gl_VertexID", GL_INT, {{{bits(10)}, {bits(20)}, {bits(30)}}}}});
  e.varyings = varyings;
  e.captured_words = words;
  return e;
}

std::vector<float> middle(const Experiment& e) {
  const Refined refined = run(e);
  EXPECT_EQ(refined.error, "");
  return refined.error.empty() ? refined.values[3] : std::vector<float>{};
}

TEST(DeriveOutputs, ResultsOfTheCornersAreInterpolated) {
  ASSERT_TRUE(make_current(Api::core));
  const Experiment e = experiment(
      "#version 330 core\nin float a; out float square; void main() { square = a * a; gl_Position = vec4(square); }",
      {"square", "gl_Position"}, 5);
  EXPECT_EQ(middle(e), (std::vector<float>{36, 36, 36, 36, 36}));
}

TEST(DeriveOutputs, VertexIdIsThatOfTheCorners) {
  ASSERT_TRUE(make_current(Api::core));
  const Experiment e = experiment(
      "#version 330 core\nin float a; out float id; void main() { id = float(gl_VertexID) + 0.0 * a; gl_Position = "
      "vec4(1); }",
      {"id"}, 1);
  EXPECT_EQ(middle(e), (std::vector<float>{20}));
}

// The names of the array and of a swizzle are the same.
TEST(DeriveOutputs, AnArrayWithAnIndexIsWrittenAsAGlobal) {
  ASSERT_TRUE(make_current(Api::core));
  const Experiment e = experiment(
      "#version 330 core\nuniform int i; in float a; out float st[3]; void main() { st[2 - i] = a * a; st[i] = a; "
      "st[i + 1] = vec4(1, 2, 3, 4).st.x; gl_Position = vec4(st[2]); }",
      {"st[0]", "st[1]", "st[2]", "gl_Position"}, 7);
  EXPECT_EQ(middle(e), (std::vector<float>{5, 1, 36, 36, 36, 36, 36}));
  const Derivation derivation = derive_vertex_stage(e.request);
  EXPECT_NE(derivation.vertex_sources.at(0).find("glark_written_st[i]"), std::string::npos);
}

// The API sees the member of the structure, so its name must stay.
TEST(DeriveOutputs, AnArrayKeepsItsNameIfAMemberHasIt) {
  ASSERT_TRUE(make_current(Api::core));
  const Experiment e = experiment(
      "#version 330 core\nstruct S { int m; }; uniform S s; in float a; out float m[2]; void main() { m[s.m] = a; "
      "m[1] = a * a; gl_Position = vec4(1); }",
      {"m[0]", "m[1]"}, 2);
  EXPECT_EQ(middle(e), (std::vector<float>{5, 36}));
}

TEST(DeriveOutputs, FlatAndIntegerOutputsTakeTheProvokingCorner) {
  ASSERT_TRUE(make_current(Api::core));
  Experiment e = experiment(
      "#version 330 core\nin float a; flat out float f; flat out ivec2 i; void main() { f = a; i = ivec2(gl_VertexID); "
      "gl_Position = vec4(1); }",
      {"f", "i"}, 3);
  for (int provoking = 0; provoking < 3; ++provoking) {
    e.request.provoking_corner = provoking;
    const std::vector<float> values = middle(e);
    EXPECT_EQ(values.at(0), (std::array<float, 3>{0, 8, 4}[provoking]));
    EXPECT_EQ(std::bit_cast<int>(values.at(2)), (provoking + 1) * 10);
  }
}

TEST(DeriveOutputs, ArraysMatricesAndStructures) {
  ASSERT_TRUE(make_current(Api::core));
  const std::string source =
      "#version 330 core\nconst int n = 20; struct Inner { vec2 v[2]; }; struct S { float x; Inner inner; };\n"
      "in float a; out float small[3], large[n + 1]; out mat2 m; out S s;\n"
      "void main() { for (int i = 0; i < 3; ++i) small[i] = a * a + float(i); for (int i = 0; i <= n; ++i) large[i] = "
      "a * a - float(i);\n"
      "  m = mat2(a * a); s.x = a * a; s.inner.v[0] = vec2(a); s.inner.v[1] = vec2(2.0 * a); gl_Position = vec4(1.0); "
      "}";
  EXPECT_EQ(middle(experiment(source, {"small[2]", "large[20]", "m", "s.x", "s.inner.v[1]"}, 9)),
            (std::vector<float>{38, 16, 36, 0, 0, 36, 36, 10, 10}));
}

TEST(DeriveOutputs, BlocksWithAndWithoutInstanceNames) {
  ASSERT_TRUE(make_current(Api::core));
  const std::string source =
      "#version 430 core\nin float a; out Plain { vec2 p; flat float pf; }; out Named { float n[2]; } named; out Many "
      "{ float k; } many[2];\n"
      "out gl_PerVertex { vec4 gl_Position; float gl_ClipDistance[2]; };\n"
      "void main() { p = vec2(a * a); pf = a; named.n[1] = a * a; named.n[0] = 0.0; many[0].k = 1.0; many[1].k = a * "
      "a;\n"
      "  gl_Position = vec4(a * a); gl_ClipDistance[1] = a; gl_ClipDistance[0] = 1.0; }";
  EXPECT_EQ(middle(experiment(source, {"p", "pf", "Named.n[1]", "Many[1].k", "gl_Position"}, 9)),
            (std::vector<float>{36, 36, 4, 36, 36, 36, 36, 36, 36}));
}

TEST(DeriveOutputs, BuiltInVaryingsOfOldShaders) {
  ASSERT_TRUE(make_current(Api::compatibility));
  const std::string source =
      "attribute float a; varying vec2 open[];\n"
      "void main() { gl_Position = vec4(a * a); gl_FrontColor = vec4(a * a / 64.0); gl_TexCoord[0] = vec4(0.0); "
      "gl_TexCoord[1] = vec4(a * a + 1.0);\n"
      "  gl_FogFragCoord = a * a; gl_PointSize = a * a; gl_ClipVertex = vec4(a); open[0] = vec2(0.0); open[1] = vec2(a "
      "* a); }";
  EXPECT_EQ(
      middle(experiment(source, {"gl_FrontColor", "gl_TexCoord[1]", "gl_FogFragCoord", "gl_PointSize", "open[1]"}, 12)),
      (std::vector<float>{0.5625F, 0.5625F, 0.5625F, 0.5625F, 37, 37, 37, 37, 36, 36, 36, 36}));
}

TEST(DeriveOutputs, GlobalsStartAfreshAtEveryCorner) {
  ASSERT_TRUE(make_current(Api::core));
  const std::string source =
      "#version 420 core\nin float a; out float s; float sum = 1.0; float table[] = {2.0, 3.0};\n"
      "void main() { sum += a; table[1] += a; s = sum + table[1]; gl_Position = vec4(1.0); }";
  EXPECT_EQ(middle(experiment(source, {"s"}, 1)), (std::vector<float>{14}));
}

TEST(DeriveOutputs, OutputsAndGlobalsOfOtherCompilationUnits) {
  ASSERT_TRUE(make_current(Api::compatibility));
  Experiment e = experiment("", {"s", "t.x"}, 2);
  e.request.vertex_sources = {
      "#version 150\nin float a; struct T { float x; }; out T t; float sum = 1.0; void side() { sum += a; t.x = sum * "
      "sum; }",
      "#version 150\nin float a; out float s; void side(); void main() { side(); s = a * a; gl_Position = vec4(1.0); "
      "}"};
  // (1 + a)^2 = 1, 81, 25 at the corners.
  EXPECT_EQ(middle(e), (std::vector<float>{36, 47}));
}

TEST(DeriveOutputs, AnUnsizedArrayWithUnknownIndexIsRefusedByName) {
  Experiment e = experiment(
      "#version 120\nattribute float a; varying vec2 open[]; const int k = 1; void main() { open[k] = vec2(a); "
      "gl_Position = vec4(a); }",
      {"open[1]"}, 2);
  ASSERT_TRUE(make_current(Api::compatibility));
  EXPECT_NE(run(e).error.find("'open'"), std::string::npos);
  e.request.refinement = core::Refinement::linear_inputs;
  EXPECT_EQ(run(e).error, "");
}

// a = 0, 8, 4 gives a = 5 in the middle, where the stage runs: 25. Outputs that are unsound there are interpolated.
TEST(DeriveOutputs, UnsoundOutputsAreInterpolatedBesideOthers) {
  ASSERT_TRUE(make_current(Api::core));
  Experiment e = experiment(
      "#version 330 core\nin float a; out float square; out vec2 wrong; flat out float f; out Block { float b; } block;"
      "\nvoid main() { square = a * a; wrong = vec2(a * a, gl_VertexID); f = a; block.b = a * a; gl_Position = vec4(a "
      "* a); }",
      {"square", "wrong", "f", "Block.b", "gl_Position"}, 9);
  e.request.refinement = core::Refinement::linear_inputs;
  e.request.outputs.unsound = {"wrong"};
  EXPECT_EQ(middle(e), (std::vector<float>{25, 36, 20, 4, 25, 25, 25, 25, 25}));
  e.request.outputs.unsound = {"block.b"};
  EXPECT_EQ(middle(e).at(4), 36);
}

TEST(DeriveOutputs, UnsoundOutputsThatAreLinearOnTheScreen) {
  ASSERT_TRUE(make_current(Api::core));
  Experiment e = experiment(
      "#version 330 core\nin float a; noperspective out float wrong; struct S { float x; }; out S s;\n"
      "void main() { wrong = a * a; s.x = a * a; gl_Position = vec4(vec3(a), a == 8.0 ? 3.0 : 1.0); }",
      {"wrong", "s.x"}, 2);
  e.request.refinement = core::Refinement::linear_inputs;
  e.request.outputs.unsound = {"wrong", "s.x"};
  // The weights 1/4, 1/2, 1/4 become 1/8, 6/8, 1/8 on the screen: 6/8 64 + 1/8 16 = 50.
  EXPECT_EQ(middle(e), (std::vector<float>{50, 36}));
}

TEST(DeriveOutputs, UnsoundOutputsOfOtherCompilationUnits) {
  ASSERT_TRUE(make_current(Api::compatibility));
  Experiment e = experiment("", {"s", "t"}, 2);
  e.request.vertex_sources = {
      "#version 150\nin float a; out float t; float sum = 1.0; void side() { sum += a; t = sum * sum; }",
      "#version 150\nin float a; out float s; void side(); void main() { side(); s = a * a; gl_Position = vec4(1.0); "
      "}"};
  e.request.refinement = core::Refinement::linear_inputs;
  e.request.outputs.unsound = {"t"};
  // (1 + a)^2 = 1, 81, 25 at the corners.
  EXPECT_EQ(middle(e), (std::vector<float>{25, 47}));
}

}  // namespace
}  // namespace glark::refine::test
