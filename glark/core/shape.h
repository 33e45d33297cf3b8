// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The values that shape a surface besides the refinement: tags of the vertices, the shape number, displacement.
#pragma once

#include "glark/core/ark_state.h"
#include "glark/core/state/programs/program.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

inline bool displaces(const ContextOptions& options, const ArkState& ark) {
  return !options.transparent && ark.displacement.on();
}

// These tags apply to all vertices that carry no tags.
inline ScalarTags constant_tags(const ContextOptions& options) {
  return {.tension = options.shape_numbers[static_cast<std::size_t>(Refinement::scalar_tagged_pn)]};
}

void add_shape(const ContextOptions& options, const ArkState& ark, DerivedKey& key);
// The value of the uniform that shapes the refinement's surface.
float shape_number(const ContextOptions& options, const ArkState& ark, Refinement refinement);
// Locations of the uniforms of displacement.
struct DisplacementUniforms {
  GLint height_map = -1;
  GLint height_channel = -1;
  GLint height_range = -1;
};
void set_displacement(const gl::Dispatch& gl, const Displacement& displacement, GLuint program,
                      const DisplacementUniforms& uniforms);
// Sets the uniforms of the shape number and of displacement, if the program has them.
void set_shape(const gl::Dispatch& gl, const ContextOptions& options, const ArkState& ark,
               const DerivedProgram& derived);

}  // namespace glark::core
