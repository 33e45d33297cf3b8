// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/syntax/shadowing.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace glark::refine {
namespace {

// Words that may stand in front of a variable that is only used.
constexpr std::array statements = {"return", "else", "do", "case"};

enum class Brace { block, structure, initialiser };

class Scopes {
 public:
  explicit Scopes(const Tokens& tokens) {
    for (std::size_t i = 1; i < tokens.size(); ++i) {
      const Token& token = tokens[i];
      if (token.kind == TokenKind::identifier && declares(tokens[i - 1])) declare(token.text);
      closed_structure_ = false;
      if (token.kind == TokenKind::punctuation) read_punctuation(tokens, i);
      if (token.is("for")) nested_header_ = tokens[i - 1].is(")");
    }
  }

  std::set<std::string> shadowing;

 private:
  void read_punctuation(const Tokens& tokens, std::size_t i) {
    const Token& token = tokens[i];
    if (token.is("{")) open(brace(tokens, i));
    if (token.is("}") && !braces_.empty()) close();
    if (token.is("(")) ++brackets_;
    if (token.is(")") && brackets_ > 0) --brackets_;
    if (!token.is(";")) return;
    declaring_ = false;
    if (scopes_.empty()) parameters_.clear();  // of a prototype
    if (brackets_ == 0) nested_header_ = false;
  }

  Brace brace(const Tokens& tokens, std::size_t i) const {
    const bool inner = tokens[i - 1].is(",") || tokens[i - 1].is("{");
    if (tokens[i - 1].is("=") || (inner && !braces_.empty() && braces_.back() == Brace::initialiser)) {
      return Brace::initialiser;
    }
    const bool structure = tokens[i - 1].is("struct") || (i > 1 && tokens[i - 2].is("struct"));
    return structure ? Brace::structure : Brace::block;
  }

  void open(Brace brace) {
    braces_.push_back(brace);
    if (brace == Brace::initialiser) {
      ++brackets_;
      return;
    }
    declaring_ = false;
    scopes_.push_back(scopes_.empty() ? parameters_ : std::set<std::string>());
  }

  void close() {
    const Brace brace = braces_.back();
    braces_.pop_back();
    if (brace == Brace::initialiser) {
      --brackets_;
      return;
    }
    declaring_ = false;
    closed_structure_ = brace == Brace::structure;
    scopes_.pop_back();
    if (scopes_.empty()) parameters_.clear();
  }

  // Is an identifier after `previous` a new variable: "float x", "S[2] x", or "float x = 1.0, y"?
  bool declares(const Token& previous) {
    const bool word = previous.kind == TokenKind::identifier &&
                      std::none_of(statements.begin(), statements.end(),
                                   [&](const char* statement) { return previous.is(statement); });
    if (word || previous.is("]") || closed_structure_) {
      declaring_ = true;
      declaring_brackets_ = brackets_;
      return true;
    }
    return previous.is(",") && declaring_ && brackets_ == declaring_brackets_;
  }

  void declare(const std::string& name) {
    if (scopes_.empty()) {
      parameters_.insert(name);
      return;
    }
    const std::size_t outer = scopes_.size() - (nested_header_ ? 0 : 1);
    for (std::size_t i = 0; i < outer; ++i) {
      if (scopes_[i].contains(name)) shadowing.insert(name);
    }
    scopes_.back().insert(name);
  }

  std::vector<Brace> braces_;
  std::vector<std::set<std::string>> scopes_;
  std::set<std::string> parameters_;
  std::size_t brackets_ = 0;
  std::size_t declaring_brackets_ = 0;
  bool declaring_ = false;
  bool closed_structure_ = false;
  bool nested_header_ = false;  // within a loop that is the whole body of another statement
};

}  // namespace

std::set<std::string> shadowing_names(const Tokens& tokens) { return Scopes(tokens).shadowing; }

}  // namespace glark::refine
