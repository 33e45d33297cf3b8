// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/core/context_options.h"
#include "glark/core/pattern/expand.h"
#include "glark/core/pattern/pool.h"
#include "glark/gl/types.h"

namespace glark::depth {

// What the budget of triangles pays for.
struct BudgetPlan {
  bool curves_only = false;  // straight edges have depth 0, and triangles with three of them do not count
  bool counted = true;       // the triangles of this draw count
};

// How deep the edges of a draw are refined, and by which patterns.
struct DepthPlan {
  bool adaptive = false;  // each edge has a depth of its own; otherwise every edge has depth `level`
  bool measured = false;  // adaptive, with depths measured from the ends of the edges
  bool morphing = false;  // adaptive, and vertices move between levels
  bool coarse = false;    // every depth is 0
  unsigned level = 0;
  unsigned deepest = 0;  // greatest depth of an adaptive draw
  pattern::Interior interior = pattern::Interior::minimum;
  core::EdgeMeasure measure;  // the measure of a measured draw
  BudgetPlan budget;
  GLuint corner_program = 0;  // gives the screen positions of the corners; 0: the screen is not measured
  int normal_offset = -1;     // first word of the normal in a corner; -1: normals are not measured

  int depth_steps() const { return morphing ? pattern::morph_steps : 1; }
  // Measured depths change with the camera, so the capture is kept instead of the sorted instances.
  bool keeps_instances() const { return adaptive && !measured && !coarse; }
};

}  // namespace glark::depth
