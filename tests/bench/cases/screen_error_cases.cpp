// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Adaptive and uniform refinement of the meshes of figure 7.13 with the same error on the screen (GL_SCREEN_ERROR_ARK).
#include <cmath>

#include "tests/bench/cases/case.h"
#include "tests/bench/cases/figure_meshes.h"
#include "tests/bench/offscreen.h"
#include "tests/bench/screen_error.h"
#include "tests/bench/subject/subject.h"

namespace glark::bench {
namespace {

constexpr unsigned deepest = 11;
constexpr float pixels_at_one = 0.5F * picture_size / 0.35F;

// Returns how many triangles the competitor draws.
double triangles_of(const Competitor& competitor) {
  GLuint query = 0;
  GLuint count = 0;
  glGenQueries(1, &query);
  competitor.prepare();
  glBeginQuery(GL_PRIMITIVES_GENERATED, query);
  competitor.draw();
  glEndQuery(GL_PRIMITIVES_GENERATED);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
  glDeleteQueries(1, &query);
  return count;
}

// Draws until the refined vertices are kept.
void keep(const Competitor& competitor) {
  competitor.prepare();
  for (int i = 0; i < 45; ++i) competitor.draw();
}

// Returns the largest screen error whose silhouettes are as good as `limit`, in steps of a quarter of a level.
float error_within(const Subject& subject, const ErrorMeter& meter, double limit) {
  const auto error = [](int step) { return std::exp2(-0.5F * static_cast<float>(step)); };
  int good = 20;  // 1/1024 of a pixel
  int bad = -6;   // 8 pixels
  while (good - bad > 1) {
    const int step = bad + (good - bad) / 2;
    const bool fits = meter.of(subject.measured(ErrorMeter::zoom * error(step))).silhouette <= limit;
    (fits ? good : bad) = step;
  }
  return error(good);
}

void compare(Report& report, const Effort& effort, const std::string& name, const Mesh& mesh, View view) {
  glARKinit(deepest);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  glARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  const Subject subject(mesh, Shading::glsl, view);
  const ErrorMeter meter(subject.refined(7), pixels_at_one);
  for (const unsigned level : {2U, 3U, 4U}) {
    const ScreenErrors uniform_errors = meter.of(subject.refined(level));
    const float error = error_within(subject, meter, uniform_errors.silhouette);
    const ScreenErrors errors = meter.of(subject.measured(ErrorMeter::zoom * error));
    keep(subject.measured(error));
    const auto times = interleave({subject.measured(error), subject.refined(level)}, effort);
    const auto moving = interleave({subject.moving(subject.measured(error)), subject.refined(level)}, effort);
    const auto uniform = static_cast<double>(mesh.triangles() << (2 * level));
    report.add({"screen-error/" + name + "/level" + std::to_string(level),
                "thesis 2.5x to 4.6x",
                Goal::at_least,
                2.5,
                speed_ratio(times[1], times[0]),
                "x",
                {{"coarse_triangles", static_cast<double>(mesh.triangles())},
                 {"uniform_triangles", uniform},
                 {"adaptive_triangles", triangles_of(subject.measured(error))},
                 {"screen_error_pixels", static_cast<double>(error)},
                 {"uniform_silhouette_pixels", uniform_errors.silhouette},
                 {"adaptive_silhouette_pixels", errors.silhouette},
                 {"uniform_depth_pixels", uniform_errors.depth},
                 {"adaptive_depth_pixels", errors.depth},
                 {"uniform_ms", times[1].median() * 1e3},
                 {"adaptive_ms", times[0].median() * 1e3},
                 {"moving_ms", moving[0].median() * 1e3},
                 {"moving_ratio", speed_ratio(moving[1], moving[0])}}});
  }
  glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_INPUTS_ARK);
}

void run_screen_error(Report& report, const Effort& effort) {
  for_each_figure_mesh(report, "screen-error", [&](const std::string& name, const Mesh& mesh, View view) {
    compare(report, effort, name, mesh, view);
  });
}

}  // namespace

void add_screen_error_cases(std::vector<Case>& cases) { cases.push_back({"screen-error", run_screen_error}); }

}  // namespace glark::bench
