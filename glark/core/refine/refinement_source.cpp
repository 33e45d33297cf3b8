// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/refinement_source.h"

namespace glark::refine {
namespace {

bool keeps_identifiers(std::string_view directive) {
  return directive != "version" && directive != "extension" && directive != "pragma" && directive != "line";
}

}  // namespace

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
  const std::string line = version.at_least(330, 100) ? "1 " : "0 ";
  result.text = "#line " + line + std::to_string(refinement_source_string) + "\n" + to_text(tokens) + "\n#line " +
                line + std::to_string(refinement_source_string + 1) + "\n";
  return result;
}

}  // namespace glark::refine
