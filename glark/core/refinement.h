// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The choices a user makes about refinement, shared by the settings, the API and the pipeline.
#pragma once

namespace glark::core {

inline constexpr unsigned max_supported_level = 11;

enum class Refinement {
  linear_inputs,  // interpolate the vertex attributes, run the vertex stage on every refined vertex (Boubekeur 2007, ch. 7.2.4)
  linear_outputs,  // run the vertex stage on the corners, interpolate its results
  pn,              // curved PN triangles (Vlachos et al. 2001)
};

// What the host of the core wants of a context from its start.
struct ContextOptions {
  bool transparent = false;  // refine a program that does not know of the extension
  unsigned level = 2;        // uniform level of transparent refinement
  unsigned max_level = 6;    // level of the pool built for transparent refinement
  Refinement refinement = Refinement::linear_inputs;
  bool wireframe = false;
  bool read_counts = false;  // for the statistics: read back, once a frame, what only the GPU has counted
};

}  // namespace glark::core
