// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The parameters of the fixed function's material. glMaterial may set them for each vertex, but no input of a vertex
// shader has them. So refined draws whose vertices have several materials carry them in generic attributes.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "glark/core/ark_state.h"
#include "glark/gl/types.h"

namespace glark::core {

inline constexpr int parameters_of_face = 5;
inline constexpr int material_parameters = 2 * parameters_of_face;  // those of the front face, then of the back face
inline constexpr std::array<GLenum, parameters_of_face> material_names = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR,
                                                                          GL_EMISSION, GL_SHININESS};

// A set of parameters: bit i is parameter i.
using MaterialSet = std::uint32_t;

// The parameters that a call of glMaterial sets; none if GL refuses the names.
constexpr MaterialSet parameters_set_by(GLenum face, GLenum name) {
  MaterialSet set = 0;
  for (int i = 0; i < parameters_of_face; ++i) {
    const bool both =
        name == GL_AMBIENT_AND_DIFFUSE && (material_names[i] == GL_AMBIENT || material_names[i] == GL_DIFFUSE);
    set |= material_names[i] == name || both ? 1U << i : 0U;
  }
  const MaterialSet front = face == GL_FRONT || face == GL_FRONT_AND_BACK ? set : 0;
  const MaterialSet back = face == GL_BACK || face == GL_FRONT_AND_BACK ? set : 0;
  return front | back << parameters_of_face;
}

constexpr GLenum face_of(int parameter) { return parameter < parameters_of_face ? GL_FRONT : GL_BACK; }
constexpr GLenum name_of(int parameter) { return material_names[parameter % parameters_of_face]; }

// The generic attribute of each parameter; -1: all vertices have the current material.
using MaterialAttributes = std::array<std::int8_t, material_parameters>;

constexpr MaterialAttributes no_material_attributes() {
  MaterialAttributes attributes{};
  attributes.fill(-1);
  return attributes;
}

// Programs with fixed function seldom use the high attributes. The attributes of the extension stay free.
constexpr MaterialAttributes material_attributes(MaterialSet set, const ArkState& ark) {
  constexpr GLuint least_attributes = 16;  // OpenGL 4.6, table 23.55
  MaterialAttributes attributes = no_material_attributes();
  GLuint next = least_attributes;
  for (int i = 0; i < material_parameters; ++i) {
    --next;
    while (next == ark.tag_attribute || next == ark.discontinuity_attribute || next == ark.scalar_tag_attribute) {
      --next;
    }
    attributes[i] = (set >> i & 1U) != 0 ? static_cast<std::int8_t>(next) : std::int8_t{-1};
  }
  return attributes;
}

// Calls `visit` with each parameter of the set.
template <typename Visit>
void for_each_parameter(MaterialSet set, Visit&& visit) {
  for (; set != 0; set &= set - 1) {
    visit(std::countr_zero(set));
  }
}

}  // namespace glark::core
