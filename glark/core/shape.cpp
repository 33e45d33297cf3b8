// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/shape.h"

#include <array>

namespace glark::core {

// The number is that of the program's refinement, which a rule of the user may have chosen.
float shape_number(const ContextOptions& options, const ArkState& ark, Refinement refinement) {
  return (options.transparent ? options.shape_numbers : ark.shape_numbers)[static_cast<std::size_t>(refinement)];
}

void set_displacement(const gl::Dispatch& gl, const Displacement& displacement, GLuint program,
                      const DisplacementUniforms& uniforms) {
  std::array<GLfloat, 4> channel{};
  channel.at(displacement.channel) = 1;
  gl.ProgramUniform1i(program, uniforms.height_map, displacement.unit);
  gl.ProgramUniform4fv(program, uniforms.height_channel, 1, channel.data());
  gl.ProgramUniform2f(program, uniforms.height_range, displacement.scale, displacement.bias);
}

void add_shape(const ContextOptions& options, const ArkState& ark, DerivedKey& key) {
  if (options.transparent) {
    return;
  }
  if (traits_of(key.refinement).takes_tags) {
    key.discontinuity_attribute = static_cast<int>(ark.discontinuity_attribute);
    key.scalar_tag_attribute = static_cast<int>(ark.scalar_tag_attribute);
  }
  key.displaced = displaces(options, ark);
  key.coordinate_attribute = key.displaced ? ark.displacement.coordinate : -1;
}

void set_shape(const gl::Dispatch& gl, const ContextOptions& options, const ArkState& ark,
               const DerivedProgram& derived) {
  if (derived.shape_number >= 0) {
    gl.ProgramUniform1f(derived.name, derived.shape_number, shape_number(options, ark, derived.refinement));
  }
  if (derived.height_map >= 0) {
    set_displacement(gl, ark.displacement, derived.name,
                     {derived.height_map, derived.height_channel, derived.height_range});
  }
}

}  // namespace glark::core
