// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/vertex_keeping.h"

namespace glark::core {

bool keeps_vertices(const DrawPlan& plan, const ContextOptions& options, bool captures) {
  const DerivedProgram& derived = *plan.derived;
  const depth::DepthPlan& depth = plan.depth;
  const bool keeps_instances = depth.keeps_instances() || depth.keeps_view();
  const bool same_depths = depth.adaptive ? keeps_instances && !depth.morphing : depth.level > 0;
  const bool own_outputs = traits_of(derived.refinement).interpolates_outputs || derived.corner_outputs;
  return options.kept_vertex_bytes > 0 && same_depths && !plan.polygons && !own_outputs && !derived.stored() &&
         plan.assembly == nullptr && !plan.program->counts_primitives && !captures;
}

}  // namespace glark::core
