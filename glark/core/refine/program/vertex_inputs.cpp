// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/program/vertex_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "glark/core/capture/layout.h"
#include "glark/core/refine/glsl/rewrite.h"
#include "glark/core/refine/program/labels.h"
#include "glark/core/report/cause.h"
#include "glark/core/report/log.h"

namespace glark::refine {
namespace {

void refuse(core::Program& program, const capture::Field& field, std::string_view reason) {
  program.cause = core::Cause::program_not_derived;
  core::log(core::LogLevel::warning,
            fmt::format("{}: vertex input {} {}; its draws stay as they are", label(program), field.name, reason));
}

// Reads input number `index`. Returns nothing for built-in inputs that carry no attribute: not every driver lists
// these.
std::optional<capture::Field> read_input(const gl::Dispatch& gl, GLuint program, GLuint index, std::string& buffer) {
  capture::Field field;
  GLsizei length = 0;
  gl.GetActiveAttrib(program, index, static_cast<GLsizei>(buffer.size()), &length, &field.array_size, &field.type,
                     buffer.data());
  field.name = buffer.substr(0, static_cast<std::size_t>(length));
  const BuiltInInput* const built_in = built_in_input(field.name);
  if (built_in != nullptr && built_in->system_value) {
    return std::nullopt;
  }
  if (field.name.ends_with("[0]")) {
    field.name.resize(field.name.size() - 3);
    field.is_array = true;
  }
  field.is_array = field.is_array || field.array_size > 1;
  field.location = capture::is_builtin(field) ? -1 : gl.GetAttribLocation(program, field.name.c_str());
  return field;
}

bool read_inputs(const gl::Dispatch& gl, core::Program& program) {
  GLint count = 0;
  GLint longest = 0;
  gl.GetProgramiv(program.name, GL_ACTIVE_ATTRIBUTES, &count);
  gl.GetProgramiv(program.name, GL_ACTIVE_ATTRIBUTE_MAX_LENGTH, &longest);
  std::string buffer(static_cast<std::size_t>(longest) + 1, '\0');
  for (GLint i = 0; i < count; ++i) {
    std::optional<capture::Field> field = read_input(gl, program.name, static_cast<GLuint>(i), buffer);
    if (field && capture::words_of(field->type) == 0) {
      refuse(program, *field, "has a type that is not captured");
      return false;
    }
    if (field) {
      program.fields.push_back(*std::move(field));
    }
  }
  return true;
}

bool locations_are_separate(core::Program& program) {
  int end = 0;
  for (const capture::Field& field : program.fields) {
    if (field.location >= 0 && field.location < end) {
      refuse(program, field, "shares a location with another");
      return false;
    }
    end = std::max(end, field.location + capture::columns_of(field.type) * field.array_size);
  }
  return true;
}

// The strips of thick lines often have the other end of the line and, as a fourth component, the vertex's own side in an
// attribute with the name of a normal. Such a "normal" moves the vertex across the line. A surface's normal needs no
// fourth component.
void forget_ends_of_lines(core::Program& program) {
  const OutputVariation* const position = program.traits.variation.position();
  if (position == nullptr || position->variation <= Variation::affine) {
    return;
  }
  for (capture::Field& field : program.fields) {
    if (field.role == capture::Role::normal && field.type == GL_FLOAT_VEC4 && position->inputs.contains(field.name)) {
      field.role = capture::Role::other;
    }
  }
}

}  // namespace

void read_vertex_inputs(const gl::Dispatch& gl, const core::AttributeRoles& roles, core::Program& program) {
  program.fields.clear();
  if (!read_inputs(gl, program)) {
    return;
  }
  // The position should come first, because a vec4 then fills one chunk.
  std::sort(program.fields.begin(), program.fields.end(), [](const capture::Field& a, const capture::Field& b) {
    return a.location != b.location ? a.location < b.location : a.name > b.name;
  });
  if (!locations_are_separate(program)) {
    return;
  }
  for (const std::string& name : program.traits.system_values) {
    program.fields.push_back({.name = name, .type = GL_INT});
  }
  capture::assign_roles(program.fields, roles);
  if (roles.normal.empty()) {
    forget_ends_of_lines(program);
  }
  program.input_traits = {.can_curve = capture::can_curve(program.fields)};
  core::log(core::LogLevel::info, fmt::format("{}: {}", label(program), capture::roles_text(program.fields)));
}

}  // namespace glark::refine
