// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/shape.h"

#include <array>

namespace glark::core {

void add_shape(const ContextOptions& options, const ArkState& ark, DerivedKey& key) {
  if (options.transparent) {
    return;
  }
  if (key.refinement == Refinement::scalar_tagged_pn) {
    key.discontinuity_attribute = static_cast<int>(ark.discontinuity_attribute);
    key.scalar_tag_attribute = static_cast<int>(ark.scalar_tag_attribute);
  }
  key.displaced = displaces(options, ark);
  key.coordinate_attribute = key.displaced ? ark.displacement.coordinate : -1;
}

void set_displacement(const gl::Dispatch& gl, const Displacement& displacement, const DerivedProgram& derived) {
  std::array<GLfloat, 4> channel{};
  channel.at(displacement.channel) = 1;
  gl.ProgramUniform1i(derived.name, derived.height_map, displacement.unit);
  gl.ProgramUniform4fv(derived.name, derived.height_channel, 1, channel.data());
  gl.ProgramUniform2f(derived.name, derived.height_range, displacement.scale, displacement.bias);
}

}  // namespace glark::core
