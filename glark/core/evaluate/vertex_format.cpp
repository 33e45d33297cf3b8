// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/evaluate/vertex_format.h"

#include <algorithm>

#include "glark/core/capture/input_slots.h"
#include "glark/core/capture/layout.h"

namespace glark::evaluate {
namespace {

// glSecondaryColorPointer takes three components; the fourth of a current value is not drawn.
GLint components_of(int slot, int rows) { return slot == core::secondary_color_slot ? 3 : rows; }

void add_field(const capture::Field& field, VertexFormat& format) {
  const int columns = capture::columns_of(field.type) * field.array_size;
  const int rows = field.words / columns;
  for (int column = 0; column < columns; ++column) {
    const int slot = capture::is_builtin(field) ? core::slot_of_builtin(field.name)
                                                : core::generic_slot(static_cast<GLuint>(field.location + column));
    format.attributes.push_back({slot, components_of(slot, rows), format.words + column * rows});
  }
}

void enable_array(const gl::Dispatch& gl, GLenum array) { gl.EnableClientState(array); }

void point_at(const gl::Dispatch& gl, const VertexAttribute& attribute, GLsizei stride) {
  const auto* const offset = reinterpret_cast<const void*>(static_cast<std::size_t>(attribute.offset) * 4);
  const GLint components = attribute.components;
  if (attribute.slot < core::generic_slots) {
    const auto index = static_cast<GLuint>(attribute.slot);
    gl.EnableVertexAttribArray(index);
    gl.VertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, stride, offset);
    return;
  }
  switch (attribute.slot) {
    case core::vertex_slot:
      gl.VertexPointer(components, GL_FLOAT, stride, offset);
      return enable_array(gl, GL_VERTEX_ARRAY);
    case core::normal_slot: gl.NormalPointer(GL_FLOAT, stride, offset); return enable_array(gl, GL_NORMAL_ARRAY);
    case core::color_slot:
      gl.ColorPointer(components, GL_FLOAT, stride, offset);
      return enable_array(gl, GL_COLOR_ARRAY);
    case core::secondary_color_slot:
      gl.SecondaryColorPointer(components, GL_FLOAT, stride, offset);
      return enable_array(gl, GL_SECONDARY_COLOR_ARRAY);
    case core::fog_coordinate_slot:
      gl.FogCoordPointer(GL_FLOAT, stride, offset);
      return enable_array(gl, GL_FOG_COORD_ARRAY);
    default: break;
  }
  gl.ClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(attribute.slot - core::texture_coordinate_slot));
  gl.TexCoordPointer(components, GL_FLOAT, stride, offset);
  enable_array(gl, GL_TEXTURE_COORD_ARRAY);
}

bool has_array(const VertexAttribute& attribute) {
  return attribute.slot != core::no_slot && attribute.slot != core::color_index_slot &&
         attribute.slot != core::edge_flag_slot;
}

}  // namespace

std::vector<capture::Field> copied_fields(const std::vector<capture::Field>& fields) {
  std::vector<capture::Field> copied = fields;
  std::erase_if(copied, [](const capture::Field& field) { return field.unread; });
  return copied;
}

VertexFormat vertex_format(const std::vector<capture::Field>& fields) {
  VertexFormat format;
  for (const capture::Field& field : copied_fields(fields)) {
    if (capture::is_integer(field.type) || capture::is_wide(field.type) || capture::columns_of(field.type) == 0) {
      return {};
    }
    add_field(field, format);
    if (!has_array(format.attributes.back())) {
      return {};
    }
    format.words += field.words;
  }
  return format;
}

GLuint make_vertex_array(const gl::Dispatch& gl, const VertexFormat& format, const core::GpuBuffer& vertices,
                         GLuint indices) {
  GLint array_buffer = 0;
  gl.GetIntegerv(GL_ARRAY_BUFFER_BINDING, &array_buffer);
  GLint texture = 0;
  const bool conventional =
      std::any_of(format.attributes.begin(), format.attributes.end(),
                  [](const VertexAttribute& a) { return a.slot >= core::texture_coordinate_slot; });
  if (conventional) {
    gl.GetIntegerv(GL_CLIENT_ACTIVE_TEXTURE, &texture);
  }
  GLuint name = 0;
  gl.GenVertexArrays(1, &name);
  if (name == 0) {
    return 0;
  }
  gl.BindVertexArray(name);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices.name());
  for (const VertexAttribute& attribute : format.attributes) {
    point_at(gl, attribute, format.words * 4);
  }
  gl.BindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(array_buffer));
  if (conventional) {
    gl.ClientActiveTexture(static_cast<GLenum>(texture));
  }
  return name;
}

}  // namespace glark::evaluate
