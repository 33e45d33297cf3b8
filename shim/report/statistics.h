// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The statistics file (GLARK_STATS): the refined draws of this process and the times of its frames.
#pragma once

#include <array>
#include <cstdint>

#include "glark/core/report/cause.h"

namespace glark::shim {

// Call it when a context is created: from now on this process writes statistics. A forked child without a context
// writes none.
void context_made();

// Counts a frame and its duration. Writes the file a few times a second, so that a killed program leaves one, too.
void frame_counted();

// Returns the number of the current frame, counted from 1.
unsigned long current_frame();

// What was drawn between two ends of frames, in all contexts of the process.
struct FrameFigures {
  unsigned long number = 0;
  double ms = 0;  // its duration
  std::uint64_t seen = 0;
  std::uint64_t refined = 0;
  std::uint64_t coarse_triangles = 0;  // of refined draws
  std::uint64_t refined_triangles = 0;
  std::array<std::uint64_t, core::cause_count> left{};  // draws that stayed unrefined, by cause
};
FrameFigures last_frame();  // zeros before the first frame ends

// Returns whether this process has created a context. A forked child starts without one.
bool has_made_context();

void write_statistics();

}  // namespace glark::shim
