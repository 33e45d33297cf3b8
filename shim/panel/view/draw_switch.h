// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Switches the refinement of a class of draws off and on again, by a rule for their state.
#pragma once

#include <optional>
#include <vector>

#include "glark/core/context_options.h"
#include "glark/core/live/frame_watch.h"

namespace glark::shim {

// The rule that leaves draws in this state unrefined. The size of the viewport is no part of it: windows are resized.
core::DrawRule rule_against(const core::DrawState& state);
bool is_switched_off(const core::ContextOptions& options, const core::DrawState& state);
void switch_draws(core::ContextOptions& options, const core::DrawState& state, bool refine);

// The state of the draws that the user sees at the chosen pixel: of those that changed it, the last one that is no user
// interface or full-screen pass; of these only if there is no other. Nothing if no draw changed it.
std::optional<core::DrawState> seen_at_pixel(const std::vector<core::WatchedClass>& classes);

}  // namespace glark::shim
