// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Counts the vertices between glBegin and glEnd. The wrapper of every function that gives a vertex calls this.
#pragma once

#include "glark/core/context.h"

namespace glark::core::track {

// The current capture of glBegin..glEnd is full: draws it and begins another one, with room for `least` vertices.
void immediate_full(Context& context, std::uint64_t least = 0);
// Called before lists that give `vertices` vertices. Between two separate primitives, makes room for them.
void count_called(Context& context, std::uint64_t vertices);

// Whether a call of the open primitive, or of the list that is compiled, gives a vertex.
bool gives_vertex(Context& context, VertexSource source);
// Call before glBegin.
VertexSources vertex_sources(Context& context);

// Called before a vertex of `components` components.
inline void count_vertex(Context& context, unsigned components, VertexSource source = VertexSource::call) {
  ImmediateMode& immediate = context.state().immediate();
  if (source != VertexSource::call && !gives_vertex(context, source)) {
    return;
  }
  if (immediate.full()) {
    immediate_full(context);
  }
  immediate.count(components);
}

}  // namespace glark::core::track
