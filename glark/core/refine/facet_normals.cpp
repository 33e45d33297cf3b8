// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/facet_normals.h"

#include <algorithm>
#include <set>

#include "glark/core/refine/glsl/tokens.h"

namespace glark::refine {
namespace {

bool is_derivative(const Token& token) { return token.text.starts_with("dFdx") || token.text.starts_with("dFdy"); }

// Skips "normalize(" and parentheses.
std::size_t first_of_value(const Tokens& tokens, std::size_t at) {
  while (at + 1 < tokens.size() && (tokens[at].is("normalize") || tokens[at].is("("))) ++at;
  return at;
}

std::set<std::string> find_derivatives(const Tokens& tokens) {
  std::set<std::string> names;
  for (std::size_t i = 1; i + 1 < tokens.size(); ++i) {
    const bool assigned = tokens[i].is("=") && tokens[i - 1].kind == TokenKind::identifier;
    if (assigned && is_derivative(tokens[first_of_value(tokens, i + 1)])) names.insert(tokens[i - 1].text);
  }
  return names;
}

// The token after the first argument of a call whose "(" is at `at`.
std::size_t find_comma(const Tokens& tokens, std::size_t at) {
  int depth = 0;
  for (; at < tokens.size(); ++at) {
    depth += tokens[at].is("(") ? 1 : 0;
    depth -= tokens[at].is(")") ? 1 : 0;
    if (depth == 0 || (depth == 1 && tokens[at].is(","))) break;
  }
  return at;
}

bool computes_facet_normals(const Tokens& tokens) {
  const std::set<std::string> names = find_derivatives(tokens);
  const auto derived = [&](std::size_t at) {
    const std::size_t first = first_of_value(tokens, at);
    return first < tokens.size() && (is_derivative(tokens[first]) || names.contains(tokens[first].text));
  };
  for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
    if (tokens[i].is("cross") && tokens[i + 1].is("(") && derived(i + 2)) {
      const std::size_t comma = find_comma(tokens, i + 1);
      if (comma + 1 < tokens.size() && tokens[comma].is(",") && derived(comma + 1)) return true;
    }
  }
  return false;
}

}  // namespace

bool computes_facet_normals(const std::vector<std::string>& fragment_sources) {
  return std::any_of(fragment_sources.begin(), fragment_sources.end(), [](const std::string& source) {
    return source.find("dFd") != std::string::npos && computes_facet_normals(tokenize(source));
  });
}

}  // namespace glark::refine
