// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/shape.h"

#include <array>

namespace glark::core {

void add_shape(const Context& context, DerivedKey& key) {
  if (context.options().transparent) {
    return;
  }
  const ArkState& ark = context.ark();
  if (key.refinement == Refinement::scalar_tagged_pn) {
    key.discontinuity_attribute = static_cast<int>(ark.discontinuity_attribute);
    key.scalar_tag_attribute = static_cast<int>(ark.scalar_tag_attribute);
  }
  key.displaced = displaces(context);
  key.coordinate_attribute = key.displaced ? ark.displacement.coordinate : -1;
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

}  // namespace glark::core
