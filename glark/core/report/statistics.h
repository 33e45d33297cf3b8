// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Counters of the core, for its host.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>

#include "glark/core/report/cause.h"

namespace glark::core {

// Process-wide counters; relaxed atomics.
struct Statistics {
  std::atomic<std::uint64_t> draws_seen{0};
  std::atomic<std::uint64_t> draws_refined{0};
  std::array<std::atomic<std::uint64_t>, cause_count> passed_through{};
  std::atomic<std::uint64_t> coarse_triangles{0};
  // Exact for uniform draws; adaptive draws count on the GPU and are added when the buffer is next reused.
  std::atomic<std::uint64_t> refined_triangles{0};
  std::atomic<std::uint64_t> captures_made{0};
  std::atomic<std::uint64_t> captures_reused{0};
  std::atomic<std::uint64_t> programs_derived{0};
  std::atomic<std::uint64_t> programs_failed{0};
};
Statistics& statistics();

// Counts the draws of the shader programs with the same sources, in all contexts.
struct ProgramCounters {
  std::atomic<std::uint64_t> draws_seen{0};
  std::atomic<std::uint64_t> draws_refined{0};
};
ProgramCounters& program_counters(std::uint64_t hash);  // the reference stays valid
void for_each_program(const std::function<void(std::uint64_t hash, const ProgramCounters&)>& visit);

}  // namespace glark::core
