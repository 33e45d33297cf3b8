// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/shape.h"

#include <array>

namespace glark::core {
namespace {

void set_shape_number(const Context& context, const DerivedProgram& derived) {
  const bool transparent = context.options().transparent;
  const Refinement refinement = transparent ? context.options().refinement : context.ark().refinement;
  const ShapeNumbers& numbers = transparent ? context.options().shape_numbers : context.ark().shape_numbers;
  context.supported().ProgramUniform1f(derived.name, derived.shape_number,
                                     numbers[static_cast<std::size_t>(refinement)]);
}

void set_displacement(const Context& context, const DerivedProgram& derived) {
  const Displacement& displacement = context.ark().displacement;
  std::array<GLfloat, 4> channel{};
  channel.at(displacement.channel) = 1;
  const gl::Dispatch& gl = context.supported();
  gl.ProgramUniform1i(derived.name, derived.height_map, displacement.unit);
  gl.ProgramUniform4fv(derived.name, derived.height_channel, 1, channel.data());
  gl.ProgramUniform2f(derived.name, derived.height_range, displacement.scale, displacement.bias);
}

}  // namespace

void add_shape(const Context& context, DerivedKey& key) {
  if (context.options().transparent) {
    return;
  }
  const ArkState& ark = context.ark();
  if (traits_of(key.refinement).takes_tags) {
    key.discontinuity_attribute = static_cast<int>(ark.discontinuity_attribute);
    key.scalar_tag_attribute = static_cast<int>(ark.scalar_tag_attribute);
  }
  key.displaced = displaces(context);
  key.coordinate_attribute = key.displaced ? ark.displacement.coordinate : -1;
}

void set_shape(const Context& context, const DerivedProgram& derived) {
  if (derived.shape_number >= 0) {
    set_shape_number(context, derived);
  }
  if (derived.height_map >= 0) {
    set_displacement(context, derived);
  }
}

}  // namespace glark::core
