// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/assembly/tokens.h"

#include <cctype>

namespace glark::refine::assembly {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool begins_name(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$' || c == '!';
}
bool continues_name(char c) { return begins_name(c) || is_digit(c); }

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  std::vector<Word> read() {
    std::vector<Word> words;
    for (skip(); at_ < text_.size(); skip()) {
      words.push_back(next());
    }
    words.push_back({WordKind::end, "the end of the text", line_});
    return words;
  }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  // Spaces and comments.
  void skip() {
    for (; at_ < text_.size(); ++at_) {
      if (peek() == '#') {
        while (at_ < text_.size() && peek() != '\n' && peek() != '\r') ++at_;
      }
      if (peek() == '\n') ++line_;
      if (peek() != '\0' && std::isspace(static_cast<unsigned char>(peek())) == 0) return;
    }
  }

  Word next() {
    const std::size_t begin = at_;
    WordKind kind = WordKind::punctuation;
    if (is_digit(peek()) || (peek() == '.' && is_digit(peek(1)))) {
      kind = WordKind::number;
      skip_number();
    } else if (begins_name(peek())) {
      kind = WordKind::name;
      while (continues_name(peek())) ++at_;
      if (text_.substr(begin, at_ - begin).starts_with("!!")) skip_version();
    } else {
      at_ += peek() == '.' && peek(1) == '.' ? 2 : 1;
    }
    return {kind, std::string(text_.substr(begin, at_ - begin)), line_};
  }

  // In "0..5" the dots are a range.
  void skip_number() {
    while (is_digit(peek())) ++at_;
    if (peek() == '.' && peek(1) != '.') {
      ++at_;
      while (is_digit(peek())) ++at_;
    }
    const std::size_t sign = peek(1) == '+' || peek(1) == '-' ? 1 : 0;
    if ((peek() == 'e' || peek() == 'E') && is_digit(peek(1 + sign))) {
      at_ += 1 + sign;
      while (is_digit(peek())) ++at_;
    }
  }

  // "!!ARBvp1.0" is one word.
  void skip_version() {
    while (is_digit(peek()) || peek() == '.') ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace

std::vector<Word> words_of(std::string_view program) { return Reader(program).read(); }

}  // namespace glark::refine::assembly
