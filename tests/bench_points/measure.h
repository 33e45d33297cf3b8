// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What some works take, side by side.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/bench_points/table.h"

namespace glark::bench {

struct Work {
  std::string name;
  std::function<void()> run;
  double cpu_seconds = 1e300;             // of all threads; the least
  double seconds = 1e300;                 // of the clock; the least
  std::optional<double> peak_bytes = {};  // of memory, beyond what there was before
};

// In turns, so that what else the machine does strikes all alike. Then once more each, for the memory: the most pages that the process
// has had (Linux' VmHWM, set back before), with an allocator that gives all larger blocks back at once. So it counts what was touched,
// of everybody, results included.
void take_turns(std::vector<Work>& works, int rounds);

// CPU seconds, that by the first work's or another one's, seconds, and bytes by the points.
std::vector<Cell> costs_of(const Work& work, const Work& other, double points);
inline const std::vector<std::string> cost_columns{"", "CPU s", "of the peer's", "wall s", "peak B a point"};

}  // namespace glark::bench
