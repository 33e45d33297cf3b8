// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The tree that glslang writes, as this release of glslang writes it.
#include "glark/core/refine/syntax/syntax_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "glark/core/refine/glsl/frontend.h"

namespace glark::refine {
namespace {

Parsed parse_body(const std::string& body, const std::string& declarations = "") {
  Parsed parsed = parse_vertex_shader(
      "#version 430\nin vec4 p; in float f; uniform float u;\n" + declarations + "\nvoid main() {\n" + body + "\n}\n",
      false);
  EXPECT_TRUE(parsed.ok) << parsed.error;
  return parsed;
}

// The statements of main().
const std::vector<SyntaxNode>& statements_of(const Parsed& parsed) {
  for (const SyntaxNode& part : parsed.tree->parts()) {
    if (part.kind == NodeKind::function && part.words == "main(") return part.children[1].children;
  }
  throw std::runtime_error("there is no main()");
}

TEST(SyntaxTree, OperationsHaveTheirOperandsTypeAndLine) {
  const Parsed parsed = parse_body("\ngl_Position = p * 2.0;");
  const SyntaxNode& assignment = statements_of(parsed).at(0);
  EXPECT_TRUE(assignment.is("move second child to first child"));
  EXPECT_EQ(assignment.line, 6);
  ASSERT_EQ(assignment.children.size(), 2U);
  EXPECT_EQ(assignment.children[0].member, "gl_Position");
  const SyntaxNode& product = assignment.children[1];
  EXPECT_EQ(product.type->vector_size, 4U);
  EXPECT_EQ(product.children[0].kind, NodeKind::symbol);
  EXPECT_EQ(product.children[1].kind, NodeKind::constant);
  EXPECT_EQ(product.children[1].count, 1U);
}

TEST(SyntaxTree, SelectionsAndLoopsKnowTheirParts) {
  const Parsed parsed = parse_body(
      "vec4 t; if (f > u) {} else { t = p; }\n for (int i = 0; i < 3; i++) { if (f > 1.0) break; t += p; }\n"
      "do { t = p; } while (f > t.x); gl_Position = f > u ? t : p;");
  const std::vector<SyntaxNode>& statements = statements_of(parsed);
  EXPECT_NE(statements[0].part(Role::condition), nullptr);
  EXPECT_EQ(statements[0].part(Role::true_case), nullptr);
  EXPECT_NE(statements[0].part(Role::false_case), nullptr);
  const SyntaxNode& loop = statements[1].children[1];
  EXPECT_TRUE(loop.kind == NodeKind::loop && loop.tests_first);
  EXPECT_TRUE(loop.part(Role::test) && loop.part(Role::body) && loop.part(Role::terminal));
  EXPECT_FALSE(statements[2].tests_first);
  EXPECT_NE(statements[3].children[1].part(Role::true_case), nullptr);
}

TEST(SyntaxTree, LocalVariablesAreNumberedInTheirFunction) {
  const Parsed parsed = parse_body("float x = f; x = g(x); gl_Position = vec4(x, h, h, h);",
                                   "float h = 2.0; float g(float x) { return x; }");
  const std::vector<SyntaxNode>& statements = statements_of(parsed);
  const SyntaxNode& first = statements[0].children[0].children[0];
  const SyntaxNode& call = statements[1].children[1];
  EXPECT_EQ(call.kind, NodeKind::call);
  EXPECT_EQ(call.children[0].local, first.local);
  EXPECT_GE(first.local, 0);
  EXPECT_LT(statements[2].children[1].children[1].local, 0);  // h
  const auto function = std::find_if(parsed.tree->parts().begin(), parsed.tree->parts().end(),
                                     [](const SyntaxNode& part) { return part.words == "g(f1;"; });
  ASSERT_NE(function, parsed.tree->parts().end());
  EXPECT_EQ(call.words, function->words);
  const SyntaxNode& parameter = function->children[0].children[0];
  EXPECT_GE(parameter.local, 0);
  EXPECT_NE(parameter.local, first.local);
}

// A parameter may have the name of an input. An initialiser after the function means the input.
TEST(SyntaxTree, ParametersAreNoInputs) {
  const Parsed parsed = parse_body("gl_Position = vec4(g(1.0));", "float g(float f) { return f; }\nfloat h = f;");
  for (const SyntaxNode& part : parsed.tree->parts()) {
    if (part.words == "g(f1;") {
      EXPECT_GE(part.children[1].children[0].children[0].local, 0);
    }
    if (part.kind == NodeKind::sequence) {
      EXPECT_LT(part.children[0].children[1].local, 0);
    }
  }
}

TEST(SyntaxTree, WritesToMemory) {
  const std::string declarations =
      "layout(rgba8) uniform image2D i; layout(binding = 0, offset = 0) uniform atomic_uint c;\n"
      "layout(binding = 1) buffer B { int n; vec4 v[]; } b; layout(binding = 2) buffer P { int plain; };\n"
      "void change(out int x) { x = 1; } void read(int x) {} void elsewhere(int x);\n";
  for (const char* body : {"b.v[3].x = 1.0;", "plain++;", "--b.n;", "change(plain);", "imageAtomicAdd(j, ivec2(0), 1);",
                           "atomicExchange(b.n, 2);", "if (f > u) { while (true) { plain |= 1; } }"}) {
    EXPECT_TRUE(parse_body(body, declarations + "layout(r32i) uniform iimage2D j;").writes_memory) << body;
  }
  for (const char* body : {"read(plain);", "int x = plain; x++;", "gl_Position = imageLoad(i, ivec2(b.n));"}) {
    EXPECT_FALSE(parse_body(body, declarations).writes_memory) << body;
  }
  EXPECT_TRUE(parse_body("elsewhere(plain);", declarations).writes_memory);  // its parameter may be one for output
}

}  // namespace
}  // namespace glark::refine
