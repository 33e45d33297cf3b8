// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/report/statistics.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <deque>
#include <exception>
#include <fstream>
#include <functional>
#include <mutex>
#include <numeric>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "glark/core/report/cause.h"
#include "glark/core/report/log.h"
#include "glark/core/report/statistics.h"
#include "glark/core/state/programs/program.h"
#include "shim/report/draw_classes.h"
#include "shim/report/options.h"

namespace glark::shim {
namespace {

using Clock = std::chrono::steady_clock;

// A killed program leaves statistics that are at most this old, or those of its first frame.
constexpr auto write_interval = std::chrono::milliseconds(250);

// Only the latest frames are kept: enough for a mean and a median.
constexpr std::size_t kept_frames = 8192;

// Counts the frames of all contexts of the process.
std::atomic<unsigned long> frames{0};

struct Totals {
  std::uint64_t seen = 0;
  std::uint64_t refined = 0;
  std::uint64_t coarse_triangles = 0;
  std::uint64_t refined_triangles = 0;
  std::array<std::uint64_t, core::cause_count> passed_through{};

  Totals since(const Totals& before) const {
    Totals result{seen - before.seen,
                  refined - before.refined,
                  coarse_triangles - before.coarse_triangles,
                  refined_triangles - before.refined_triangles,
                  {}};
    std::transform(passed_through.begin(), passed_through.end(), before.passed_through.begin(),
                   result.passed_through.begin(), std::minus<>());
    return result;
  }
};

struct FrameRecord {
  unsigned long number = 0;
  double ms = 0;
  Totals counts;
};

// The statistics file shows this many of the latest frames.
constexpr std::size_t shown_frames = 16;

struct Times {
  std::mutex mutex;
  std::atomic<pid_t> process{0};  // the process that made a context
  Clock::time_point start;
  Clock::time_point last_frame;
  std::vector<double> frame_ms;
  std::size_t next = 0;
  Clock::time_point last_write;
  std::deque<FrameRecord> last_frames;
  Totals before;  // at the end of the last frame
};

// Never destroyed, because a destructor of this library reads it.
Times& times() {
  static Times& instance = *new Times;
  return instance;
}

double milliseconds(Clock::duration duration) { return std::chrono::duration<double, std::milli>(duration).count(); }

nlohmann::json frame_times(std::vector<double> ms) {
  if (ms.empty()) return {{"mean", nullptr}, {"median", nullptr}};
  const auto middle = ms.begin() + static_cast<std::ptrdiff_t>(ms.size() / 2);
  std::nth_element(ms.begin(), middle, ms.end());
  return {{"mean", std::accumulate(ms.begin(), ms.end(), 0.0) / static_cast<double>(ms.size())}, {"median", *middle}};
}

nlohmann::json passed_through(const Totals& counts) {
  nlohmann::json causes = nlohmann::json::object();
  for (unsigned i = 0; i < core::cause_count; ++i)
    if (const std::uint64_t count = counts.passed_through[i])
      causes[std::string(core::text_of(static_cast<core::Cause>(i)).key)] = count;
  return causes;
}

nlohmann::json fallbacks(const core::Statistics& counters) {
  nlohmann::json reasons = nlohmann::json::object();
  for (unsigned i = 0; i < core::refinement_fallback_count; ++i)
    if (const auto count = counters.fallen_back[i].load())
      reasons[std::string(core::text_of(static_cast<core::RefinementFallback>(i)).key)] = count;
  return reasons;
}

// How often each shader program was used, by the hash of its sources.
nlohmann::json shaders() {
  nlohmann::json all = nlohmann::json::object();
  core::for_each_program([&](std::uint64_t hash, const core::ProgramCounters& counters, const std::string& problem) {
    nlohmann::json& shader = all[core::hash_text(hash)];
    shader = {{"seen", counters.draws_seen.load()}, {"refined", counters.draws_refined.load()}};
    if (!problem.empty()) shader["problem"] = problem;
  });
  return all;
}

nlohmann::json contexts() {
  nlohmann::json all = nlohmann::json::array();
  core::for_each_context_version([&](const std::string& version, bool refinable, std::uint64_t count) {
    all.push_back({{"version", version}, {"refinable", refinable}, {"count", count}});
  });
  return all;
}

// Sums of all frames so far.
Totals totals() {
  const core::Statistics& counters = core::statistics();
  Totals sums{counters.draws_seen.load(),
              counters.draws_refined.load(),
              counters.coarse_triangles.load(),
              counters.refined_triangles.load(),
              {}};
  for (unsigned i = 0; i < core::cause_count; ++i) sums.passed_through[i] = counters.passed_through[i].load();
  return sums;
}

nlohmann::json last_frames(const Times& all) {
  nlohmann::json records = nlohmann::json::array();
  for (const FrameRecord& frame : all.last_frames)
    records.push_back({{"frame", frame.number},
                       {"ms", frame.ms},
                       {"seen", frame.counts.seen},
                       {"refined", frame.counts.refined},
                       {"passed_through", passed_through(frame.counts)},
                       {"coarse_triangles", frame.counts.coarse_triangles},
                       {"refined_triangles", frame.counts.refined_triangles}});
  return records;
}

nlohmann::json report(Times& all) {
  const core::Statistics& counters = core::statistics();
  return {
      {"program", program_invocation_short_name},
      {"process", getpid()},
      {"draws",
       {{"seen", counters.draws_seen.load()},
        {"refined", counters.draws_refined.load()},
        {"passed_through", passed_through(totals())},
        {"fallbacks", fallbacks(counters)}}},
      {"classes", draw_classes()},
      {"contexts", contexts()},
      {"coarse_triangles", counters.coarse_triangles.load()},
      {"refined_triangles", counters.refined_triangles.load()},
      {"captures",
       {{"made", counters.captures_made.load()},
        {"reused", counters.captures_reused.load()},
        {"kept_refined", counters.draws_of_kept_vertices.load()}}},
      {"programs", {{"derived", counters.programs_derived.load()}, {"failed", counters.programs_failed.load()}}},
      {"shaders", shaders()},
      {"frames", frames.load()},
      {"frame_ms", frame_times(all.frame_ms)},
      {"last_frames", last_frames(all)},
      {"seconds", milliseconds(Clock::now() - all.start) / 1000},
  };
}

void note_frame(Times& all, double ms) {
  const Totals now = totals();
  all.last_frames.push_back({frames.load(std::memory_order_relaxed), ms, now.since(all.before)});
  if (all.last_frames.size() > shown_frames) all.last_frames.pop_front();
  all.before = now;
}

// "%p" stands for the number of the process, so that the processes of a browser write a file each.
std::string file_of_process(std::string file) {
  for (std::size_t at = file.find("%p"); at != std::string::npos; at = file.find("%p", at + 1))
    file.replace(at, 2, std::to_string(getpid()));
  return file;
}

// Writes another file and renames it, so that a reader never sees half a file.
void write_file(const std::string& file, const std::string& text) {
  const std::string aside = fmt::format("{}.{}", file, getpid());
  {
    std::ofstream out(aside);
    out << text << '\n';
    if (!out.flush()) {
      core::log(core::LogLevel::error,
                fmt::format("the statistics cannot be written to {}: {}; name a file in a folder that "
                            "can be written with GLARK_STATS",
                            aside, std::strerror(errno)));
      return;
    }
  }
  if (std::rename(aside.c_str(), file.c_str()) != 0)
    core::log(core::LogLevel::error,
              fmt::format("the statistics cannot be renamed to {}: {}", file, std::strerror(errno)));
}

__attribute__((destructor)) void write_at_exit() { write_statistics(); }

}  // namespace

void context_made() {
  Times& all = times();
  const std::lock_guard lock(all.mutex);
  if (all.process == getpid()) return;
  all.process = getpid();
  all.start = all.last_frame = Clock::now();
}

void frame_counted() {
  Times& all = times();
  bool write = false;
  frames.fetch_add(1, std::memory_order_relaxed);
  {
    const std::lock_guard lock(all.mutex);
    const Clock::time_point now = Clock::now();
    if (all.frame_ms.size() < kept_frames) all.frame_ms.emplace_back();
    const double ms = milliseconds(now - all.last_frame);
    all.frame_ms[all.next++ % kept_frames] = ms;
    all.last_frame = now;
    note_frame(all, ms);
    write = now - all.last_write > write_interval;
    if (write) all.last_write = now;
  }
  if (write) write_statistics();
}

FrameFigures last_frame() {
  Times& all = times();
  const std::lock_guard lock(all.mutex);
  if (all.last_frames.empty()) return {};
  const FrameRecord& frame = all.last_frames.back();
  return {frame.number,
          frame.ms,
          frame.counts.seen,
          frame.counts.refined,
          frame.counts.coarse_triangles,
          frame.counts.refined_triangles,
          frame.counts.passed_through};
}

unsigned long current_frame() { return frames.load(std::memory_order_relaxed) + 1; }

bool has_made_context() { return times().process == getpid(); }

void write_statistics() {
  Times& all = times();
  if (!has_made_context() || options().statistics_file.empty()) return;
  try {
    const std::lock_guard lock(all.mutex);
    write_file(file_of_process(options().statistics_file), report(all).dump(2));
  } catch (const std::exception& error) {
    core::log(core::LogLevel::error, fmt::format("the statistics cannot be written: {}", error.what()));
  }
}

}  // namespace glark::shim
