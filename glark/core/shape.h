// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What a program of the extension's API asks for beside a surface: tags of the vertices, and displacement.
#pragma once

#include "glark/core/ark_state.h"
#include "glark/core/state/programs/program.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

inline bool displaces(const ContextOptions& options, const ArkState& ark) {
  return !options.transparent && ark.displacement.on();
}

void add_shape(const ContextOptions& options, const ArkState& ark, DerivedKey& key);
// Sets the uniforms of displacement.
void set_displacement(const gl::Dispatch& gl, const Displacement& displacement, const DerivedProgram& derived);

}  // namespace glark::core
