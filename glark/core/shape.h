// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What shapes a surface besides the refinement: tags of the vertices, the refinement's number, displacement.
#pragma once

#include "glark/core/ark_state.h"
#include "glark/core/state/programs/program.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

inline bool displaces(const ContextOptions& options, const ArkState& ark) {
  return !options.transparent && ark.displacement.on();
}

// Without tags of their own, all vertices have these.
inline ScalarTags constant_tags(const ContextOptions& options) {
  return {.tension = options.shape_numbers[static_cast<std::size_t>(Refinement::scalar_tagged_pn)]};
}

void add_shape(const ContextOptions& options, const ArkState& ark, DerivedKey& key);
// Sets the uniforms of the refinement's number and of displacement, where the program has them.
void set_shape(const gl::Dispatch& gl, const ContextOptions& options, const ArkState& ark,
               const DerivedProgram& derived);

}  // namespace glark::core
