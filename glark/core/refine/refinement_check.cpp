// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/refinement_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "glark/core/refine/glsl/interface.h"

namespace glark::refine {
namespace {

constexpr std::string_view corner_prefix = "ark_corner_";

std::string mistake(int line, const std::string& what) {
  return fmt::format("refinement shader:{}: error: {}", line, what);
}

bool is_active(std::span<const capture::Field> inputs, std::string_view name) {
  return std::any_of(inputs.begin(), inputs.end(), [&](const capture::Field& field) { return field.name == name; });
}

std::string names_of(std::span<const capture::Field> inputs) {
  std::string names;
  for (const capture::Field& field : inputs) names += (names.empty() ? "" : ", ") + field.name;
  return names;
}

// A macro may define refine(), so its name only has to occur.
std::string missing_function(const Tokens& source) {
  const bool named = std::any_of(source.begin(), source.end(), [](const Token& token) {
    return token.is("refine") || (token.kind == TokenKind::directive && token.text.find("refine") != std::string::npos);
  });
  return named ? std::string() : mistake(source.back().line, "it defines no function void refine()");
}

std::string forbidden_version(const Tokens& source) {
  for (const Token& token : source)
    if (directive_name(token) == "version")
      return mistake(
          token.line,
          "a refinement shader has no #version directive; it is written in the version of the vertex shader");
  return {};
}

// Built-in inputs may be constant for the draw; then they have no corners of their own, but a value.
std::string inactive_input(const Tokens& source, std::span<const capture::Field> inputs) {
  for (const Token& token : source) {
    if (token.kind != TokenKind::identifier || !token.text.starts_with(corner_prefix)) continue;
    const std::string name = token.text.substr(corner_prefix.size());
    if (name.starts_with("gl_") || is_active(inputs, name)) continue;
    return mistake(token.line,
                   fmt::format("{0}: {1} is not an active input of the vertex stage, because no vertex shader "
                               "declares it or its value is not used; the active inputs are {2}",
                               token.text, name, names_of(inputs)));
  }
  return {};
}

std::string uniform_named_as_output(const Tokens& source, const RefinementSurroundings& surroundings) {
  const Interface own = read_interface(source, surroundings.es);
  for (const Declaration& declaration : own.declarations) {
    if (declaration.storage != Storage::uniform || declaration.is_block) continue;
    for (const Variable& variable : declaration.variables)
      if (surroundings.outputs.contains(variable.name))
        return mistake(source[declaration.begin].line,
                       fmt::format("the uniform {0} has the name of an output of the vertex stage; rename the uniform",
                                   variable.name));
  }
  return {};
}

}  // namespace

std::string find_mistake(const Tokens& source, const RefinementSurroundings& surroundings) {
  std::string found = forbidden_version(source);
  if (found.empty()) found = missing_function(source);
  if (found.empty()) found = inactive_input(source, surroundings.inputs);
  if (found.empty()) found = uniform_named_as_output(source, surroundings);
  return found;
}

}  // namespace glark::refine
