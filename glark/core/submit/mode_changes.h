// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/core/plan/draw_plan.h"
#include "glark/core/refine/fixed_function/fixed_function.h"
#include "glark/core/state/bindings.h"

namespace glark::submit {

// Modes that differ between a vertex shader and the fixed function that it replaces. They are changed for the draw.
struct ModeChanges {
  bool two_side = false;    // GL_VERTEX_PROGRAM_TWO_SIDE is switched on
  bool color_sum = false;   // GL_COLOR_SUM is switched on
  bool point_size = false;  // GL_PROGRAM_POINT_SIZE is toggled
};

// `state` is the fixed function's, if the plan's program replaces it. No GL.
ModeChanges mode_changes(const core::DrawPlan& plan, const refine::FixedFunctionState& state,
                         const core::Bindings& bindings);

}  // namespace glark::submit
