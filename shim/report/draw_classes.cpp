// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/report/draw_classes.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "glark/core/report/draw_classes.h"
#include "glark/core/state/programs/program.h"
#include "glark/settings/rules.h"

namespace glark::shim {
namespace {

nlohmann::json state_of(const core::DrawState& state) {
  return {{"depth_test", state.depth_test},
          {"depth_writes", state.depth_writes},
          {"depth_function", settings::depth_function_name(state.depth_function)},
          {"blend", state.blend},
          {"color_writes", state.color_writes},
          {"depth_only", state.depth_only},
          {"viewport", state.viewport}};
}

// "refined" as a verdict has a refinement, "left" has a cause.
void add_verdict(const core::DrawVerdict& verdict, nlohmann::json& entry) {
  entry["verdict"] = verdict.cause ? "left" : "refined";
  if (verdict.fallback) entry["fallback"] = core::text_of(*verdict.fallback).key;
  if (verdict.cause) {
    entry["cause"] = core::text_of(*verdict.cause).key;
    return;
  }
  entry["refinement"] = core::traits_of(verdict.refinement).word;
  if (verdict.measured)
    entry["level"] = "measured";
  else
    entry["level"] = verdict.level;
}

}  // namespace

nlohmann::json draw_classes() {
  std::vector<std::pair<std::uint64_t, nlohmann::json>> sorted;
  core::for_each_draw_class([&](const core::DrawClassKey* key, const core::DrawClassCounters& counters) {
    nlohmann::json entry = {
        {"draws", counters.draws.load()}, {"triangles", counters.triangles.load()}, {"frames", counters.frames.load()}};
    if (key != nullptr) {
      const core::DrawState& state = key->state;
      entry["program"] = state.program == 0 ? std::string("unknown") : core::hash_text(state.program);
      entry["fixed_function"] = state.fixed_function;
      entry["state"] = state_of(state);
      add_verdict(key->verdict, entry);
    } else {
      entry["verdict"] = "others";
    }
    sorted.emplace_back(counters.triangles.load(), std::move(entry));
  });
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  nlohmann::json all = nlohmann::json::array();
  for (auto& [triangles, entry] : sorted) all.push_back(std::move(entry));
  return all;
}

}  // namespace glark::shim
