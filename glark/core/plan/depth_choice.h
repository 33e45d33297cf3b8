// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// To which depths a draw is refined: by measures, by tags, or to a uniform level. No GL.
#pragma once

#include "glark/core/ark_state.h"
#include "glark/core/depth/depth_plan.h"
#include "glark/core/state/programs/program.h"

namespace glark::core {

// The measure that holds: the user's in transparent refinement, else the application's. Off: depths come from elsewhere.
EdgeMeasure edge_measure(const ContextOptions& options, const ArkState& ark);
// Whether that measure applies to the program. `subroutines`: the program in use has chosen some.
bool can_measure(const EdgeMeasure& wanted, const Program& program, bool subroutines);
bool measures_screen(const EdgeMeasure& wanted, const Program& program);

struct DepthFacts {
  const ContextOptions& options;
  const ArkState& ark;
  bool measurable = false;  // can_measure()
  bool tags_vary = false;   // between the vertices of the draw
  double current_tag = 0;   // the current value of the tag attribute, where tags do not vary
  bool coarse = false;      // the draw is captured by the program of refined draws, but at depth 0
};

// Whether `tags_vary` and `current_tag` matter.
bool takes_tags(const DepthFacts& facts);
depth::DepthPlan choose_depths(const DepthFacts& facts);

}  // namespace glark::core
