// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>

namespace glark::refine {

// Traits of the vertex stage that decide whether and how it can be refined.
struct VertexStageTraits {
  bool reads_vertex_id = false;         // then outputs must be interpolated
  bool writes_cull_distance = false;    // the same: culling needs all corners of the triangle
  std::set<std::string> system_values;  // "gl_VertexID", "gl_InstanceID", "gl_BaseVertex", ...
  bool has_side_effects = false;        // image stores, buffer writes, atomics
  bool writes_flat_outputs = false;
  bool writes_integers = false;  // in outputs that are not flat; a geometry shader reads those of every vertex
};

// Traits of the active inputs of the vertex stage.
struct VertexInputTraits {
  bool can_curve = false;     // a position and a normal are known
  bool has_integers = false;  // among the vertex attributes
};

}  // namespace glark::refine
