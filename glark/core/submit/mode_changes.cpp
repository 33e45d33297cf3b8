// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/submit/mode_changes.h"

namespace glark::submit {

ModeChanges mode_changes(const core::DrawPlan& plan, const refine::FixedFunctionState& state,
                         const core::Bindings& bindings) {
  ModeChanges changes;
  if (!plan.program->fixed_function) {
    return changes;
  }
  changes.two_side = state.two_sided && !bindings.two_side;
  // Fixed-function lighting adds the separate specular colour by itself; a vertex shader needs GL_COLOR_SUM.
  changes.color_sum = plan.owner == nullptr && state.lighting && state.separate_specular && !state.color_sum;
  // Fixed function attenuates points by itself; a vertex shader needs GL_PROGRAM_POINT_SIZE to set their size.
  changes.point_size = state.point_size != state.program_point_size;
  return changes;
}

}  // namespace glark::submit
