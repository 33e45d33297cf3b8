// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/report/statistics.h"

#include <map>
#include <mutex>
#include <utility>

namespace glark::core {
namespace {

struct ProgramEntry {
  ProgramCounters counters;
  std::string problem;
};

struct ProgramTable {
  std::mutex mutex;
  std::map<std::uint64_t, ProgramEntry> programs;
};

ProgramTable& program_table() {
  static ProgramTable* const instance = new ProgramTable;  // never destroyed, like the statistics
  return *instance;
}

// By version, and by whether such contexts can refine.
struct ContextTable {
  std::mutex mutex;
  std::map<std::pair<std::string, bool>, std::uint64_t> contexts;
};

ContextTable& context_table() {
  static ContextTable* const instance = new ContextTable;
  return *instance;
}

}  // namespace

ProgramCounters& program_counters(std::uint64_t hash) {
  ProgramTable& table = program_table();
  const std::lock_guard lock(table.mutex);
  return table.programs[hash].counters;
}

void note_program_problem(std::uint64_t hash, const std::string& problem) {
  ProgramTable& table = program_table();
  const std::lock_guard lock(table.mutex);
  std::string& kept = table.programs[hash].problem;
  kept = kept.empty() ? problem : kept;
}

void for_each_program(
    const std::function<void(std::uint64_t, const ProgramCounters&, const std::string& problem)>& visit) {
  ProgramTable& table = program_table();
  const std::lock_guard lock(table.mutex);
  for (const auto& [hash, entry] : table.programs) {
    visit(hash, entry.counters, entry.problem);
  }
}

void note_context(const std::string& version, bool refinable) {
  ContextTable& table = context_table();
  const std::lock_guard lock(table.mutex);
  ++table.contexts[{version, refinable}];
}

void for_each_context_version(const std::function<void(const std::string&, bool, std::uint64_t)>& visit) {
  ContextTable& table = context_table();
  const std::lock_guard lock(table.mutex);
  for (const auto& [kind, contexts] : table.contexts) {
    visit(kind.first, kind.second, contexts);
  }
}

Statistics& statistics() {
  static Statistics* const instance = new Statistics;  // never destroyed: drivers may draw from their own exit handlers
  return *instance;
}

}  // namespace glark::core
