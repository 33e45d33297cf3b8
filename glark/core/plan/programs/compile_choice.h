// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/core/ark_state.h"
#include "glark/core/context_options.h"
#include "glark/core/objects/programs/compilation.h"

namespace glark::core {

// Returns whether draws may stay unrefined while their programs are compiled. Programs that call the extension never
// wait for a later frame. A program that shows one picture only would never be refined, so the first frame waits, too;
// `smooth` leaves the first frames as they are in any case. No GL.
CompilePace compile_pace(const ContextOptions& options, const ArkState& ark, bool has_shown_frame);

}  // namespace glark::core
