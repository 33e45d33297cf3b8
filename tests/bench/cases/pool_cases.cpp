// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The pattern pool: the time to build it, and its bytes on the CPU and on the GPU.
#include <algorithm>
#include <chrono>

#include "glark/core/pattern/gpu_pool.h"
#include "glark/core/pattern/pool.h"
#include "tests/bench/cases/case.h"
#include "tests/bench/gl.h"

namespace glark::bench {
namespace {

constexpr int repetitions = 9;

template <typename Work>
double least_milliseconds(Work&& work) {
  using Clock = std::chrono::steady_clock;
  double least = 1e9;
  for (int i = 0; i < repetitions; ++i) {
    const auto begin = Clock::now();
    work();
    least = std::min(least, std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
  }
  return least;
}

std::size_t tile_bytes(unsigned level) {
  std::size_t tiles = 1;
  for (unsigned deep = pattern::deepest_uniform + 1U; deep <= level; ++deep)
    tiles += pattern::GpuPool::tile_count(deep);
  return tiles * 16;
}

struct Goals {
  double megabytes;
  double milliseconds;
};

void run(unsigned level, Report& report) {
  const bool judged = level >= 10;
  const Goals goals = level == 11 ? Goals{4, 60} : Goals{2, 20};
  const Goal goal = judged ? Goal::at_most : Goal::none;
  const std::string name = "pool/level" + std::to_string(level);
  const pattern::Pool pool = pattern::build_pool(level);
  const double megabytes = static_cast<double>(pool.gpu_bytes() + tile_bytes(level)) / 1e6;
  report.add({name + "/gpu", level == 10 ? "thesis 26 MB" : "", goal, goals.megabytes, megabytes, "MB", {}});
  report.add({name + "/cpu",
              level == 10 ? "thesis < 4 kB" : "",
              goal,
              4,
              static_cast<double>(sizeof(pool.pieces)) / 1e3,
              "kB",
              {}});
  report.add({name + "/build",
              "",
              Goal::none,
              0,
              least_milliseconds([level] { static_cast<void>(pattern::build_pool(level)); }),
              "ms",
              {}});
  const double init = least_milliseconds([level] {
    glARKinit(level);
    glFinish();
  });
  report.add({name + "/glARKinit", "", goal, goals.milliseconds, init, "ms", {}});
}

}  // namespace

void add_pool_cases(std::vector<Case>& cases) {
  for (const unsigned level : {6U, 8U, 10U, 11U}) {
    cases.push_back(
        {"pool/level" + std::to_string(level), [level](Report& report, const Effort&) { run(level, report); }});
  }
}

}  // namespace glark::bench
