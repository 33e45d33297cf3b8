// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Chooses the refinement of a draw. It may differ from the wanted one: the vertex stage must have a meaning between the
// corners, and a curved surface needs a normal. No GL.
//
// Transparent refinement runs a stage on interpolated inputs only if this is sound for its position: the position is
// affine in the attributes, or it is continuous and a normal says that the mesh is a surface. Other outputs are decided
// one by one (refine/program/unsound_outputs.h), so that all passes over a mesh have the same positions.
#pragma once

#include <optional>

#include "glark/core/ark_state.h"
#include "glark/core/context_options.h"
#include "glark/core/report/refinement_fallback.h"
#include "glark/core/state/programs/vertex_stage_traits.h"

namespace glark::core {

// The user's refinement in transparent refinement, else the application's.
Refinement wanted_refinement(const ContextOptions& options, const ArkState& ark);

struct RefinementFacts {
  Refinement wanted = Refinement::linear_inputs;
  bool transparent = false;
  const refine::VertexStageTraits& stage;
  const refine::StageVariation& variation;  // of the stage, with the arrays that are enabled
  refine::VertexInputTraits inputs = {};
  bool made_normal = false;  // the normal is made from positions, so it does not tell that the mesh is a surface
  bool flat_shaded = false;  // `smooth`, and shows_facets()
};

struct RefinementChoice {
  Refinement refinement = Refinement::linear_inputs;
  std::optional<RefinementFallback> fallback;  // set if `refinement` is not the wanted one
};
RefinementChoice choose_refinement(const RefinementFacts& facts);

}  // namespace glark::core
