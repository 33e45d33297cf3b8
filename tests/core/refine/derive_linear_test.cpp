// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Refinement::linear_inputs: the application's vertex stage runs on interpolated inputs.
#include <gtest/gtest.h>

#include <bit>

#include "tests/core/refine/support/derive_harness.h"

namespace glark::refine::test {
namespace {

FieldValues vertices() { return {"gl_Vertex", GL_FLOAT_VEC4, {{{0, 0, 0, 1}, {8, 0, 2, 1}, {0, 16, 4, 1}}}}; }

Experiment experiment(const std::string& source, const std::vector<FieldValues>& fields,
                      const std::vector<std::string>& varyings, int words) {
  Experiment e;
  e.request.vertex_sources = {source};
  e.record = make_record(fields);
  e.varyings = varyings;
  e.captured_words = words;
  return e;
}

TEST(DeriveLinear, BuiltInVertexIsInterpolated) {
  ASSERT_TRUE(make_current(Api::compatibility));
  const Refined refined = run(experiment("void main() { gl_Position = gl_Vertex; }", {vertices()}, {"gl_Position"}, 4));
  ASSERT_EQ(refined.error, "");
  EXPECT_EQ(refined.values[0], (std::vector<float>{0, 0, 0, 1}));
  EXPECT_EQ(refined.values[1], (std::vector<float>{8, 0, 2, 1}));
  EXPECT_EQ(refined.values[2], (std::vector<float>{0, 16, 4, 1}));
  EXPECT_EQ(refined.values[3], (std::vector<float>{4, 4, 2, 1}));  // w = 1/4, u = 1/2, v = 1/4
}

TEST(DeriveLinear, StageRunsOnTheRefinedVertexNotOnTheCorners) {
  ASSERT_TRUE(make_current(Api::core));
  const std::string source =
      "#version 330 core\nin float a; out float square; void main() { square = a * a; gl_Position = vec4(0.0); }";
  const Refined refined = run(experiment(source, {{"a", GL_FLOAT, {{{0}, {8}, {4}}}}}, {"square"}, 1));
  ASSERT_EQ(refined.error, "");
  EXPECT_EQ(refined.values[3][0], 25.0F);  // (8/2 + 4/4)^2, where the squares interpolate to 36
}

TEST(DeriveLinear, PatchPlacesThePieceWithAllRotations) {
  ASSERT_TRUE(make_current(Api::compatibility));
  Experiment e =
      experiment("void main() { gl_Position = gl_Vertex; }",
                 {{"gl_Vertex", GL_FLOAT_VEC4, {{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}}}}}, {"gl_Position"}, 4);
  // The tile with corner 0 at (u, v) = (1/4, 1/2) and half size -1/4; local corner k is tile corner (k + r) mod 3.
  const std::vector<std::array<float, 2>> tile = {{0.25F, 0.5F}, {0, 0.5F}, {0.25F, 0.25F}};
  for (int rotation = 0; rotation < 3; ++rotation) {
    e.patch = {0.25F, 0.5F, -0.25F, static_cast<float>(rotation)};
    const Refined refined = run(e);
    ASSERT_EQ(refined.error, "");
    for (int corner = 0; corner < 3; ++corner) {
      const auto& expected = tile[(corner + rotation) % 3];
      EXPECT_EQ(refined.values[corner], (std::vector<float>{expected[0], expected[1], 0, 1}))
          << rotation << " " << corner;
    }
  }
}

TEST(DeriveLinear, MatrixAndArrayInputsAreUnpackedElementByElement) {
  ASSERT_TRUE(make_current(Api::core));
  const std::string source =
      "#version 330 core\nlayout(location = 1) in mat2x3 m; in vec2 a[2]; out vec3 c0; out vec3 c1; out vec2 e0; out "
      "vec2 e1;\n"
      "void main() { c0 = m[0]; c1 = m[1]; e0 = a[0]; e1 = a[1]; gl_Position = vec4(1.0); }";
  const FieldValues m = {
      "m", GL_FLOAT_MAT2x3, {{{1, 2, 3, 4, 5, 6}, {11, 12, 13, 14, 15, 16}, {21, 22, 23, 24, 25, 26}}}};
  const FieldValues a = {"a", GL_FLOAT_VEC2, {{{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}}}, capture::Role::other,
                         2,   true};
  const Refined refined = run(experiment(source, {m, a}, {"c0", "c1", "e0", "e1"}, 10));
  ASSERT_EQ(refined.error, "");
  EXPECT_EQ(refined.values[1], (std::vector<float>{11, 12, 13, 14, 15, 16, 5, 6, 7, 8}));
  EXPECT_EQ(refined.values[3],
            (std::vector<float>{11, 12, 13, 14, 15, 16, 5, 6, 7, 8}));  // the means of these arithmetic series
}

TEST(DeriveLinear, IntegerInputsTakeTheProvokingCornerBitByBit) {
  for (const std::string version : {"130", "330"}) {
    ASSERT_TRUE(make_current(Api::compatibility));
    const std::string source = "#version " + version +
                               "\nin ivec2 i; in uint n; flat out ivec2 oi; flat out uint on;\n"
                               "void main() { oi = i; on = n; gl_Position = vec4(1.0); }";
    const FieldValues i = {"i", GL_INT_VEC2, {{{bits(1), bits(-2)}, {bits(3), bits(-4)}, {bits(5), bits(-6)}}}};
    const FieldValues n = {"n", GL_UNSIGNED_INT, {{{bits(7)}, {bits(-1)}, {bits(9)}}}};
    Experiment e = experiment(source, {i, n}, {"oi", "on"}, 3);
    e.request.provoking_corner = 1;
    const Refined refined = run(e);
    ASSERT_EQ(refined.error, "");
    for (const auto& vertex : refined.values) {
      EXPECT_EQ(std::bit_cast<std::int32_t>(vertex[0]), 3);
      EXPECT_EQ(std::bit_cast<std::int32_t>(vertex[1]), -4);
      EXPECT_EQ(std::bit_cast<std::uint32_t>(vertex[2]), 0xffffffffU);
    }
  }
}

TEST(DeriveLinear, DoubleInputsKeepTheirPrecision) {
  ASSERT_TRUE(make_current(Api::core));
  const std::string source =
      "#version 410 core\nin dvec2 d; out float low; void main() { low = float((d.y - 1.0LF) * 1e10LF); gl_Position = "
      "vec4(1.0); }";
  const auto words = [](double a, double b) {
    const std::array<double, 2> pair = {a, b};
    const auto w = std::bit_cast<std::array<float, 4>>(pair);
    return std::vector<float>(w.begin(), w.end());
  };
  const double small = 1 + 1e-10;
  const Refined refined = run(
      experiment(source, {{"d", GL_DOUBLE_VEC2, {{words(0, small), words(1, small), words(2, small)}}}}, {"low"}, 1));
  ASSERT_EQ(refined.error, "");
  EXPECT_NEAR(refined.values[3][0], 1.0F, 1e-3F);
}

TEST(DeriveLinear, FlatOutputsTakeTheProvokingCornerAndOthersDoNot) {
  ASSERT_TRUE(make_current(Api::core));
  const std::string source =
      "#version 330 core\nin float a; flat out float f; out float s; void main() { f = a + 1.0; s = a; gl_Position = "
      "vec4(1.0); }";
  for (int provoking = 0; provoking < 3; ++provoking) {
    Experiment e = experiment(source, {{"a", GL_FLOAT, {{{0}, {8}, {4}}}}}, {"f", "s"}, 2);
    e.request.provoking_corner = provoking;
    const Refined refined = run(e);
    ASSERT_EQ(refined.error, "");
    const float expected = std::array<float, 3>{1, 9, 5}[provoking];
    EXPECT_EQ(refined.values[3], (std::vector<float>{expected, 5}));
  }
}

TEST(DeriveLinear, FlatColorsOnlyWhenAsked) {
  ASSERT_TRUE(make_current(Api::compatibility));
  Experiment e = experiment("void main() { gl_FrontColor = gl_Color; gl_Position = gl_Vertex; }",
                            {vertices(), {"gl_Color", GL_FLOAT_VEC4, {{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}}}}},
                            {"gl_FrontColor"}, 4);
  EXPECT_EQ(run(e).values.at(3), (std::vector<float>{0.5F, 0.25F, 0, 1}));
  e.request.outputs.flat_colors = true;
  EXPECT_EQ(run(e).values.at(3), (std::vector<float>{0, 1, 0, 1}));
}

TEST(DeriveLinear, GlobalsAreInitialisedForEveryRunAndFromRefinedInputs) {
  ASSERT_TRUE(make_current(Api::core));
  const std::string source =
      "#version 330 core\nin float a; flat out float f; out float s; out float t;\n"
      "float sum = 10.0, twice = a * 2.0; void main() { sum += a; f = sum; s = sum; t = twice; gl_Position = "
      "vec4(1.0); }";
  const Refined refined = run(experiment(source, {{"a", GL_FLOAT, {{{0}, {8}, {4}}}}}, {"f", "s", "t"}, 3));
  ASSERT_EQ(refined.error, "");
  EXPECT_EQ(refined.values[3], (std::vector<float>{14, 15, 10}));
}

TEST(DeriveLinear, SystemValuesComeFromTheRecord) {
  ASSERT_TRUE(make_current(Api::core));
  const std::string source =
      "#version 330 core\nin float a; out float id; void main() { id = float(gl_InstanceID * 10 + gl_VertexID); "
      "gl_Position = vec4(a); }";
  const FieldValues vertex = {"gl_VertexID", GL_INT, {{{bits(4)}, {bits(5)}, {bits(6)}}}};
  const FieldValues instance = {"gl_InstanceID", GL_INT, {{{bits(7)}, {bits(7)}, {bits(7)}}}};
  const Refined refined = run(experiment(source, {{"a", GL_FLOAT, {{{0}, {8}, {4}}}}, vertex, instance}, {"id"}, 1));
  ASSERT_EQ(refined.error, "");
  EXPECT_EQ(refined.values[0][0], 76.0F);
}

}  // namespace
}  // namespace glark::refine::test
