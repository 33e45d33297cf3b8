// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/capture/input_slots.h"

#include <string_view>

#include "glark/core/capture/layout.h"

namespace glark::core {

int slot_of_builtin(std::string_view name) {
  constexpr std::string_view texture = "gl_MultiTexCoord";
  if (name.starts_with(texture)) {
    return texture_coordinate_slot + (name.back() - '0');
  }
  return name == "gl_Vertex"           ? vertex_slot
         : name == "gl_Normal"         ? normal_slot
         : name == "gl_Color"          ? color_slot
         : name == "gl_SecondaryColor" ? secondary_color_slot
         : name == "gl_FogCoord"       ? fog_coordinate_slot
                                       : no_slot;
}

namespace {

// The draw call determines the system values.
bool is_system_value(const capture::Field& field) {
  return field.name == "gl_VertexID" || field.name == "gl_InstanceID" || field.name == "gl_BaseVertex" ||
         field.name == "gl_BaseInstance" || field.name == "gl_DrawID";
}

}  // namespace

std::vector<int> input_slots(const capture::Layout& layout, GLuint tag_attribute) {
  std::vector<int> slots;
  for (const capture::Field& field : layout.fields) {
    if (is_system_value(field) || field.made) {
      continue;
    }
    if (capture::is_builtin(field)) {
      slots.push_back(slot_of_builtin(field.name));
      continue;
    }
    for (int i = 0; i < capture::columns_of(field.type) * field.array_size; ++i) {
      slots.push_back(generic_slot(static_cast<GLuint>(field.location + i)));
    }
  }
  if (layout.tagged) {
    slots.push_back(generic_slot(tag_attribute));
  }
  return slots;
}

}  // namespace glark::core
