// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What a program of the extension's API asks for beside a surface: tags of the vertices, and displacement.
#pragma once

#include "glark/core/context.h"
#include "glark/core/state/programs/program.h"

namespace glark::core {

inline bool displaces(const Context& context) {
  return !context.options().transparent && context.ark().displacement.on();
}

void add_shape(const Context& context, DerivedKey& key);
// Sets the uniforms of displacement.
void set_displacement(const Context& context, const DerivedProgram& derived);

}  // namespace glark::core
