// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/live/live_settings.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "glark/core/report/log.h"
#include "shim/report/options.h"

namespace glark::shim {
namespace {

struct Live {
  std::mutex mutex;
  core::ContextOptions options = shim::options().context;
  std::vector<std::string> known_problems;
  std::atomic<std::uint64_t> generation{0};
};

// Never destroyed, because drivers may draw from their exit handlers.
Live& live() {
  static Live& instance = *new Live;
  return instance;
}

// A problem is told once, not each time the file is read.
void tell_new_problems(Live& all, const std::vector<std::string>& problems) {
  for (const std::string& problem : problems) {
    if (std::find(all.known_problems.begin(), all.known_problems.end(), problem) != all.known_problems.end()) continue;
    all.known_problems.push_back(problem);
    core::log(core::LogLevel::warning, problem);
  }
}

}  // namespace

std::uint64_t live_generation() { return live().generation.load(std::memory_order_relaxed); }

core::ContextOptions live_options() {
  Live& all = live();
  const std::lock_guard lock(all.mutex);
  return all.options;
}

void change_live(const std::function<void(core::ContextOptions&)>& change) {
  Live& all = live();
  const std::lock_guard lock(all.mutex);
  change(all.options);
  all.generation.fetch_add(1, std::memory_order_relaxed);
}

void toggle_refinement() {
  change_live([](core::ContextOptions& options) {
    options.live.paused = !options.live.paused;
    core::log(core::LogLevel::info, options.live.paused ? "refinement is switched off" : "refinement is switched on");
  });
}

void read_settings_again() {
  settings::Parsed parsed = settings::parse(first_environment(), program_names());
  Live& all = live();
  const std::lock_guard lock(all.mutex);
  tell_new_problems(all, parsed.problems);
  const bool split = parsed.settings.context.live.split;
  parsed.settings.context.live = all.options.live;
  parsed.settings.context.live.split = split;
  // `leave-alone` cannot be taken back otherwise: contexts that are refined stay ready for it.
  if (parsed.settings.leave_alone) parsed.settings.context.live.paused = true;
  all.options = std::move(parsed.settings.context);
  all.generation.fetch_add(1, std::memory_order_relaxed);
  core::log(core::LogLevel::info, "the settings were read again");
}

}  // namespace glark::shim
