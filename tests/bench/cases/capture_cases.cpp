// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Measures the cost of a draw before its refined triangles are drawn: the capture, and binning where tags differ. All
// triangles are culled, so nothing is rasterised.
#include <algorithm>

#include "tests/bench/cases/case.h"
#include "tests/bench/subject/subject.h"

namespace glark::bench {
namespace {

constexpr unsigned pool_level = 6;

Mesh mesh_of(int triangles) {
  const Mesh sphere = make_sphere(std::max(20, triangles));
  return first_triangles(sphere, static_cast<std::size_t>(triangles));
}

// Draws once before the timing. This fills the caches again after the draws of the competitors.
Competitor settled(const Competitor& competitor) {
  return {[competitor] {
            competitor.prepare();
            for (int i = 0; i < 3; ++i) competitor.draw();
          },
          competitor.draw};
}

// The times of one draw.
struct Costs {
  double coarse = 0;            // the original draw
  double cached = 0;            // refined to level 1 with a cached capture, minus the coarse draw
  double uniform_capture = 0;   // additional time of the capture
  double adaptive_capture = 0;  // additional time of the capture and of binning, with all tags 1
  double adaptive_flat = 0;     // with all tags 0, minus the coarse draw
};

Costs measure(int triangles, const Effort& effort) {
  const Mesh mesh = mesh_of(triangles);
  const Subject plain(mesh, Shading::glsl, View::culled);
  const Subject zeros(mesh, Shading::glsl, View::culled, std::vector<std::uint8_t>(mesh.vertices.size(), 0));
  const Subject ones(mesh, Shading::glsl, View::culled, std::vector<std::uint8_t>(mesh.vertices.size(), 1));
  Effort longer = effort;
  longer.total_seconds *= 2;
  // 0 coarse, 1 coarse touched, 2 refined, 3 refined touched, 4 adaptive 1 touched, 5 adaptive 0 touched
  const auto times =
      interleave({plain.as_is(), plain.touched(plain.as_is()), settled(plain.refined(1)),
                  plain.touched(plain.refined(1)), ones.touched(ones.tagged()), zeros.touched(zeros.tagged())},
                 longer);
  return {least_combination(times, {1, 0, 0, 0, 0, 0}), least_combination(times, {-1, 0, 1, 0, 0, 0}),
          least_combination(times, {1, -1, -1, 1, 0, 0}), least_combination(times, {1, -1, -1, 0, 1, 0}),
          least_combination(times, {0, -1, 0, 0, 0, 1})};
}

void run_many(int triangles, Report& report, const Effort& effort) {
  glARKinit(pool_level);
  const Costs costs = measure(triangles, effort);
  const double each = 1e6 / triangles;
  const std::string name = "capture/" + std::to_string(triangles);
  const Goal goal = triangles >= 10000 ? Goal::at_most : Goal::none;
  constexpr double most = 0.15;
  report.add({name + "/uniform",
              "",
              goal,
              most,
              costs.uniform_capture * each,
              "us/triangle",
              {{"coarse_us", costs.coarse * each}}});
  report.add({name + "/adaptive",
              "",
              goal,
              most,
              costs.adaptive_capture * each,
              "us/triangle",
              {{"coarse_us", costs.coarse * each}}});
  report.add({name + "/level0-over-coarse",
              "prototype 0.34 us",
              Goal::none,
              0,
              costs.adaptive_flat * each,
              "us/triangle",
              {{"coarse_us", costs.coarse * each}}});
}

void run_one(Report& report, const Effort& effort) {
  glARKinit(pool_level);
  const Costs costs = measure(1, effort);
  constexpr double us = 1e6;
  report.add({"capture/1/coarse-draw", "", Goal::none, 0, costs.coarse * us, "us/draw", {}});
  report.add({"capture/1/refined-kept", "", Goal::none, 0, costs.cached * us, "us/draw", {}});
  report.add(
      {"capture/1/refined-captured", "", Goal::none, 0, (costs.cached + costs.uniform_capture) * us, "us/draw", {}});
  report.add({"capture/1/adaptive-captured",
              "prototype 100 us",
              Goal::none,
              0,
              (costs.cached + costs.adaptive_capture) * us,
              "us/draw",
              {}});
}

}  // namespace

void add_capture_cases(std::vector<Case>& cases) {
  cases.push_back({"capture/1", run_one});
  for (const int triangles : {100, 1000, 10000, 100000}) {
    cases.push_back({"capture/" + std::to_string(triangles),
                     [triangles](Report& report, const Effort& effort) { run_many(triangles, report, effort); }});
  }
}

}  // namespace glark::bench
