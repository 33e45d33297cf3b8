// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The layout of a coarse record, made from the active inputs of a vertex stage, and the program that captures it.
#pragma once

#include <string>
#include <vector>

#include "glark/core/capture/record.h"
#include "glark/core/context_options.h"

namespace glark::capture {

// 4-byte words of one element of a GLSL type; 0 for types that no vertex input has.
int words_of(GLenum type);
int columns_of(GLenum type);  // attribute locations that an element takes
bool is_integer(GLenum type);
bool is_wide(GLenum type);  // doubles: two words each

// A system value that all vertices of a triangle share.
bool is_constant_in_draw(const Field& field);

// Returns whether the field is built in ("gl_Vertex"): such inputs are read by name, without a location.
bool is_builtin(const Field& field);

// Places the fields one after the other. `tagged` adds the depth tag, `welded` the words that welding writes.
Layout make_layout(std::vector<Field> fields, bool tagged, WeldedWords welded = {});

// Decides which input is the position, the normal and the texture coordinate: the input that `told` names, by name or
// location. If the program lacks this input, the role is guessed: a built-in input, else the first input with a fitting
// name, else by location. Location 0 is the position. Location 1 or 2 is the normal if only one of them can be it and
// its name says nothing else.
void assign_roles(std::vector<Field>& fields, const core::AttributeRoles& told);
std::string roles_text(const std::vector<Field>& fields);             // "position is v, normal is n, ..."
const Field* find_role(const std::vector<Field>& fields, Role role);  // null: no field has it
// Returns whether there are a position and a normal of three or four floats each.
bool can_curve(const std::vector<Field>& fields);
// First word of the normal in a corner; -1 without one.
int normal_offset(const std::vector<Field>& fields);

struct CaptureSources {
  std::string vertex;
  std::vector<std::string> varyings;  // in record order
};

// The name that capture_sources() gives the input that is the `number`-th without a built-in name.
std::string copied_input_name(int number);

enum class Language { compatibility, core, es };

// A program that copies every field of `layout` to its varyings. `tag_attribute`: location of the depth tag.
CaptureSources capture_sources(const Layout& layout, Language language, GLuint tag_attribute);

}  // namespace glark::capture
