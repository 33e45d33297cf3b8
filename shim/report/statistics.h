// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The statistics file (GLARK_STATS): what was refined in this process, and how long its frames took.
#pragma once

namespace glark::shim {

// A context was made: from now on this process has statistics to write. A child that was forked and makes none writes none.
void context_made();

// Counts a frame and its duration; a few times a second the file is written, so that a killed program leaves one too.
void frame_counted();

// The number of the frame that is being drawn, from 1.
unsigned long current_frame();

void write_statistics();

}  // namespace glark::shim
