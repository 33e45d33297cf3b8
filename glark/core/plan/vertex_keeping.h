// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Decides whether a draw may keep its refined vertices. No GL.
#pragma once

#include "glark/core/plan/draw_plan.h"

namespace glark::core {

// The application's own program, run on the refined vertex inputs, must draw what the derived program draws, and these
// inputs must depend on nothing but the capture and the plan. `captures`: transform feedback of the application captures
// the refined triangles.
bool keeps_vertices(const DrawPlan& plan, const ContextOptions& options, bool captures);

}  // namespace glark::core
