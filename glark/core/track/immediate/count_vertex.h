// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Counts the vertices between glBegin and glEnd. The wrapper of every function that gives a vertex calls this.
#pragma once

#include "glark/core/context.h"

namespace glark::core::track {

// The current capture of glBegin..glEnd is full: draws it and begins another one.
void immediate_full(Context& context);

// Called before a vertex of `components` components.
inline void count_vertex(Context& context, unsigned components) {
  ImmediateMode& immediate = context.state().immediate();
  if (immediate.full()) {
    immediate_full(context);
  }
  immediate.count(components);
}

}  // namespace glark::core::track
