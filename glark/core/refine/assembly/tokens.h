// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The words of an assembly program: names, numbers and punctuation, without comments and spaces.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace glark::refine::assembly {

enum class WordKind { name, number, punctuation, end };

struct Word {
  WordKind kind = WordKind::end;
  std::string text;  // punctuation is one character, or ".."
  int line = 0;      // from 1

  bool is(std::string_view other) const { return kind != WordKind::number && text == other; }
};

// The last word has the kind `end`. Unknown characters become punctuation, which the parser rejects.
std::vector<Word> words_of(std::string_view program);

}  // namespace glark::refine::assembly
