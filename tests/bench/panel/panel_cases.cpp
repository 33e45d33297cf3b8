// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Measures what the panel of glark run --overlay adds to a frame of 1280 x 720 pixels. glark-bench-frames runs in turn
// without glark, with glark but no panel, with the panel closed, and with the panel open. The best of each is compared.
#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <string>

#include "tests/bench/cases/case.h"

namespace glark::bench {
namespace {

constexpr int runs = 7;
constexpr double most_added_open = 1;       // milliseconds
constexpr double most_added_closed = 0.05;  // 0, up to the noise of the best times

struct Variant {
  const char* name;
  const char* settings;
  bool shows_panel;
  double ms = 1e9;            // of the fastest frame
  double processor_ms = 1e9;  // of all threads
};

void run_program(Variant& variant) {
  const std::string command = std::string(GLARK_BENCH_DISPLAY) +
                              " --screen 1280x720x24 -- env LIBGL_ALWAYS_SOFTWARE=1 " + "SDL_VIDEODRIVER=x11 " +
                              variant.settings + " " + GLARK_BENCH_FRAMES + " 1280 720 200";
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run glark-bench-frames");
  std::array<char, 128> line{};
  const bool has_line = std::fgets(line.data(), static_cast<int>(line.size()), pipe) != nullptr;
  const int status = pclose(pipe);
  std::istringstream words(line.data());
  double median = 0;
  double ms = 0;
  double processor_ms = 0;
  int shows_panel = 0;
  if (!has_line || status != 0 || !(words >> median >> ms >> processor_ms >> shows_panel))
    throw std::runtime_error(std::string("glark-bench-frames failed: ") + variant.name);
  if ((shows_panel != 0) != variant.shows_panel)
    throw std::runtime_error(std::string("the panel is not as wanted: ") + variant.name);
  variant.ms = std::min(variant.ms, ms);
  variant.processor_ms = std::min(variant.processor_ms, processor_ms);
}

void run(Report& report, const Effort&) {
  const std::string glark =
      std::string("LD_PRELOAD=") + GLARK_BENCH_LIBRARY + " GLARK_CONFIG=/dev/null GLARK_ENABLE=1 GLARK_WAIT=1";
  const std::string closed_settings = glark + " GLARK_OVERLAY=1";
  const std::string open_settings = closed_settings + " GLARK_OVERLAY_OPEN=1";
  Variant none{"none", "", false};
  Variant refined{"refined", glark.c_str(), false};
  Variant closed{"closed", closed_settings.c_str(), false};
  Variant open{"open", open_settings.c_str(), true};
  for (int i = 0; i < runs; ++i)
    for (Variant* variant : {&none, &refined, &closed, &open}) run_program(*variant);
  std::map<std::string, double> detail;
  for (const Variant* variant : {&none, &refined, &closed, &open}) {
    detail[std::string(variant->name) + "_ms"] = variant->ms;
    detail[std::string(variant->name) + "_processor_ms"] = variant->processor_ms;
  }
  detail["open_over_closed"] = open.ms / closed.ms;
  detail["closed_over_refined"] = closed.ms / refined.ms;
  report.add(
      {"panel/1280x720/closed/added", "", Goal::at_most, most_added_closed, closed.ms - refined.ms, "ms", detail});
  report.add({"panel/1280x720/open/added", "", Goal::at_most, most_added_open, open.ms - closed.ms, "ms", detail});
}

}  // namespace

void add_panel_cases(std::vector<Case>& cases) { cases.push_back({"panel", run}); }

}  // namespace glark::bench
