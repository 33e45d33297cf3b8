// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Each operation of GLSL is known by the words that glslang has for it. Words that change make an operation undefined.
#include "tests/core/refine/soundness/soundness_harness.h"

namespace glark::refine {
namespace {

// How gl_Position varies if it is that expression of p, f, u and m.
Variation of(const std::string& expression) {
  return position_of(
      "#version 450\nin vec4 p; in float f; uniform float u; uniform mat4 m; uniform mat3 k;\nvoid main() { "
      "gl_Position = vec4(0.0) + " +
      expression + "; }\n");
}

TEST(Operations, Affine) {
  for (const char* expression : {"-p",
                                 "p + u",
                                 "p - m[1]",
                                 "radians(p)",
                                 "degrees(f)",
                                 "p * m",
                                 "m * p",
                                 "u * p",
                                 "p / u",
                                 "p * m[0]",
                                 "fma(p, m[0], p)",
                                 "mix(p, m[0], u)",
                                 "dot(p, m[0])",
                                 "vec4(cross(p.xyz, m[0].xyz), f)",
                                 "transpose(outerProduct(p, m[0]))[1]",
                                 "matrixCompMult(m, mat4(f))[2]",
                                 "(m * mat4(f))[3]",
                                 "(mat4(f) * u)[0]",
                                 "vec4(double(f))",
                                 "p.wzyx",
                                 "(u > 1.0 ? p : -p)",
                                 "(u + 1.0, p)"}) {
    EXPECT_EQ(of(expression), Variation::affine) << expression;
  }
}

TEST(Operations, Continuous) {
  for (const char* name :
       {"sin",   "cos", "tan", "asin", "acos", "atan", "sinh",        "cosh", "tanh",   "asinh",    "acosh",
        "atanh", "exp", "log", "exp2", "log2", "sqrt", "inversesqrt", "abs",  "length", "normalize"}) {
    EXPECT_EQ(of(name + std::string("(p)")), Variation::continuous) << name;
  }
  for (const char* expression : {"p * f", "pow(p, m[0])", "min(p, u)", "max(p, m[0])", "clamp(p, 0.0, 1.0)",
                                 "smoothstep(0.0, 1.0, p)", "atan(p, m[0])", "distance(p, m[0])", "reflect(p, m[0])",
                                 "refract(p, m[0], u)", "determinant(k * f)", "vec4(inverse(k * f)[0], 1.0)"}) {
    EXPECT_EQ(of(expression), Variation::continuous) << expression;
  }
}

TEST(Operations, Switched) {
  for (const char* expression : {"vec4(f < u)",
                                 "vec4(f > u)",
                                 "vec4(f <= u)",
                                 "vec4(f >= u)",
                                 "vec4(lessThan(p, m[0]))",
                                 "vec4(greaterThan(p, m[0]))",
                                 "vec4(lessThanEqual(p, m[0]))",
                                 "vec4(greaterThanEqual(p, m[0]))",
                                 "sign(p)",
                                 "step(p, m[0])",
                                 "faceforward(p, m[0], m[1])",
                                 "vec4(isnan(p))",
                                 "vec4(isinf(p))",
                                 "vec4(bvec4(p))",
                                 "vec4(!(f < u))",
                                 "vec4(not(lessThan(p, m[0])))",
                                 "vec4(any(lessThan(p, m[0])))",
                                 "vec4(all(lessThan(p, m[0])))",
                                 "vec4(f < u && u < 1.0)",
                                 "vec4(u < 1.0 || f < u)",
                                 "vec4(f < u ^^ u < 1.0)"}) {
    EXPECT_EQ(of(expression), Variation::switched) << expression;
  }
}

TEST(Operations, UndefinedAndNamed) {
  const auto reason = [](const std::string& expression) {
    return reason_of("#version 450\nin vec4 p; in float f; uniform vec4 v;\nvoid main() { gl_Position = vec4(" +
                     expression + "); }\n");
  };
  for (const char* name : {"floor", "trunc", "round", "roundEven", "ceil", "fract"}) {
    EXPECT_EQ(reason(name + std::string("(p)")), "line 3: " + std::string(name) + "() of 'p'");
  }
  EXPECT_EQ(reason("mod(p, 2.0)"), "line 3: mod() of 'p'");
  EXPECT_EQ(reason("modf(p, gl_Position)"), "line 3: modf() of 'p'");
  EXPECT_EQ(reason("p == v"), "line 3: test for equality of 'p'");
  EXPECT_EQ(reason("p != v"), "line 3: test for equality of 'p'");
  EXPECT_EQ(reason("equal(p, v)"), "line 3: test for equality of 'p'");
  EXPECT_EQ(reason("notEqual(p, v)"), "line 3: test for equality of 'p'");
  EXPECT_EQ(reason("ivec4(p)"), "line 3: integer conversion of 'p'");
  EXPECT_EQ(reason("floatBitsToInt(f)"), "line 3: an integer or unknown operation of 'f'");
}

TEST(Operations, AssignmentsContainOperations) {
  const auto after = [](const std::string& statement) {
    return position_of(stage("vec4 t = m[0]; mat4 a = m; " + statement + " gl_Position = t;"));
  };
  for (const char* statement : {"t += p;", "t -= p;", "t *= p;", "t *= f;", "t /= u; t += p;", "t = p; t *= m;",
                                "a *= f; t = a[0];", "a *= m; t = a * p;", "t = p; t.x++; --t.y;"}) {
    EXPECT_EQ(after(statement), Variation::affine) << statement;
  }
  EXPECT_EQ(after("t = p; t *= f;"), Variation::continuous);
  EXPECT_EQ(after("t /= f;"), Variation::continuous);
  EXPECT_EQ(after("int i = n; i <<= 1; i &= 3; t = vec4(i);"), Variation::undefined);
}

TEST(Operations, Textures) {
  const auto with = [](const std::string& expression) {
    return position_of(
        "#version 450\nin vec4 p; uniform sampler2D t; uniform isampler2D n; uniform sampler2DShadow s;\n"
        "layout(rgba8) uniform image2D i;\nvoid main() { gl_Position = vec4(" +
        expression + "); }\n");
  };
  for (const char* expression :
       {"texture(t, p.xy)", "textureLod(t, p.xy, 1.0)", "textureProj(t, p)", "texture(s, p.xyz)",
        "textureGrad(t, p.xy, p.xy, p.zw)", "textureOffset(t, p.xy, ivec2(1))"}) {
    EXPECT_EQ(with(expression), Variation::continuous) << expression;
  }
  for (const char* expression :
       {"texture(n, p.xy)", "textureGather(t, p.xy)", "texelFetch(t, ivec2(p.xy), 0)", "imageLoad(i, ivec2(p.xy))"}) {
    EXPECT_EQ(with(expression), Variation::undefined) << expression;
  }
  EXPECT_EQ(with("textureSize(t, 0), 1.0, 1.0"), Variation::constant);
}

}  // namespace
}  // namespace glark::refine
