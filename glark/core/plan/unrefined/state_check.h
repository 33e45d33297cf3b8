// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Checks whether the GL state of the application allows refinement at all: mode of the draw, feedback, queries, polygon
// mode. The program is checked in program_choice.h.
#pragma once

#include <optional>

#include "glark/core/capture/draw_call.h"
#include "glark/core/report/cause.h"
#include "glark/core/state/bindings.h"

namespace glark::core {

struct DrawConditions {
  const Bindings& bindings;
  bool transparent = false;  // the program does not know that it is refined
  bool core_profile = false;
  bool feedback_is_ours = false;  // the application's transform feedback captures refined triangles
  bool plans_feedback = false;    // nothing is drawn yet: glBeginTransformFeedback asks for the program
};

// Returns why the state forbids refinement, or nothing if it allows it. No GL.
std::optional<Cause> check_state(const DrawCall& call, const DrawConditions& conditions);

}  // namespace glark::core
