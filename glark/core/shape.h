// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What shapes a surface besides the refinement: tags of the vertices, the refinement's number, displacement.
#pragma once

#include "glark/core/context.h"
#include "glark/core/state/programs/program.h"

namespace glark::core {

inline bool displaces(const Context& context) {
  return !context.options().transparent && context.ark().displacement.on();
}

void add_shape(const Context& context, DerivedKey& key);
// Sets the uniforms of the refinement's number and of displacement, where the program has them.
void set_shape(const Context& context, const DerivedProgram& derived);

}  // namespace glark::core
