// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench_points/measure/measure.h"

#include <malloc.h>

#include <algorithm>
#include <ctime>
#include <fstream>

namespace glark::bench {
namespace {

double seconds_of(clockid_t clock) {
  std::timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// VmRSS or VmHWM in bytes; 0 where the system does not report it.
double status_of(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(name + ":")) return 1024 * std::stod(line.substr(name.size() + 1));
  return 0;
}

std::optional<double> peak_of(const std::function<void()>& run) {
  malloc_trim(0);
  if (std::ofstream reset("/proc/self/clear_refs"); !(reset << "5").flush()) return std::nullopt;
  const double before = status_of("VmRSS");
  run();
  const double most = status_of("VmHWM");
  return most > 0 ? std::optional(std::max(0.0, most - before)) : std::nullopt;
}

}  // namespace

void take_turns(std::vector<Work>& works, int rounds) {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the value in a program that has run for a while
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
  for (int round = 0; round < rounds; ++round) {
    for (Work& work : works) {
      const double cpu = seconds_of(CLOCK_PROCESS_CPUTIME_ID), begin = seconds_of(CLOCK_MONOTONIC);
      work.run();
      work.seconds = std::min(work.seconds, seconds_of(CLOCK_MONOTONIC) - begin);
      work.cpu_seconds = std::min(work.cpu_seconds, seconds_of(CLOCK_PROCESS_CPUTIME_ID) - cpu);
    }
  }
  mallopt(M_MMAP_THRESHOLD, 64 << 10);
  mallopt(M_TRIM_THRESHOLD, 0);
  for (Work& work : works) work.peak_bytes = peak_of(work.run);
}

std::vector<Cell> costs_of(const Work& work, const Work& other, double points) {
  std::vector<Cell> cells{work.name, Number{work.cpu_seconds, work.cpu_seconds < 0.1 ? 4 : 3},
                          Number{work.cpu_seconds / other.cpu_seconds, 2},
                          Number{work.seconds, work.seconds < 0.1 ? 4 : 3}};
  cells.push_back(work.peak_bytes ? Cell{Number{*work.peak_bytes / points, 0}} : Cell{});
  return cells;
}

}  // namespace glark::bench
