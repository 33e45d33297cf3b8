// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/passes/compile_ahead.h"

namespace glark::core {

void compile_ahead(MeshWatch& meshes, TrianglePasses& passes, const DrawCall& call, const DrawPlan& plan,
                   std::uint64_t triangles) {
  const bool exact = call.exact && triangles == call.triangles;
  if (meshes.is_nearly_watched(call, plan.program->fields) && !passes.compile(plan, triangles, exact)) {
    meshes.compiles(call, plan.program->fields);
  }
}

}  // namespace glark::core
