// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Each vertex attribute, generic or conventional, has one number: its slot.
#pragma once

#include <cstdint>

#include "glark/gl/types.h"

namespace glark::core {

inline constexpr int generic_slots = 32;
inline constexpr int conventional_texture_units = 8;

// Slots below generic_slots are the generic attributes of that index.
enum AttributeSlot : int {
  vertex_slot = generic_slots,
  normal_slot,
  color_slot,
  secondary_color_slot,
  fog_coordinate_slot,
  color_index_slot,
  edge_flag_slot,
  texture_coordinate_slot,  // texture unit 0; the other units follow
  slot_count = texture_coordinate_slot + conventional_texture_units,
  no_slot = -1
};
static_assert(slot_count <= 64, "a set of slots is a 64-bit word");

constexpr std::uint64_t slot_bit(int slot) { return std::uint64_t{1} << slot; }

constexpr int generic_slot(GLuint index) { return index < generic_slots ? static_cast<int>(index) : no_slot; }

// `unit`: GL_TEXTURE0 ..., as for glMultiTexCoord.
constexpr int texture_slot(GLenum unit) {
  return unit >= GL_TEXTURE0 && unit < GL_TEXTURE0 + conventional_texture_units
             ? texture_coordinate_slot + static_cast<int>(unit - GL_TEXTURE0)
             : no_slot;
}

}  // namespace glark::core
