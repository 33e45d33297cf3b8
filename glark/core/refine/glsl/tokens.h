// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// GLSL text as a sequence of tokens that can be edited and written back.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace glark::refine {

enum class TokenKind { identifier, number, punctuation, directive, end };

struct Token {
  TokenKind kind = TokenKind::end;
  std::string text;    // a directive is one token: its whole line, continuations included, without the newline
  std::string before;  // white space and comments in front of the token
  int line = 1;

  bool is(std::string_view expected) const { return text == expected && kind != TokenKind::directive; }
};

// The sequence ends with a token of kind `end`. Every text can be split into tokens; there are no errors.
using Tokens = std::vector<Token>;
Tokens tokenize(std::string_view glsl);

std::string to_text(const Tokens& tokens);
std::string to_text(const Tokens& tokens, std::size_t begin, std::size_t end);

// The first word after '#': "version", "extension", ...; empty when the token is no directive.
std::string_view directive_name(const Token& token);

// Replaces identifiers, also those within directives whose name `in_directive` accepts. `rename` returns the new name
// or "" to keep.
using Rename = std::function<std::string(const std::string&)>;
void rename_identifiers(Tokens& tokens, const Rename& rename,
                        const std::function<bool(std::string_view)>& in_directive = {});

}  // namespace glark::refine
