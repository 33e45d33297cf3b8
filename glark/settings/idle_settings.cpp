// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/settings/idle_settings.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "glark/settings/table.h"

namespace glark::settings {
namespace {

bool measures(const Settings& s) { return s.context.measure.on(); }
bool curves(const Settings& s) { return core::traits_of(s.context.refinement).curves_positions; }

struct IdleRow {
  std::string_view key;
  bool (*idle)(const Settings& settings);
  std::string_view why;  // completes "--KEY "
};

// clang-format off
constexpr std::array rows{
    IdleRow{"level", [](const Settings& s) { return s.context.level == 0 && !measures(s) && !s.context.centroids; },
            "0 refines nothing; give a level of 1 or more"},
    IdleRow{"level", [](const Settings& s) { return s.context.measure.pixels > 0 || s.context.measure.error > 0; },
            "has no effect on draws that --edge-pixels or --screen-error measures; --max-level limits their depth"},
    IdleRow{"max-level", [](const Settings& s) { return !measures(s) && !s.is_given("level"); },
            "has no effect without --level, --edge-pixels, --curvature or --screen-error"},
    IdleRow{"budget", [](const Settings& s) { return s.context.measure.budget > 0 && !measures(s); },
            "has no effect without --edge-pixels, --curvature or --screen-error"},
    IdleRow{"geomorph", [](const Settings& s) { return s.context.geomorph && !measures(s); },
            "has no effect without --edge-pixels, --curvature or --screen-error"},
    IdleRow{"no-weld", [](const Settings& s) { return !s.context.weld && !curves(s) && s.context.measure.degrees == 0 && s.context.measure.error == 0; },
            "has no effect without --curvature, --screen-error or a --refine that curves triangles"},
    IdleRow{"normals", [](const Settings& s) { return s.context.geometry_normals && (!s.context.weld || !curves(s)); },
            "has no effect with --no-weld, or without a --refine that curves triangles"},
    IdleRow{"leave-draws", [](const Settings& s) { return s.everything; }, "has no effect beside --everything"},
    IdleRow{"leave-shaders", [](const Settings& s) { return s.everything; }, "has no effect beside --everything"},
    IdleRow{"overlay-open", [](const Settings& s) { return s.overlay_open && !s.overlay; }, "has no effect without --overlay"},
    IdleRow{"overlay-key", [](const Settings& s) { return !s.overlay; }, "has no effect without --overlay"},
    IdleRow{"everything", [](const Settings& s) { return s.everything && s.leave_alone; },
            "has no effect beside --leave-alone"},
};
// clang-format on

void add_shape_numbers(const Settings& settings, std::vector<std::string>& sentences) {
  for (const core::RefinementTraits& row : core::refinements)
    if (row.number.exists() && settings.is_given(row.number.key) && settings.context.refinement != row.refinement)
      sentences.push_back(fmt::format("--{} has no effect without --refine {}", row.number.key, row.word));
}

}  // namespace

std::vector<std::string> idle_settings(const Settings& settings) {
  std::vector<std::string> sentences;
  for (const IdleRow& row : rows)
    if (settings.is_given(row.key) && row.idle(settings)) sentences.push_back(fmt::format("--{} {}", row.key, row.why));
  add_shape_numbers(settings, sentences);
  return sentences;
}

}  // namespace glark::settings
