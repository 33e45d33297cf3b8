// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>

#include "glark/core/state/programs/variation.h"

namespace glark::refine {

// Traits of the vertex stage that decide whether and how it can be refined.
struct VertexStageTraits {
  bool reads_vertex_id = false;         // in main or in a function that it calls
  bool writes_cull_distance = false;    // the same: culling needs all corners of the triangle
  std::set<std::string> system_values;  // "gl_VertexID", "gl_InstanceID", "gl_BaseVertex", ...
  bool has_side_effects = false;        // image stores, buffer writes, atomics
  bool writes_flat_outputs = false;
  bool copies_provoking_vertex = false;  // to flat outputs, or to integers within a structure
  StageVariation variation;              // of the outputs
  bool fragments_make_facets = false;    // they compute the normal of their triangle
  bool writes_integers = false;          // in outputs that are not flat; a geometry shader reads those of every vertex

  // It runs on the corners of the coarse triangles, whatever refinement is wanted.
  bool corners_only() const { return reads_vertex_id || writes_cull_distance; }
};

// Traits of the active inputs of the vertex stage.
struct VertexInputTraits {
  bool can_curve = false;  // a position and a normal are known
};

}  // namespace glark::refine
