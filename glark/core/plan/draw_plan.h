// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The plan of one draw call: everything that is decided before the capture.
#pragma once

#include <memory>
#include <optional>

#include "glark/core/capture/capture_plan.h"
#include "glark/core/capture/draw_call.h"
#include "glark/core/depth/depth_plan.h"
#include "glark/core/polygons/decomposition.h"
#include "glark/core/report/cause.h"
#include "glark/core/report/refinement_fallback.h"
#include "glark/core/state/programs/program.h"
#include "glark/core/state/programs/program_pipelines.h"
#include "glark/core/weld/draw_weld.h"

namespace glark::core {

struct AssemblyStage;

struct DrawPlan {
  Program* program = nullptr;                     // its vertex stage is refined
  Program* owner = nullptr;                       // the derived program follows its uniforms; null: fixed function
  const AssemblyStage* assembly = nullptr;        // set if `program` is a translated assembly program
  const PipelineObject* pipeline = nullptr;       // the application's, if its stages are separate programs
  std::shared_ptr<DerivedProgram> derived;        // shared: another context may discard it during the draw
  Refinement wanted = Refinement::linear_inputs;  // of the user, of a rule, or of the application
  std::optional<RefinementFallback> fallback;     // why the draw does not get the wanted refinement
  std::shared_ptr<DerivedProgram> corners;        // gives positions on the screen, where they are measured
  bool placed = false;                            // the derived program takes a placement of the piece
  capture::CapturePlan capture;
  std::optional<polygons::Decomposition> polygons;  // set if they are split at their centroids
  std::optional<polygons::Cut> cut;                 // set if quads are cut again
  std::optional<int> provoking_corner;              // of polygons with flat outputs
  PolygonSides polygon_sides = {};                  // sizes of several GL_POLYGONs
  weld::WeldPlan weld;
  depth::DepthPlan depth;
  bool keeps_vertices = false;  // its refined vertices may be kept, and drawn by the application's own program

  // The inputs of the vertex stage; null: they are not known.
  const std::vector<capture::Field>* inputs() const {
    if (derived != nullptr) {
      return &derived->layout.fields;  // with a normal that the stage does not read
    }
    return program != nullptr && program->prepared && !program->fields.empty() ? &program->fields : nullptr;
  }
};

struct Decision {
  std::optional<Cause> cause;  // empty: the draw is refined as planned
  DrawPlan plan;
};

}  // namespace glark::core
