// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/glsl/tokens.h"

#include <algorithm>
#include <array>

namespace glark::refine {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  Token next() {
    Token token;
    token.before = white_space();
    token.line = line_;
    const std::size_t begin = at_;
    if (begin == text_.size()) return token;
    const char c = text_[at_];
    if (c == '#' && line_is_fresh_) {
      token.kind = TokenKind::directive;
      skip_directive();
    } else if (is_letter(c)) {
      token.kind = TokenKind::identifier;
      while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    } else if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
      token.kind = TokenKind::number;
      skip_number();
    } else {
      token.kind = TokenKind::punctuation;
      skip_punctuation();
    }
    line_is_fresh_ = false;
    token.text = text_.substr(begin, at_ - begin);
    return token;
  }

 private:
  char peek(std::size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  void take() {
    if (text_[at_++] == '\n') {
      ++line_;
      line_is_fresh_ = true;
    }
  }

  // A backslash in front of a newline joins two lines, in white space and directives as elsewhere.
  bool skip_continuation() {
    const std::size_t newline = peek(0) != '\\' ? 0 : peek(1) == '\n' ? 1 : peek(1) == '\r' && peek(2) == '\n' ? 2 : 0;
    if (newline == 0) return false;
    at_ += newline + 1;
    ++line_;
    return true;
  }

  void skip_block_comment() {
    const bool fresh = line_is_fresh_;
    at_ += 2;
    while (at_ < text_.size() && !(peek(0) == '*' && peek(1) == '/')) take();
    at_ = std::min(at_ + 2, text_.size());
    line_is_fresh_ = fresh;
  }

  void skip_line_comment() {
    while (at_ < text_.size() && text_[at_] != '\n') {
      if (!skip_continuation()) ++at_;
    }
  }

  std::string white_space() {
    const std::size_t begin = at_;
    while (at_ < text_.size()) {
      if (is_blank(text_[at_]) || text_[at_] == '\n') {
        take();
      } else if (peek(0) == '/' && peek(1) == '/') {
        skip_line_comment();
      } else if (peek(0) == '/' && peek(1) == '*') {
        skip_block_comment();
      } else if (!skip_continuation()) {
        break;
      }
    }
    return std::string(text_.substr(begin, at_ - begin));
  }

  // Up to the end of the line; a block comment within the directive does not end it.
  void skip_directive() {
    while (at_ < text_.size() && text_[at_] != '\n') {
      if (peek(0) == '/' && peek(1) == '*') {
        skip_block_comment();
      } else if (peek(0) == '/' && peek(1) == '/') {
        skip_line_comment();
      } else if (!skip_continuation()) {
        ++at_;
      }
    }
  }

  void skip_number() {
    const bool hexadecimal = peek(0) == '0' && (peek(1) == 'x' || peek(1) == 'X');
    while (at_ < text_.size()) {
      const char c = text_[at_];
      const bool exponent_sign =
          !hexadecimal && (c == '+' || c == '-') && (text_[at_ - 1] == 'e' || text_[at_ - 1] == 'E');
      if (!is_digit(c) && !is_letter(c) && c != '.' && !exponent_sign) break;
      ++at_;
    }
  }

  void skip_punctuation() {
    static constexpr std::array<std::string_view, 22> long_operators = {
        "<<=", ">>=", "++", "--", "<<", ">>", "<=", ">=", "==", "!=", "&&",
        "||",  "^^",  "+=", "-=", "*=", "/=", "%=", "&=", "^=", "|=", "##"};
    for (const std::string_view op : long_operators) {
      if (text_.substr(at_, op.size()) == op) {
        at_ += op.size();
        return;
      }
    }
    ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  bool line_is_fresh_ = true;
};

}  // namespace

Tokens tokenize(std::string_view glsl) {
  Scanner scanner(glsl);
  Tokens tokens;
  do {
    tokens.push_back(scanner.next());
  } while (tokens.back().kind != TokenKind::end);
  return tokens;
}

std::string to_text(const Tokens& tokens, std::size_t begin, std::size_t end) {
  std::string text;
  for (std::size_t i = begin; i < end && i < tokens.size(); ++i) {
    text += tokens[i].before;
    text += tokens[i].text;
  }
  return text;
}

std::string to_text(const Tokens& tokens) { return to_text(tokens, 0, tokens.size()); }

std::string_view directive_name(const Token& token) {
  if (token.kind != TokenKind::directive) return {};
  const std::string_view text = token.text;
  std::size_t begin = 1;
  while (begin < text.size() && is_blank(text[begin])) ++begin;
  std::size_t end = begin;
  while (end < text.size() && is_letter(text[end])) ++end;
  return text.substr(begin, end - begin);
}

void rename_identifiers(Tokens& tokens, const Rename& rename,
                        const std::function<bool(std::string_view)>& in_directive) {
  for (Token& token : tokens) {
    if (token.kind == TokenKind::identifier) {
      std::string name = rename(token.text);
      if (!name.empty()) token.text = std::move(name);
    } else if (token.kind == TokenKind::directive && in_directive && in_directive(directive_name(token))) {
      Tokens body = tokenize(std::string_view(token.text).substr(1));
      rename_identifiers(body, rename);
      token.text = "#" + to_text(body);
    }
  }
}

}  // namespace glark::refine
