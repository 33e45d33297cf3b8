// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/refinement_source.h"

#include <algorithm>

#include "glark/core/refine/refinement_log.h"

namespace glark::refine {
namespace {

bool declares_uniform(const Interface& interface, const std::string& name) {
  return std::any_of(interface.declarations.begin(), interface.declarations.end(), [&](const Declaration& declaration) {
    return declaration.storage == Storage::uniform && !declaration.is_block &&
           std::any_of(declaration.variables.begin(), declaration.variables.end(),
                       [&](const Variable& variable) { return variable.name == name; });
  });
}

void clear(Tokens& tokens, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) tokens[i].text.clear();
}

int nesting_of(const Token& token) {
  if (token.is("(") || token.is("[") || token.is("{")) return 1;
  return token.is(")") || token.is("]") || token.is("}") ? -1 : 0;
}

// uniform float a, b = 1.0, c;  where b is declared elsewhere  ->  uniform float a, c;
void drop_from(Tokens& tokens, const Declaration& declaration, const Interface& elsewhere) {
  std::size_t begin = declaration.type_token + 1;
  int kept = 0;
  int depth = 0;
  for (std::size_t i = begin; tokens[i].kind != TokenKind::end; ++i) {
    depth += nesting_of(tokens[i]);
    const bool last = tokens[i].is(";");
    if (!last && (depth > 0 || !tokens[i].is(","))) continue;
    if (declares_uniform(elsewhere, tokens[begin].text)) {
      clear(tokens, begin, last ? i : i + 1);
    } else {
      ++kept;
    }
    begin = i + 1;
    if (!last) continue;
    if (kept == 0) clear(tokens, declaration.begin, i + 1);
    // The declarations that remain may end in a comma.
    for (std::size_t back = i;
         kept > 0 && back-- > declaration.type_token && (tokens[back].text.empty() || tokens[back].is(","));)
      tokens[back].text.clear();
    return;
  }
}

bool keeps_identifiers(std::string_view directive) {
  return directive != "version" && directive != "extension" && directive != "pragma" && directive != "line";
}

}  // namespace

void drop_repeated_uniforms(Tokens& source, const Interface& elsewhere, bool es_context) {
  const Interface own = read_interface(source, es_context);
  for (const Declaration& declaration : own.declarations)
    if (declaration.storage == Storage::uniform && !declaration.is_block) drop_from(source, declaration, elsewhere);
}

RefinementSource prepare_refinement_source(const Tokens& source, const std::string& prefix, const NewNames& names,
                                           const GlslVersion& version) {
  Tokens tokens = source;
  RefinementSource result;
  rename_identifiers(
      tokens,
      [&](const std::string& name) -> std::string {
        result.identifiers.insert(name);
        if (name == "refine") return prefix + "refine";
        if (const BuiltInInput* const input = built_in_input(name)) return global_name(prefix, *input);
        const auto found = names.of.find(name);
        return found == names.of.end() ? std::string() : found->second;
      },
      keeps_identifiers);
  for (Token& token : tokens) {
    const std::string_view directive = directive_name(token);
    if (directive == "extension") result.extensions += token.text + "\n";
    if (directive == "version" || directive == "extension") token.text.clear();
  }
  // Up to GLSL 1.50 the line after "#line n" is line n + 1.
  const int before = version.at_least(330, 100) ? 0 : 1;
  const auto line_directive = [&](int line, int source_string) {
    return "#line " + std::to_string(line - before) + " " + std::to_string(source_string) + "\n";
  };
  result.text = line_directive(first_refinement_line, refinement_source_string) + to_text(tokens) + "\n" +
                line_directive(first_line_after_refinement, refinement_source_string + 1);
  return result;
}

}  // namespace glark::refine
