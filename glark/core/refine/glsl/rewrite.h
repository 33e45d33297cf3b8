// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The application's own text: its inputs become globals, its main gets another name.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "glark/core/refine/derive.h"
#include "glark/core/refine/glsl/interface.h"
#include "glark/core/refine/glsl/tokens.h"

namespace glark::refine {

// One vertex shader object, preprocessed.
struct VertexUnit {
  Tokens tokens;
  Interface interface;
};

// A vertex input that GLSL declares itself.
struct BuiltInInput {
  std::string_view name;   // "gl_InstanceIDARB"
  std::string_view field;  // as the coarse record names it: "gl_InstanceID"
  std::string_view type;
  bool system_value = false;
};
const BuiltInInput* built_in_input(std::string_view name);

using IdentifierSet = std::unordered_set<std::string>;
void collect_identifiers(const Tokens& tokens, IdentifierSet& identifiers);

// The name of the global that stands for a built-in input: "glark_Vertex".
std::string global_name(const std::string& prefix, const BuiltInInput& input);

// "glark_", or "glark1_", ... when the application uses that.
std::string free_prefix(const IdentifierSet& identifiers);

struct NewNames {
  std::map<std::string, std::string> of;
  const std::string& operator()(const std::string& name) const {
    const auto found = of.find(name);
    return found == of.end() ? name : found->second;
  }
};

// Applies `names`, renames main to "<prefix>application_main", replaces ftransform(), and takes the storage qualifiers
// from inputs.
void rewrite_unit(VertexUnit& unit, const std::string& prefix, const NewNames& names);

// Preprocesses and reads every source; false with an error that names the shader and the line.
bool read_units(const std::vector<std::string>& sources, bool es, const std::vector<std::string>& extensions,
                std::vector<VertexUnit>& units, std::string& error);
// The last unit that defines main; units.size() when none does.
std::size_t find_main_unit(const std::vector<VertexUnit>& units);

// Puts text behind the #version directive, or in front of everything where there is none.
void insert_after_version(Tokens& tokens, const std::string& text);

// Puts a declaration in front of the first token that is no directive.
void insert_declaration(Tokens& tokens, const std::string& text);

}  // namespace glark::refine
