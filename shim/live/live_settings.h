// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The settings in force: those of the start, until keys, the panel or the configuration file change them. Contexts follow
// them when they end a frame. All functions may be called from any thread.
#pragma once

#include <cstdint>
#include <functional>

#include "glark/core/context_options.h"

namespace glark::shim {

// Grows with each change. Contexts compare it once a frame.
std::uint64_t live_generation();
core::ContextOptions live_options();
void change_live(const std::function<void(core::ContextOptions&)>& change);

// Switches refinement off, or on again.
void toggle_refinement();

// Reads the environment and the configuration file again. What the user watches stays.
void read_settings_again();

}  // namespace glark::shim
