// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// From the active inputs of a vertex stage to the layout of its coarse record, and to the program that captures it.
#pragma once

#include <string>
#include <vector>

#include "glark/core/capture/record.h"

namespace glark::capture {

// 4-byte words of one element of a GLSL type; 0 for types that are not captured (double).
int words_of(GLenum type);
bool is_integer(GLenum type);

// "gl_Vertex" and the like: read by their names, without a location.
bool is_builtin(const Field& field);

// Places the fields one after the other; `tagged` adds the depth tag.
Layout make_layout(std::vector<Field> fields, bool tagged);

// Position and normal by name, for PN triangles: the built-in ones, else the first input whose name says so, else location 0
// for the position if it has three or four components.
void assign_roles(std::vector<Field>& fields);
// First word of the normal in a corner; -1 without one.
int normal_offset(const std::vector<Field>& fields);

struct CaptureSources {
  std::string vertex;
  std::string fragment;               // empty on desktop GL
  std::vector<std::string> varyings;  // in record order
};

enum class Language { compatibility, core, es };

// A program that copies every field of `layout` to its varyings. `tag_attribute`: location of the depth tag.
CaptureSources capture_sources(const Layout& layout, Language language, GLuint tag_attribute);

}  // namespace glark::capture
