// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Counters of the core, for its host.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include "glark/core/report/cause.h"
#include "glark/core/report/refinement_fallback.h"

namespace glark::core {

// Process-wide counters; relaxed atomics.
struct Statistics {
  std::atomic<std::uint64_t> draws_seen{0};
  std::atomic<std::uint64_t> draws_refined{0};
  std::array<std::atomic<std::uint64_t>, cause_count> passed_through{};
  // Refined draws that did not get the wanted refinement.
  std::array<std::atomic<std::uint64_t>, refinement_fallback_count> fallen_back{};
  std::atomic<std::uint64_t> coarse_triangles{0};
  // Exact for uniform draws; adaptive draws count on the GPU and are added when the buffer is next reused.
  std::atomic<std::uint64_t> refined_triangles{0};
  std::atomic<std::uint64_t> captures_made{0};
  std::atomic<std::uint64_t> captures_reused{0};
  std::atomic<std::uint64_t> draws_of_kept_vertices{0};
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
// Notes why the program could not be refined; the first reason stays.
void note_program_problem(std::uint64_t hash, const std::string& problem);
// `problem` is empty if there is none.
void for_each_program(
    const std::function<void(std::uint64_t hash, const ProgramCounters&, const std::string& problem)>& visit);

// Notes that a context was made. `version` is its GL_VERSION.
void note_context(const std::string& version, bool refinable);
void for_each_context_version(
    const std::function<void(const std::string& version, bool refinable, std::uint64_t contexts)>& visit);

}  // namespace glark::core
