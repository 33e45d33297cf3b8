// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/doctor/diagnosis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <set>
#include <string_view>

#include "glark/core/report/cause.h"
#include "glark/core/report/refinement_fallback.h"

namespace glark::tool {
namespace {

constexpr std::size_t most_problems = 3;
constexpr std::size_t most_remedies = 4;
constexpr std::uint64_t rare = 100;  // a cause with less than a hundredth of the draws needs no remedy

using Lines = std::vector<std::string>;

struct Words {
  std::string_view explanation;
  std::string_view remedy;
};

// Returns the explanation of a cause or a fallback; the key itself if this launcher does not know it.
Words words_of(std::string_view key) {
  for (unsigned i = 0; i < core::cause_count; ++i)
    if (const core::CauseText& text = core::text_of(static_cast<core::Cause>(i)); text.key == key)
      return {text.explanation, text.remedy};
  for (unsigned i = 0; i < core::refinement_fallback_count; ++i)
    if (const core::FallbackText& text = core::text_of(static_cast<core::RefinementFallback>(i)); text.key == key)
      return {text.explanation, text.remedy};
  return {key, "nothing to do"};
}

std::string share_of(std::uint64_t part, std::uint64_t whole) {
  const double percent = whole == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
  return percent > 0 && percent < 1 ? "less than 1 %" : fmt::format("{:.0f} %", percent);
}

std::string counted(std::uint64_t number, std::string_view noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

std::string sentence_about_end(const Observation& o) {
  const Ending& end = o.ending;
  if (end.how == Ending::How::stopped)
    return fmt::format("{} ran for {:.1f} s and was stopped.", o.program, end.seconds);
  if (end.how == Ending::How::crashed)
    return fmt::format(
        "{} was ended by a signal after {:.1f} s: {}. Run it without glark: if it ends in the same way, glark is not "
        "the "
        "cause; if not, please report it (docs/how-to/report-a-bug.md).",
        o.program, end.seconds, strsignal(end.status));
  return fmt::format("{} ended by itself after {:.1f} s with exit status {}.", o.program, end.seconds, end.status);
}

void add_contexts(const ProcessReport& report, Lines& lines) {
  for (const ProcessReport::Context& context : report.contexts)
    if (!context.refinable)
      lines.push_back(
          fmt::format("  Its context {} cannot refine: OpenGL 4.3 or OpenGL ES 3.2 is needed. glark info shows what "
                      "this machine has.",
                      context.version));
}

void add_refined(const ProcessReport& report, Lines& lines) {
  if (report.refined == 0) {
    lines.push_back("  No draw was refined.");
    return;
  }
  std::string kinds;
  for (const Count& kind : report.refinements)
    kinds += fmt::format("{}{} by {}", kinds.empty() ? "" : ", ", kind.second, kind.first);
  lines.push_back(fmt::format("  Refined: {} ({}){}{}. {} triangles became {}.", counted(report.refined, "draw"),
                              share_of(report.refined, report.seen), kinds.empty() ? "" : ": ", kinds,
                              report.coarse_triangles, report.refined_triangles));
}

void add_left(const ProcessReport& report, Lines& lines) {
  for (const Count& cause : report.left)
    lines.push_back(fmt::format("  Left alone: {} ({}; {}): {}.", counted(cause.second, "draw"),
                                share_of(cause.second, report.seen), cause.first, words_of(cause.first).explanation));
  for (const Count& fallback : report.fallbacks)
    lines.push_back(fmt::format("  Not as wanted: {} ({}): {}.", counted(fallback.second, "draw"), fallback.first,
                                words_of(fallback.first).explanation));
  for (std::size_t i = 0; i < std::min(report.problems.size(), most_problems); ++i)
    lines.push_back("  Shader program " + report.problems[i]);
}

void add_process(const ProcessReport& report, Lines& lines) {
  lines.push_back(fmt::format("{} (process {}): {}, {}.", report.name, report.number, counted(report.frames, "frame"),
                              counted(report.seen, "draw")));
  add_contexts(report, lines);
  if (report.seen == 0) {
    lines.push_back(
        "  It made a context but drew nothing that glark sees: it may still have loaded, or wait for input.");
    return;
  }
  add_refined(report, lines);
  add_left(report, lines);
}

void add_remedies(const Observation& o, Lines& lines) {
  std::set<std::string_view> said;
  for (const ProcessReport& report : o.reports) {
    for (const std::vector<Count>* counts : {&report.left, &report.fallbacks}) {
      for (const Count& count : *counts) {
        const std::string_view remedy = words_of(count.first).remedy;
        const bool useful = !remedy.starts_with("nothing to do") && count.second * rare >= report.seen;
        if (!useful || said.size() >= most_remedies || !said.insert(remedy).second) continue;
        lines.push_back(fmt::format("Try ({}): {}.", count.first, remedy));
      }
    }
  }
}

// No process made a context: says why that may be.
void add_absence(const Observation& o, Lines& lines) {
  const auto any = [&](bool SeenProcess::*has) {
    return std::any_of(o.processes.begin(), o.processes.end(), [&](const SeenProcess& p) { return p.*has; });
  };
  lines.push_back("No process made an OpenGL context that glark sees.");
  if (!o.has_display)
    lines.push_back("Neither DISPLAY nor WAYLAND_DISPLAY is set: a program with a window needs one, or xvfb-run.");
  for (const SeenProcess& process : o.processes)
    if (process.has_gl && !process.has_glark)
      lines.push_back(
          fmt::format("{} (process {}) uses OpenGL, but the library did not reach it: it is set-uid or in a "
                      "sandbox, or its parent clears the environment.",
                      process.name, process.number));
  if (any(&SeenProcess::has_vulkan) && !any(&SeenProcess::has_gl))
    lines.push_back(
        "It uses Vulkan, which glark does not refine: look for an option of the program that selects OpenGL.");
  else if (any(&SeenProcess::has_vulkan))
    lines.push_back("It has loaded Vulkan, too: if it draws by that, look for an option that selects OpenGL.");
  const bool short_lived = o.ending.how == Ending::How::left && o.ending.status == 0 && o.ending.seconds < 2;
  if (short_lived)
    lines.push_back(
        "It ended at once: it may have handed its work to a copy of itself that runs already; end that first.");
  if (lines.size() == 2) lines.push_back("It may draw later than the doctor looked (--seconds), or without OpenGL.");
}

}  // namespace

bool is_refined(const Observation& o) {
  return std::any_of(o.reports.begin(), o.reports.end(),
                     [](const ProcessReport& report) { return report.refined > 0; });
}

std::vector<std::string> diagnosis(const Observation& o) {
  Lines lines{sentence_about_end(o)};
  if (o.reports.empty()) {
    add_absence(o, lines);
    return lines;
  }
  for (const ProcessReport& report : o.reports) add_process(report, lines);
  add_remedies(o, lines);
  const bool only_linear =
      is_refined(o) && std::all_of(o.reports.begin(), o.reports.end(), [](const ProcessReport& report) {
        return std::all_of(report.refinements.begin(), report.refinements.end(),
                           [](const Count& kind) { return kind.first == "linear" || kind.first == "outputs"; });
      });
  if (only_linear)
    lines.push_back("Try: flat refinement looks like the original on purpose; --refine pn curves what has normals.");
  return lines;
}

}  // namespace glark::tool
