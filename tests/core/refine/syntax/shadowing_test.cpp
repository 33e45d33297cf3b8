// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/syntax/shadowing.h"

#include <gtest/gtest.h>

namespace glark::refine {
namespace {

using Names = std::set<std::string>;

Names names_in(const std::string& body) { return shadowing_names(tokenize("void main() {" + body + "}")); }

TEST(Shadowing, InnerBlocksHideOuterVariables) {
  EXPECT_EQ(names_in("float x = 1.0; { float x = 2.0; } float y;"), Names{"x"});
  EXPECT_EQ(names_in("float x = f(1.0, z), y; if (x > 0.0) { vec2[2] y; }"), Names{"y"});
  EXPECT_EQ(names_in("for (int i = 0, j; i < 2; ++i) { int j = i; }"), Names{"j"});
  EXPECT_EQ(names_in("for (int i = 0; i < 2; ++i) for (int i = 0; i < 2; ++i) g();"), Names{"i"});
  EXPECT_EQ(names_in("float a[2] = {x, y}, b; { float b; }"), Names{"b"});
  EXPECT_EQ(names_in("struct S { float v; } s; { float s; }"), Names{"s"});
}

TEST(Shadowing, ParametersAreHidden) {
  EXPECT_EQ(shadowing_names(tokenize("int f(int n, float x) { { float x = 1.0; } return n; }")), Names{"x"});
  EXPECT_EQ(shadowing_names(tokenize("int f(int n); void g() { { int n; } }")), Names{});
}

TEST(Shadowing, BlocksSideBySideHideNothing) {
  EXPECT_EQ(names_in("{ float x; } { float x; } for (int i;;) {} for (int i;;) {}"), Names{});
  EXPECT_EQ(names_in("float x; { x = f(x, x); return x; } if (a) g(); else x = 1.0;"), Names{});
}

}  // namespace
}  // namespace glark::refine
