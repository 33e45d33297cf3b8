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

// How edge depths are measured where the application gives no tags. 0 turns a measure off; of two, an edge takes the lesser depth.
struct EdgeMeasure {
  float pixels = 0;     // longest segment of an edge on the screen
  float degrees = 0;    // greatest angle between the normals at the ends of a segment
  unsigned budget = 0;  // refined triangles a frame that the measures give way to
  bool on() const { return pixels > 0 || degrees > 0; }
  bool operator==(const EdgeMeasure&) const = default;
};

// What the host of the core wants of a context from its start.
struct ContextOptions {
  bool transparent = false;  // refine a program that does not know of the extension
  unsigned level = 2;        // uniform level of transparent refinement
  unsigned max_level = 6;    // level of the pool built for transparent refinement
  Refinement refinement = Refinement::linear_inputs;
  EdgeMeasure measure;  // on: transparent refinement by measured depths up to max_level
  bool wireframe = false;
  bool read_counts = false;  // for the statistics: read back, once a frame, what only the GPU has counted
};

}  // namespace glark::core
