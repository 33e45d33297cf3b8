// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// How quads and polygons are captured: whether they are split at their centroids, and along which diagonal GL cuts
// them. The decisions are pure functions of quad_capture.h and split_choice.h.
#pragma once

#include "glark/core/capture/draw_call.h"
#include "glark/core/capture/draw_capture.h"
#include "glark/core/plan/draw_plan.h"
#include "glark/core/polygons/decompositions.h"
#include "glark/core/polygons/drawn_diagonals.h"
#include "glark/core/programs/program_switch.h"
#include "glark/core/state/environment.h"

namespace glark::core {

class PolygonCapture {
 public:
  PolygonCapture(const Environment& environment, capture::DrawCapture& capture, const ProgramSwitch& programs)
      : env_(environment), decompositions_(environment, capture, programs), diagonals_(environment, programs) {}

  // Plans the split at centroids, or for flat outputs. The plan has a program.
  void choose_split(const DrawCall& call, DrawPlan& plan);
  // Has quads captured under the other convention if they are then cut as GL draws them. The plan has a derived
  // program.
  void follow_drawn_diagonal(const DrawCall& call, DrawPlan& plan);

 private:
  // Finds the provoking vertex among the captured corners. Quads whose triangles do not have it at the same corner are
  // cut again.
  void find_provoking_corner(const DrawCall& call, DrawPlan& plan);
  GLenum convention(const DrawPlan& plan) const;

  const Environment& env_;
  polygons::Decompositions decompositions_;
  polygons::DrawnDiagonals diagonals_;
};

}  // namespace glark::core
