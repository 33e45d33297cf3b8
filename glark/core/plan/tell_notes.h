// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/core/plan/draw_notes.h"
#include "glark/core/state/environment.h"
#include "glark/core/state/programs/program.h"

namespace glark::core {

// Tells the log and the application's debug output what a draw of the program does not get. Each is told once.
void tell_notes(const Environment& environment, Program& program, DrawNoteFacts facts);

}  // namespace glark::core
