// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Counts draws by class: draws in the same state for which the same was decided. For the statistics file only.
#pragma once

#include <atomic>
#include <compare>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>

#include "glark/core/draw_rule.h"
#include "glark/core/refinement.h"
#include "glark/core/report/cause.h"
#include "glark/core/report/refinement_fallback.h"

namespace glark::core {

// What was decided about a draw. Without a cause, it is refined.
struct DrawVerdict {
  std::optional<Cause> cause;
  Refinement refinement = Refinement::linear_inputs;
  std::optional<RefinementFallback> fallback;
  bool measured = false;
  unsigned level = 0;  // if its depths are not measured
  auto operator<=>(const DrawVerdict&) const = default;
};

struct DrawClassKey {
  DrawState state = {};
  DrawVerdict verdict = {};
  auto operator<=>(const DrawClassKey&) const = default;
};

struct DrawClassCounters {
  std::atomic<std::uint64_t> draws{0};
  std::atomic<std::uint64_t> triangles{0};  // of the application
  std::atomic<std::uint64_t> frames{0};     // in which it was drawn
};

// Beyond this number of classes in the process, draws count in one class that has no state.
inline constexpr std::size_t most_draw_classes = 512;

// Counts the draws of one context.
class DrawClasses {
 public:
  void count(const DrawClassKey& key, std::uint64_t triangles);
  void frame_finished() { ++frame_; }

 private:
  struct Entry {
    DrawClassCounters* counters = nullptr;
    std::uint64_t last_frame = 0;  // the number of a frame, counted from 1
  };
  std::map<DrawClassKey, Entry> entries_;
  Entry others_;
  std::uint64_t frame_ = 1;
};

// Visits the classes of all contexts. The key is null for the class of those beyond the limit.
void for_each_draw_class(const std::function<void(const DrawClassKey*, const DrawClassCounters&)>& visit);

}  // namespace glark::core
