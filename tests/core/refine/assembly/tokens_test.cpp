// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/assembly/tokens.h"

#include <gtest/gtest.h>

namespace glark::refine::assembly {
namespace {

std::string spaced(std::string_view program) {
  std::string text;
  for (const Word& word : words_of(program)) {
    if (word.kind != WordKind::end) text += (text.empty() ? "" : " ") + word.text;
  }
  return text;
}

TEST(AssemblyTokens, DotsOfNumbersRangesAndPaths) {
  EXPECT_EQ(spaced("program.env[0..5].x"), "program . env [ 0 .. 5 ] . x");
  EXPECT_EQ(spaced("{.5,1.,2.5e-3,1e9,3}"), "{ .5 , 1. , 2.5e-3 , 1e9 , 3 }");
}

TEST(AssemblyTokens, CommentsSpacesAndLines) {
  const std::vector<Word> words = words_of("!!ARBvp1.0 # MOV\r\n\tMOV a$_1;# END\nEND");
  ASSERT_EQ(words.size(), 6U);
  EXPECT_EQ(words[0].text, "!!ARBvp1.0");
  EXPECT_EQ(words[2].text, "a$_1");
  EXPECT_EQ(words[4].text, "END");
  EXPECT_EQ(words[4].line, 3);
  EXPECT_EQ(words[5].kind, WordKind::end);
}

}  // namespace
}  // namespace glark::refine::assembly
