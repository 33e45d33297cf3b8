// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// How one draw call will go through the pipeline: what pipeline_plan.cpp and pipeline_depth.cpp decide before anything is captured.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "glark/core/depth/centroid_split.h"
#include "glark/core/draw_call.h"
#include "glark/core/pattern/pool.h"
#include "glark/core/state/programs/program.h"
#include "glark/core/state/programs/program_pipelines.h"

namespace glark::core {

struct DrawPlan {
  Program* program = nullptr;
  Program* owner = nullptr;
  std::shared_ptr<DerivedProgram> derived;  // another context may discard it meanwhile
  GLuint capture_program = 0;
  const std::vector<int>* inputs = nullptr;  // attributes that are captured, by AttributeSlot
  const PipelineObject* pipeline = nullptr;  // the application's, if its stages are separate programs
  const capture::Layout* layout = nullptr;
  std::optional<depth::Decomposition> polygons;  // to be split at their centroids
  PolygonSides polygon_sides = {};               // of several GL_POLYGONs
  // Measured depths change with the camera: what is captured is kept, not how it was sorted.
  bool keeps_bins() const { return adaptive && !measured && !coarse; }
  bool coarse = false;        // every depth is 0
  bool for_feedback = false;  // what will be drawn is not known yet
  bool adaptive = false;
  bool morphing = false;  // adaptive, and vertices move between levels
  int depth_steps() const { return morphing ? pattern::morph_steps : 1; }
  bool measured = false;  // adaptive, by the ends of the edges
  std::shared_ptr<DerivedProgram> corners;
  GLuint corner_program = 0;            // for a measure on the screen
  int normal_offset = -1;               // for a measure of the normals
  bool welded = false;                  // by position: edges, if the layout has room for them, and tags, if it has any
  bool placed = false;                  // the derived program takes a placement of the piece
  bool last_vertex_convention = false;  // while capturing
  unsigned level = 0;                   // uniform level
  unsigned deepest = 0;                 // that an adaptive draw can reach
};

}  // namespace glark::core
