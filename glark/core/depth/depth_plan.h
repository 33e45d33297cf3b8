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
  bool counted = false;      // the triangles of this draw count: their depths are measured
};

inline constexpr int corners_only = 3;
inline constexpr int points_of_cubics = 10;
inline constexpr int points_of_any_curve = 13;

// The program that gives positions on the screen (measure/screen_positions.h).
struct ScreenProgram {
  GLuint name = 0;  // 0: the screen is not measured
  int points = corners_only;
  // For more points than corners:
  GLuint lattice = 0;  // attribute locations
  GLuint first_chunk = 0;
  GLint first_word = -1;  // location of the uniform; >= 0: the program reads records from a storage block
  GLuint records_binding = 0;

  bool measures_curves() const { return points > corners_only; }
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
  ScreenProgram screen;
  int normal_offset = -1;  // first word of the normal in a corner; -1: normals are not measured

  int depth_steps() const { return morphing ? pattern::morph_steps : 1; }
  // Measured depths change with the camera, so the capture is kept instead of the sorted instances.
  bool keeps_instances() const { return adaptive && !measured && !coarse; }
  // The depths stay while the view stays. With a budget, they depend on the other draws of the frame.
  bool keeps_view() const { return measured && !coarse && measure.budget == 0; }
};

}  // namespace glark::depth
