// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The analysis follows values through every construct of GLSL.
#include <algorithm>
#include <set>

#include "tests/core/refine/soundness/soundness_harness.h"

namespace glark::refine {
namespace {

TEST(DataFlow, OperationsHaveTheirVariation) {
  EXPECT_EQ(position_of(stage("gl_Position = vec4(u);")), Variation::constant);
  EXPECT_EQ(position_of(stage("gl_Position = m * (p + vec4(f * u)) - p / 3.0;")), Variation::affine);
  EXPECT_EQ(position_of(stage("gl_Position = mix(p, -p, u);")), Variation::affine);
  EXPECT_EQ(position_of(stage("gl_Position = vec4(dot(p, m[0]), cross(p.xyz, m[1].xyz));")), Variation::affine);
  EXPECT_EQ(position_of(stage("gl_Position = p * f;")), Variation::continuous);
  EXPECT_EQ(position_of(stage("gl_Position = u / p;")), Variation::continuous);
  EXPECT_EQ(position_of(stage("gl_Position = mix(p, -p, f);")), Variation::continuous);
  EXPECT_EQ(position_of(stage("gl_Position = clamp(normalize(p), 0.0, u);")), Variation::continuous);
  EXPECT_EQ(position_of(stage("gl_Position = step(p, vec4(u));")), Variation::switched);
  EXPECT_EQ(position_of(stage("gl_Position = vec4(f > u);")), Variation::switched);
  EXPECT_EQ(position_of(stage("gl_Position = p - vec4(f == u);")), Variation::undefined);
  EXPECT_EQ(position_of(stage("gl_Position = vec4(mod(f, 2.0));")), Variation::undefined);
  EXPECT_EQ(position_of(stage("gl_Position = vec4(float(int(f)));")), Variation::undefined);
  EXPECT_EQ(position_of(stage("gl_Position = vec4(n);")), Variation::undefined);
}

TEST(DataFlow, OperationsOnUniformsAreConstant) {
  EXPECT_EQ(position_of(stage("gl_Position = vec4(mod(floor(u), 2.0)) * float(int(u) & 3);")), Variation::constant);
  EXPECT_EQ(position_of(stage("gl_Position = u > 1.0 ? p : vec4(gl_InstanceID);")), Variation::affine);
}

TEST(DataFlow, AttributesThatAreConstantOverATriangle) {
  const auto position_with = [](const std::string& body, const std::set<std::string>& constants) {
    return output_of(inspect_vertex_stage({stage(body)}, false, {}, constants).traits.variation, "gl_Position");
  };
  EXPECT_EQ(position_with("gl_Position = p * float(n & 3);", {"n"}), Variation::affine);
  EXPECT_EQ(position_with("gl_Position = p * float(n & 3);", {"f"}), Variation::undefined);
  EXPECT_EQ(position_with("gl_Position = p * mod(f, 2.0);", {"f", "n"}), Variation::affine);
  EXPECT_EQ(position_with("gl_Position = vec4(n);", {"n"}), Variation::constant);
}

TEST(DataFlow, ComponentsAreApart) {
  const std::string parts = "vec4 t; t.xyz = p.xyz; t.w = floor(f);";
  EXPECT_EQ(position_of(stage(parts + "gl_Position = vec4(t.zyx, 1.0);")), Variation::affine);
  EXPECT_EQ(position_of(stage(parts + "gl_Position = t.xxxw;")), Variation::undefined);
  EXPECT_EQ(position_of(stage(parts + "t.w = 1.0; gl_Position = t;")), Variation::affine);
  EXPECT_EQ(position_of(stage(parts + "t.wzyx.xy = vec2(0.0); gl_Position = t;")), Variation::affine);
  EXPECT_EQ(position_of(stage("vec4 t = vec4(fract(p.x), p.yz, 1.0); gl_Position = vec4(t.y);")), Variation::affine);
}

TEST(DataFlow, MembersOfStructuresAreApart) {
  const std::string type = "struct S { vec4 a; float b[2]; };";
  EXPECT_EQ(position_of(stage("S s; s.a = p; s.b[0] = floor(f); S t = s; gl_Position = t.a;", type)),
            Variation::affine);
  EXPECT_EQ(position_of(stage("S s; s.a = p; s.b[0] = floor(f); gl_Position = vec4(s.b[1]);", type)),
            Variation::undefined);
  EXPECT_EQ(position_of(stage("S s = S(p, float[2](f, floor(f))); gl_Position = s.a;", type)), Variation::affine);
}

TEST(DataFlow, ArraysAreFollowed) {
  EXPECT_EQ(position_of(stage("vec4 a[3]; a[1] = p; gl_Position = a[0];")), Variation::affine);
  EXPECT_EQ(position_of(stage("gl_Position = a[int(f)];", "uniform vec4 a[3];")), Variation::undefined);
  EXPECT_EQ(position_of(stage("vec4 a[3]; a[int(f)] = vec4(1); gl_Position = a[0];")), Variation::undefined);
  EXPECT_EQ(position_of(stage("gl_Position = a[int(u)] * p.x;", "uniform vec4 a[3];")), Variation::affine);
}

TEST(DataFlow, FunctionsReturnAndWriteTheirArguments) {
  const std::string functions =
      "float twice(float x) { return 2.0 * x; }\n"
      "void split(in vec4 v, out vec4 whole, inout float rest) { whole = floor(v); rest += v.x; }\n";
  EXPECT_EQ(position_of(stage("gl_Position = p * twice(u);", functions)), Variation::affine);
  EXPECT_EQ(position_of(stage("gl_Position = vec4(twice(floor(f)));", functions)), Variation::undefined);
  EXPECT_EQ(position_of(stage("vec4 w; float r = u; split(p, w, r); gl_Position = vec4(r);", functions)),
            Variation::affine);
  EXPECT_EQ(position_of(stage("vec4 w; float r = u; split(p, w, r); gl_Position = w;", functions)),
            Variation::undefined);
  EXPECT_EQ(position_of(stage("gl_Position = p * twice(floor(u)) + twice(f);", functions)), Variation::affine);
}

TEST(DataFlow, EarlyReturnsDecideWhatFollows) {
  const std::string function = "vec4 g(vec4 v) { if (v.x > 0.0) return v; return -v; }";
  EXPECT_EQ(position_of(stage("gl_Position = g(p);", function)), Variation::switched);
  EXPECT_EQ(position_of(stage("gl_Position = g(m[0]) + p;", function)), Variation::affine);
  EXPECT_EQ(position_of(stage("gl_Position = p; if (f > u) return; gl_Position = vec4(u);")), Variation::switched);
  EXPECT_EQ(position_of(stage("if (u > 1.0) { gl_Position = floor(p); return; } gl_Position = p;")),
            Variation::undefined);
}

TEST(DataFlow, ConditionsDecideAssignments) {
  EXPECT_EQ(position_of(stage("vec4 t = p; if (f > 0.5) t = vec4(u); gl_Position = t;")), Variation::switched);
  EXPECT_EQ(position_of(stage("vec4 t = p; if (n > 3) t = vec4(u); gl_Position = t;")), Variation::undefined);
  EXPECT_EQ(position_of(stage("vec4 t = p; if (u > 3.0) t = floor(p); gl_Position = t;")), Variation::undefined);
  EXPECT_EQ(position_of(stage("vec4 t = floor(p); if (u > 3.0) t = p; else t = -p; gl_Position = t;")),
            Variation::affine);
  EXPECT_EQ(position_of(stage("float t = u; bool b = f > u && (t = 2.0) > 1.0; gl_Position = vec4(t);")),
            Variation::switched);
}

TEST(DataFlow, LoopsRunUntilNothingChanges) {
  EXPECT_EQ(position_of(stage("vec4 a, b, c; for (int i = 0; i < 4; ++i) { c = b; b = a; a = floor(p); }"
                              "gl_Position = c;")),
            Variation::undefined);
  EXPECT_EQ(position_of(stage("vec4 t = p; for (int i = 0; i < 4; ++i) t += m[i]; gl_Position = t;")),
            Variation::affine);
  EXPECT_EQ(position_of(stage("int i = 0; while (float(i) < f) ++i; gl_Position = vec4(i);")), Variation::switched);
  EXPECT_EQ(position_of(stage("vec4 t = p; for (int i = 0; i < 4; ++i) { t = floor(p); if (u > 1.0) break; t = p; }"
                              "gl_Position = t;")),
            Variation::undefined);
  EXPECT_EQ(position_of(stage("vec4 t = p; for (int i = 0; i < 4; ++i) { if (f > 1.0) continue; t += vec4(1); }"
                              "gl_Position = t;")),
            Variation::switched);
}

TEST(DataFlow, SwitchesJoinTheirCases) {
  const std::string cases = "vec4 t; switch (int(u)) { case 0: t = p; break; default: t = X; } gl_Position = t;";
  const auto with = [&](const std::string& value) {
    std::string body = cases;
    return stage(body.replace(body.find('X'), 1, value));
  };
  EXPECT_EQ(position_of(with("-p")), Variation::affine);
  EXPECT_EQ(position_of(with("ceil(p)")), Variation::undefined);
  EXPECT_EQ(position_of(stage("vec4 t = p; switch (n) { case 0: t = -p; } gl_Position = t;")), Variation::undefined);
}

// The syntax tree does not tell variables of one name apart.
TEST(DataFlow, VariablesOfInnerBlocksHideOthers) {
  EXPECT_EQ(position_of(stage("float t = floor(f); { float t = u; t += 1.0; } gl_Position = vec4(t);")),
            Variation::undefined);
  EXPECT_EQ(position_of(stage("{ float t = floor(f); } { float t = f; gl_Position = vec4(t); }")), Variation::affine);
  EXPECT_EQ(position_of(stage("vec4 f = p; { float f = u; } gl_Position = f;")), Variation::affine);
  EXPECT_EQ(position_of(stage("gl_Position = vec4(g(u));", "float g(float f) { return 2.0 * f; }")),
            Variation::constant);
}

TEST(DataFlow, GlobalsAndInitialisersAreFollowed) {
  EXPECT_EQ(position_of(stage("g += 1.0; gl_Position = vec4(g);", "float g = 2.0;")), Variation::constant);
  EXPECT_EQ(position_of(stage("h(); gl_Position = vec4(g);", "float g = 2.0; void h() { g = fract(f); }")),
            Variation::undefined);
}

TEST(DataFlow, SeveralShaderObjectsShareGlobalsAndFunctions) {
  const std::string first =
      "#version 330\nin vec4 p; float g; vec4 place(vec4 v); void main() { g = 1.0; gl_Position = place(p); }";
  const std::string second = "#version 330\nfloat g; vec4 place(vec4 v) { return v * g; }";
  const std::string third = "#version 330\nfloat g; vec4 place(vec4 v) { return floor(v) * g; }";
  EXPECT_EQ(output_of(variation_of({first, second}), "gl_Position"), Variation::affine);
  const StageVariation floored = variation_of({first, third});
  EXPECT_EQ(output_of(floored, "gl_Position"), Variation::undefined);
  EXPECT_EQ(floored.position()->reason, "vertex shader 1, line 2: floor() of 'p'");
}

TEST(DataFlow, OutputsAreApart) {
  const StageVariation blocks = variation_of({stage("o.uv = p.xy; o.id = floor(f); plain = f; gl_Position = p;",
                                                    "out O { vec2 uv; float id; } o; out P { float plain; };")});
  EXPECT_EQ(output_of(blocks, "o.uv"), Variation::affine);
  EXPECT_EQ(output_of(blocks, "o.id"), Variation::undefined);
  EXPECT_EQ(output_of(blocks, "plain"), Variation::affine);
  EXPECT_EQ(output_of(blocks, "gl_Position"), Variation::affine);
}

TEST(DataFlow, TheInputsAndTheInterpolationOfOutputsAreKnown) {
  const StageVariation stage_variation = variation_of(
      {stage("o.uv = p.xy; o.id = f; plain = f; s[1].a = p; s[0].a = p; gl_Position = p + f;",
             "struct S { vec4 a; }; out O { vec2 uv; flat float id; } o; out float plain; flat out S s[2];")});
  const auto expect = [&](const char* path, Interpolation interpolation, const std::set<std::string>& inputs) {
    const OutputVariation* const output = stage_variation.find(path);
    ASSERT_NE(output, nullptr) << path;
    EXPECT_EQ(output->interpolation, interpolation) << path;
    EXPECT_EQ(output->inputs, inputs) << path;
  };
  expect("o.uv", Interpolation::always, {"p"});
  expect("o.id", Interpolation::never, {"f"});
  expect("plain", Interpolation::always, {"f"});
  expect("gl_Position", Interpolation::always, {"p", "f"});
  EXPECT_TRUE(
      std::any_of(stage_variation.outputs.begin(), stage_variation.outputs.end(), [](const OutputVariation& output) {
        return output.path.starts_with("s") && output.interpolation == Interpolation::never;
      }));
  const StageVariation colors =
      variation_of({"void main() { gl_FrontColor = gl_Normal.xyzz; gl_Position = gl_Vertex; }"});
  EXPECT_EQ(colors.find("gl_FrontColor")->interpolation, Interpolation::unless_flat_shaded);
}

TEST(DataFlow, RedeclaredAndLaterPositionsAreFound) {
  EXPECT_EQ(position_of("#version 450\nout gl_PerVertex { vec4 gl_Position; };\nlayout(location = 0) in vec4 p;\n"
                        "void main() { gl_Position = round(p); }"),
            Variation::undefined);
  EXPECT_EQ(position_of("void main() { gl_Position = ftransform(); }"), Variation::affine);
  EXPECT_EQ(position_of("attribute vec4 p; void main() { gl_Position = floor(p); }", true), Variation::undefined);
}

TEST(DataFlow, ReasonsNameTheLineTheConstructAndTheInput) {
  EXPECT_EQ(reason_of(stage("gl_Position = vec4(floor(f + u));")), "line 4: floor() of 'f'");
  EXPECT_EQ(reason_of(stage("float t = p.x * f;\n if (t > u) gl_Position = p;")), "line 5: comparison of 'p', 'f'");
  EXPECT_EQ(reason_of(stage("gl_Position = m[n];")), "line 4: integer value of 'n'");
  EXPECT_EQ(reason_of(stage("gl_Position = m[int(f)];")), "line 4: integer conversion of 'f'");
  EXPECT_EQ(reason_of(stage("gl_Position = texelFetch(t, ivec2(p.xy), 0);", "uniform sampler2D t;")),
            "line 4: integer conversion of 'p'");
  EXPECT_EQ(reason_of(stage("gl_Position = vec4(gl_VertexID);")), "line 4: integer value of 'gl_VertexID'");
  EXPECT_EQ(reason_of(stage("gl_Position = p;")), "");
}

TEST(DataFlow, StagesThatAreTooLargeAreNotAnalysed) {
  std::string calls = "vec4 f0(vec4 v) { return v; }\n";
  for (int i = 1; i <= 18; ++i) {
    const std::string before = "f" + std::to_string(i - 1) + "(v)";
    calls += "vec4 f" + std::to_string(i) + "(vec4 v) { return " + before + " + " + before + "; }\n";
  }
  EXPECT_EQ(reason_of(stage("gl_Position = f18(p);", calls)), "the vertex stage could not be analysed");
}

}  // namespace
}  // namespace glark::refine
