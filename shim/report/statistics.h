// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The statistics file (GLARK_STATS): the refined draws of this process and the times of its frames.
#pragma once

namespace glark::shim {

// Call it when a context is created: from now on this process writes statistics. A forked child without a context
// writes none.
void context_made();

// Counts a frame and its duration. Writes the file a few times a second, so that a killed program leaves one, too.
void frame_counted();

// Returns the number of the current frame, counted from 1.
unsigned long current_frame();

// Returns whether this process has created a context. A forked child starts without one.
bool has_made_context();

void write_statistics();

}  // namespace glark::shim
