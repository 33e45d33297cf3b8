// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The global declarations of one vertex shader: its inputs, outputs, structures, initialised globals and functions.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "glark/core/refine/glsl/tokens.h"

namespace glark::refine {

struct GlslVersion {
  int number = 110;
  bool es = false;
  bool compatibility = false;  // the profile was named

  // True from `desktop` on, or from `es_number` on in an ES shader.
  bool at_least(int desktop, int es_number) const { return number >= (es ? es_number : desktop); }
  bool has_in_out() const { return at_least(130, 300); }
};

enum class Storage { none, constant, input, output, uniform, buffer, other };

struct Variable {
  std::string name;
  std::string type;                // "vec3", or the name of a structure
  std::vector<std::string> sizes;  // text within each [...]; "" when left open
  bool flat = false;
  bool noperspective = false;
  bool smooth = false;                // declared smooth; otherwise glShadeModel decides
  std::size_t initializer_begin = 0;  // tokens after '='; equal to the end when there is none
  std::size_t initializer_end = 0;
  bool has_initializer() const { return initializer_begin != initializer_end; }
};

struct Structure {
  std::string name;
  std::vector<Variable> members;
};

// One statement at global scope that declares variables or an interface block.
struct Declaration {
  Storage storage = Storage::none;
  std::size_t begin = 0;            // first token, a qualifier or the type
  std::size_t type_token = 0;       // the type; qualifiers come before it
  std::vector<Variable> variables;  // of a block: its instance, or nothing
  bool is_block = false;
  std::string block_name;
  std::vector<Variable> members;
};

struct Interface {
  bool ok = false;
  std::string error;
  GlslVersion version;
  std::vector<Declaration> declarations;
  std::vector<Structure> structures;
  std::vector<std::string> functions;  // defined here
  bool defines_main = false;

  const Structure* structure(const std::string& name) const;
};

GlslVersion version_of(const Tokens& tokens, bool es_context);

// `tokens` of preprocessed text.
Interface read_interface(const Tokens& tokens, bool es_context);

}  // namespace glark::refine
