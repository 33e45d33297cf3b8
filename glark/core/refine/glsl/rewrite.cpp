// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/glsl/rewrite.h"

#include <fmt/format.h>

#include <algorithm>

#include "glark/core/refine/glsl/frontend.h"

namespace glark::refine {
namespace {

constexpr BuiltInInput built_in_inputs[] = {
    {"gl_Vertex", "gl_Vertex", "vec4"},
    {"gl_Normal", "gl_Normal", "vec3"},
    {"gl_Color", "gl_Color", "vec4"},
    {"gl_SecondaryColor", "gl_SecondaryColor", "vec4"},
    {"gl_FogCoord", "gl_FogCoord", "float"},
    {"gl_MultiTexCoord0", "gl_MultiTexCoord0", "vec4"},
    {"gl_MultiTexCoord1", "gl_MultiTexCoord1", "vec4"},
    {"gl_MultiTexCoord2", "gl_MultiTexCoord2", "vec4"},
    {"gl_MultiTexCoord3", "gl_MultiTexCoord3", "vec4"},
    {"gl_MultiTexCoord4", "gl_MultiTexCoord4", "vec4"},
    {"gl_MultiTexCoord5", "gl_MultiTexCoord5", "vec4"},
    {"gl_MultiTexCoord6", "gl_MultiTexCoord6", "vec4"},
    {"gl_MultiTexCoord7", "gl_MultiTexCoord7", "vec4"},
    {"gl_VertexID", "gl_VertexID", "int", true},
    {"gl_InstanceID", "gl_InstanceID", "int", true},
    {"gl_InstanceIDARB", "gl_InstanceID", "int", true},
    {"gl_InstanceIDEXT", "gl_InstanceID", "int", true},
    {"gl_BaseVertex", "gl_BaseVertex", "int", true},
    {"gl_BaseVertexARB", "gl_BaseVertex", "int", true},
    {"gl_BaseInstance", "gl_BaseInstance", "int", true},
    {"gl_BaseInstanceARB", "gl_BaseInstance", "int", true},
    {"gl_DrawID", "gl_DrawID", "int", true},
    {"gl_DrawIDARB", "gl_DrawID", "int", true},
};

bool is_precision(const Token& token) { return token.is("highp") || token.is("mediump") || token.is("lowp"); }

// layout(location = 0) in highp vec3 a;  ->  highp vec3 a;
void strip_storage(Tokens& tokens, const Declaration& declaration) {
  for (std::size_t i = declaration.begin; i < declaration.type_token; ++i) {
    if (!is_precision(tokens[i])) tokens[i].text.clear();
  }
}

void replace_ftransform(Tokens& tokens, const std::string& vertex) {
  for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
    if (!tokens[i].is("ftransform") || !tokens[i + 1].is("(") || !tokens[i + 2].is(")")) continue;
    tokens[i].text = "(gl_ModelViewProjectionMatrix * " + vertex + ")";
    tokens[i + 1].text.clear();
    tokens[i + 2].text.clear();
  }
}

}  // namespace

const BuiltInInput* built_in_input(std::string_view name) {
  if (!name.starts_with("gl_")) return nullptr;
  const auto* const found = std::find_if(std::begin(built_in_inputs), std::end(built_in_inputs),
                                         [&](const BuiltInInput& input) { return input.name == name; });
  return found == std::end(built_in_inputs) ? nullptr : found;
}

void collect_identifiers(const Tokens& tokens, IdentifierSet& identifiers) {
  for (const Token& token : tokens) {
    if (token.kind == TokenKind::identifier) identifiers.insert(token.text);
    if (token.is("ftransform")) identifiers.insert("gl_Vertex");
  }
}

std::string global_name(const std::string& prefix, const BuiltInInput& input) {
  return prefix + std::string(input.field.substr(3));
}

std::string free_prefix(const IdentifierSet& identifiers) {
  std::string prefix = "glark_";
  const auto taken = [&](const std::string& name) { return name.starts_with(prefix); };
  for (int i = 1; std::any_of(identifiers.begin(), identifiers.end(), taken); ++i)
    prefix = "glark" + std::to_string(i) + "_";
  return prefix;
}

void rewrite_unit(VertexUnit& unit, const std::string& prefix, const NewNames& names) {
  Tokens& tokens = unit.tokens;
  for (const Declaration& declaration : unit.interface.declarations) {
    if (declaration.storage == Storage::input && !declaration.is_block) strip_storage(tokens, declaration);
  }
  replace_ftransform(tokens, prefix + "Vertex");
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i].is("main") && tokens[i + 1].is("(")) tokens[i].text = prefix + "application_main";
  }
  rename_identifiers(tokens, [&](const std::string& name) -> std::string {
    if (const BuiltInInput* const input = built_in_input(name)) return global_name(prefix, *input);
    const auto found = names.of.find(name);
    return found == names.of.end() ? std::string() : found->second;
  });
}

bool read_units(const std::vector<std::string>& sources, bool es, const std::vector<std::string>& extensions,
                std::vector<VertexUnit>& units, std::string& error) {
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const std::string where = sources.size() == 1 ? "vertex shader: " : fmt::format("vertex shader {}: ", i);
    const Preprocessed preprocessed = preprocess(sources[i], es, extensions);
    if (!preprocessed.ok) {
      error = where + preprocessed.error;
      return false;
    }
    VertexUnit unit;
    unit.tokens = tokenize(preprocessed.text);
    unit.interface = read_interface(unit.tokens, es);
    if (!unit.interface.ok) {
      error = where + unit.interface.error;
      return false;
    }
    units.push_back(std::move(unit));
  }
  return true;
}

std::size_t find_main_unit(const std::vector<VertexUnit>& units) {
  for (std::size_t i = units.size(); i-- > 0;) {
    if (units[i].interface.defines_main) return i;
  }
  return units.size();
}

void insert_declaration(Tokens& tokens, const std::string& text) {
  const auto first =
      std::find_if(tokens.begin(), tokens.end(), [](const Token& t) { return t.kind != TokenKind::directive; });
  first->before += "\n" + text;
}

void insert_after_version(Tokens& tokens, const std::string& text) {
  Token token;
  token.kind = TokenKind::directive;
  token.text = text;
  auto position =
      std::find_if(tokens.begin(), tokens.end(), [](const Token& t) { return directive_name(t) == "version"; });
  if (position == tokens.end()) {
    token.text += "\n";
    position = tokens.begin();
  } else {
    token.before = "\n";
    ++position;
  }
  tokens.insert(position, token);
}

}  // namespace glark::refine
