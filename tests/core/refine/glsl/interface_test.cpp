// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The tokenizer and the reader of global declarations.
#include <gtest/gtest.h>

#include "glark/core/refine/glsl/interface.h"
#include "glark/core/refine/glsl/tokens.h"

namespace glark::refine {
namespace {

TEST(GlslTokens, TextIsKeptToTheByte) {
  for (const char* text :
       {"", " ", "a", "#version 120\nvoid main(){}\n", "x/*c*/+++y//e\n", "1.5e-3f.x 0x1u .5\n  # define A \\\n  b\nc",
        "\x80@$`\"'", "a //\\\nstill a comment\nb", "/* open", "#"}) {
    EXPECT_EQ(to_text(tokenize(text)), text);
  }
}

TEST(GlslTokens, KindsAndLines) {
  const Tokens tokens = tokenize("/* in */ attribute\n<<= 1e+5 // main\n#define X \\\n 1\ny");
  ASSERT_EQ(tokens.size(), 6U);
  EXPECT_EQ(tokens[0].text, "attribute");
  EXPECT_EQ(tokens[1].text, "<<=");
  EXPECT_EQ(tokens[2].text, "1e+5");
  EXPECT_EQ(tokens[2].kind, TokenKind::number);
  EXPECT_EQ(directive_name(tokens[3]), "define");
  EXPECT_EQ(tokens[4].text, "y");
  EXPECT_EQ(tokens[4].line, 5);
  EXPECT_EQ(tokens[5].kind, TokenKind::end);
}

TEST(GlslTokens, AHashWithinALineIsNoDirective) {
  EXPECT_EQ(tokenize("a # b")[1].kind, TokenKind::punctuation);
  EXPECT_EQ(tokenize("/* c */ # b")[0].kind, TokenKind::directive);
}

Interface interface_of(const std::string& text, bool es = false) { return read_interface(tokenize(text), es); }

TEST(GlslInterface, Versions) {
  EXPECT_EQ(interface_of("").version.number, 110);
  EXPECT_EQ(interface_of("", true).version.number, 100);
  EXPECT_TRUE(interface_of("#version 100\n").version.es);
  EXPECT_TRUE(interface_of("#version 310 es\n").version.es);
  EXPECT_TRUE(interface_of("# version 150 compatibility\n").version.compatibility);
  EXPECT_FALSE(interface_of("#version 330 core\n").version.compatibility);
}

TEST(GlslInterface, InputsAreFoundAmongParametersAndLocals) {
  const Interface interface = interface_of(
      "layout(location = 0) in highp vec3 a, b[2]; void f(in vec3 c, out float d) { vec3 e; } in mat2[3] g;");
  ASSERT_TRUE(interface.ok) << interface.error;
  ASSERT_EQ(interface.declarations.size(), 2U);
  EXPECT_EQ(interface.declarations[0].storage, Storage::input);
  EXPECT_EQ(interface.declarations[0].variables[1].name, "b");
  EXPECT_EQ(interface.declarations[0].variables[1].sizes, std::vector<std::string>{"2"});
  EXPECT_EQ(interface.declarations[1].variables[0].type, "mat2");
  EXPECT_EQ(interface.declarations[1].variables[0].sizes, std::vector<std::string>{"3"});
}

TEST(GlslInterface, BlocksStructuresAndInitialisers) {
  const Interface interface = interface_of(
      "struct S { vec2 x, y[2]; } s; out flat B { S s; int k; } inst[2]; float a = f(1, 2), b[] = {1, 2}, c; precision "
      "highp float; invariant gl_Position; ;");
  ASSERT_TRUE(interface.ok) << interface.error;
  ASSERT_NE(interface.structure("S"), nullptr);
  EXPECT_EQ(interface.structure("S")->members.size(), 3U - 1U);
  const Declaration& block = interface.declarations.at(1);
  EXPECT_TRUE(block.is_block && block.members[0].flat);
  EXPECT_EQ(block.variables[0].name, "inst");
  const Declaration& floats = interface.declarations.at(2);
  ASSERT_EQ(floats.variables.size(), 3U);
  EXPECT_TRUE(floats.variables[0].has_initializer() && floats.variables[1].has_initializer());
  EXPECT_FALSE(floats.variables[2].has_initializer());
}

TEST(GlslInterface, MainMustHaveABody) {
  EXPECT_FALSE(interface_of("void main();").defines_main);
  EXPECT_TRUE(interface_of("void main();void main(void){}").defines_main);
  EXPECT_FALSE(interface_of("float mainly() { return 1.0; }").defines_main);
}

TEST(GlslInterface, ErrorsNameTheLine) {
  EXPECT_NE(interface_of("\nvoid main() {").error.find("line 2"), std::string::npos);
  EXPECT_NE(interface_of("\n\nfloat a b;").error.find("line 3"), std::string::npos);
}

}  // namespace
}  // namespace glark::refine
