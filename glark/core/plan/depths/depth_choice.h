// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Chooses the depths of a draw: by measures, by tags, or a uniform level. No GL.
#pragma once

#include "glark/core/ark_state.h"
#include "glark/core/depth/depth_plan.h"
#include "glark/core/state/programs/program.h"
#include "glark/core/state/programs/program_pipelines.h"

namespace glark::core {

// The measure that applies: the user's in transparent refinement, else the application's. If it is off, depths are not
// measured.
EdgeMeasure edge_measure(const ContextOptions& options, const ArkState& ark);
// Returns whether that measure applies to the program. `pipeline`: the program pipeline it is drawn with, or null.
// `subroutines`: the program in use has chosen subroutines.
bool can_measure(const EdgeMeasure& wanted, const Program& program, const PipelineObject* pipeline, bool subroutines);
bool measures_screen(const EdgeMeasure& wanted, const Program& program, const PipelineObject* pipeline);

// Returns whether the edges of refined triangles are cubics on their way to the screen, or of a lesser degree.
bool has_cubic_edges(const Program& program, const DerivedProgram& derived);

struct DepthFacts {
  const ContextOptions& options;
  const ArkState& ark;
  bool measurable = false;  // can_measure()
  bool tags_vary = false;   // between the vertices of the draw
  double current_tag = 0;   // the current value of the tag attribute, where tags do not vary
  bool coarse = false;      // captured by the program of refined draws, but drawn at depth 0
};

// Returns whether `tags_vary` and `current_tag` matter.
bool takes_tags(const DepthFacts& facts);
depth::DepthPlan choose_depths(const DepthFacts& facts);

}  // namespace glark::core
