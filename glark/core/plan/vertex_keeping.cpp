// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/vertex_keeping.h"

namespace glark::core {

bool keeps_vertices(const DrawPlan& plan, const ContextOptions& options, bool captures) {
  const DerivedProgram& derived = *plan.derived;
  const RefinementTraits& refinement = traits_of(derived.refinement);
  const bool one_grid = !plan.depth.adaptive && plan.depth.level > 0 && !plan.placed && !plan.polygons;
  const bool own_inputs = !plan.program->refinement_source.empty() || derived.height_map >= 0 ||
                          (refinement.takes_tags && !options.transparent);
  const bool own_outputs = refinement.interpolates_outputs || derived.corner_outputs;
  return options.kept_vertex_bytes > 0 && one_grid && !own_inputs && !own_outputs && !derived.stored() &&
         plan.assembly == nullptr && !plan.program->counts_primitives && !captures;
}

}  // namespace glark::core
