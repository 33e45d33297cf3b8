// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Measures the time and memory of several works, side by side.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/bench_points/measure/table.h"

namespace glark::bench {

struct Work {
  std::string name;
  std::function<void()> run;
  double cpu_seconds = 1e300;             // the sum over all threads; the least of all rounds
  double seconds = 1e300;                 // on the clock; the least of all rounds
  std::optional<double> peak_bytes = {};  // the peak memory, minus the memory before
};

// Runs the works in turns, so that other load on the machine affects all of them. Then runs each work once more to
// measure its memory: the most pages of the process (VmHWM of Linux, reset before). For this run, the allocator frees
// all larger blocks at once. So the memory includes everything that was touched, and the results.
void take_turns(std::vector<Work>& works, int rounds);

// Returns CPU seconds, their ratio to the other work's CPU seconds, seconds, and bytes for each point.
std::vector<Cell> costs_of(const Work& work, const Work& other, double points);
inline const std::vector<std::string> cost_columns{"", "CPU s", "of the peer's", "wall s", "peak B a point"};

}  // namespace glark::bench
