// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>

#include "glark/core/refine/epilogue/epilogue.h"

namespace glark::refine {
namespace {

bool is_number(const std::string& size) {
  int value = 0;
  const auto [end, error] = std::from_chars(size.data(), size.data() + size.size(), value);
  return error == std::errc() && end == size.data() + size.size();
}

bool has_member(const std::vector<Variable>& members, const std::string& name) {
  return std::any_of(members.begin(), members.end(), [&](const Variable& member) { return member.name == name; });
}

// The tokens that name the output within functions. None if it is also named elsewhere besides its declaration: there a
// new name could change what it means.
std::vector<Token*> uses_in_functions(VertexUnit& unit, const std::string& name) {
  const Interface& interface = unit.interface;
  for (const Structure& structure : interface.structures) {
    if (has_member(structure.members, name)) return {};
  }
  std::size_t declared_at = unit.tokens.size();
  for (const Declaration& declaration : interface.declarations) {
    if (has_member(declaration.members, name)) return {};
    for (const Variable& variable : declaration.variables) {
      if (variable.name != name) continue;
      if (variable.has_initializer()) return {};
      declared_at = declaration.begin;
    }
  }
  std::vector<Token*> uses;
  int depth = 0;
  bool in_declaration = false;
  for (std::size_t i = 0; i < unit.tokens.size(); ++i) {
    Token& token = unit.tokens[i];
    in_declaration = i == declared_at || (in_declaration && !unit.tokens[i - 1].is(";"));
    depth += token.is("{") ? 1 : token.is("}") ? -1 : 0;
    const bool is_swizzle = i > 0 && unit.tokens[i - 1].is(".");
    if (!token.is(name) || in_declaration || is_swizzle) continue;
    if (depth == 0) return {};
    uses.push_back(&token);
  }
  return uses;
}

}  // namespace

std::string replace_indexed_outputs(VertexUnit& unit, const std::string& prefix, std::vector<OutputVariable>& outputs) {
  std::string declarations;
  for (OutputVariable& output : outputs) {
    const NumericType* const type = numeric_type(std::string_view(output.type));
    const bool simple = type != nullptr && output.path.find_first_of(".[") == std::string::npos &&
                        std::all_of(output.sizes.begin(), output.sizes.end(), is_number);
    const bool has_index = output.indexed_words > 0 || (type != nullptr && type->columns > 1);  // maybe of a column
    if (!simple || !has_index) continue;
    const std::vector<Token*> uses = uses_in_functions(unit, output.path);
    if (uses.empty()) continue;
    output.written = prefix + "written_" + output.path;
    for (Token* use : uses) use->text = output.written;
    declarations += output.type + " " + output.written;
    for (const std::string& size : output.sizes) declarations += "[" + size + "]";
    declarations += ";\n";
  }
  return declarations;
}

}  // namespace glark::refine
