// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/core/plan/draw_plan.h"
#include "glark/core/refine/fixed_function/fixed_function.h"
#include "glark/core/state/bindings.h"

namespace glark::submit {

// Modes that mean something else for a vertex shader than for the fixed function which it stands for: they are changed for the draw.
struct ModeChanges {
  bool two_side = false;    // GL_VERTEX_PROGRAM_TWO_SIDE is switched on
  bool color_sum = false;   // GL_COLOR_SUM is switched on
  bool point_size = false;  // GL_PROGRAM_POINT_SIZE is switched over
};

// No GL. `state`: of the fixed function, if the plan's program stands for it.
ModeChanges mode_changes(const core::DrawPlan& plan, const refine::FixedFunctionState& state,
                         const core::Bindings& bindings);

}  // namespace glark::submit
