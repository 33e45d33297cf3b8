// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/report/statistics.h"

#include <map>
#include <mutex>

namespace glark::core {
namespace {

struct ProgramTable {
  std::mutex mutex;
  std::map<std::uint64_t, ProgramCounters> programs;
};

ProgramTable& program_table() {
  static ProgramTable* const instance = new ProgramTable;  // never destroyed, like the statistics
  return *instance;
}

}  // namespace

ProgramCounters& program_counters(std::uint64_t hash) {
  ProgramTable& table = program_table();
  const std::lock_guard lock(table.mutex);
  return table.programs[hash];
}

void for_each_program(const std::function<void(std::uint64_t, const ProgramCounters&)>& visit) {
  ProgramTable& table = program_table();
  const std::lock_guard lock(table.mutex);
  for (const auto& [hash, counters] : table.programs) {
    visit(hash, counters);
  }
}

Statistics& statistics() {
  static Statistics* const instance = new Statistics;  // never destroyed: drivers may draw from their own exit handlers
  return *instance;
}

}  // namespace glark::core
