// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "glark/core/meshes/mesh_watch.h"
#include "glark/core/passes/triangle_passes.h"
#include "glark/core/plan/draw_plan.h"

namespace glark::core {

// The frames in which a mesh is watched (Cause::mesh_waits) are used to compile its passes. While some are missing, the
// mesh keeps waiting, in all passes over it. `triangles`: of the draw, or a bound.
void compile_ahead(MeshWatch& meshes, TrianglePasses& passes, const DrawCall& call, const DrawPlan& plan,
                   std::uint64_t triangles);

}  // namespace glark::core
