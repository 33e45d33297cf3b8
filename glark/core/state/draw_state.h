// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/core/draw_rule.h"
#include "glark/core/state/environment.h"

namespace glark::core {

// Returns the state of a draw that rules and statistics look at. `program`: null if it is unknown. May ask GL once for
// each framebuffer.
DrawState read_draw_state(const Environment& environment, const Program* program);

}  // namespace glark::core
