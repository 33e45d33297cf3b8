// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glslang: preprocesses shaders, and parses them to find mistakes and writes to memory.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "glark/core/refine/syntax/syntax_tree.h"

namespace glark::refine {

struct Preprocessed {
  bool ok = false;
  std::string text;  // no comments, no macros; #version, #extension, #pragma and #line are kept
  std::string error;
};

// `extensions` are the context's ("GL_ARB_..."): they decide which GL_ macros are defined. Empty: glslang's own.
Preprocessed preprocess(const std::string& source, bool es, const std::vector<std::string>& extensions);

struct Parsed {
  bool ok = false;
  bool limited = false;                    // not ok because glslang lacks a feature; the shader may be correct
  bool writes_memory = false;              // image stores and atomics, atomic counters, writes to buffer blocks
  std::string error;                       // the first line of the compiler's log
  std::unique_ptr<const SyntaxTree> tree;  // null unless ok
};

// Parses preprocessed text as a vertex shader.
Parsed parse_vertex_shader(const std::string& preprocessed, bool es);

// False for an extension that glslang does not know: glslang would report its language as a mistake.
bool frontend_knows_extension(const std::string& name);

}  // namespace glark::refine
