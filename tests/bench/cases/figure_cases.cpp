// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Figures 7.13 and 7.14 of Boubekeur 2007: adaptive and uniform refinement with the same error on the screen; a million refined triangles from coarse meshes of different sizes; and the time of every depth.
#include <algorithm>
#include <array>
#include <cmath>

#include "tests/bench/cases/case.h"
#include "tests/bench/offscreen.h"
#include "tests/bench/screen_error.h"
#include "tests/bench/subject/model.h"
#include "tests/bench/subject/subject.h"

namespace glark::bench {
namespace {

constexpr unsigned deepest = 11;
constexpr float pixels_at_one = 0.5F * picture_size / 0.35F;

// Makes a torus. Its inside bends more than its outside, and its near side appears larger.
Mesh make_torus(int rings, int sides) {
  Mesh mesh;
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < sides; ++j) {
      const float u = 6.2831853F * static_cast<float>(i) / static_cast<float>(rings);
      const float v = 6.2831853F * static_cast<float>(j) / static_cast<float>(sides);
      const float tilt = 0.9F;
      const float n[3] = {std::cos(u) * std::cos(v), std::sin(v), std::sin(u) * std::cos(v)};
      const float p[3] = {0.7F * std::cos(u) + 0.25F * n[0], 0.25F * n[1], 0.7F * std::sin(u) + 0.25F * n[2]};
      const auto turned = [&](const float* a) {
        return std::array{a[0], std::cos(tilt) * a[1] - std::sin(tilt) * a[2],
                          std::sin(tilt) * a[1] + std::cos(tilt) * a[2]};
      };
      const auto position = turned(p);
      const auto normal = turned(n);
      mesh.vertices.push_back({{position[0], position[1], position[2]}, {normal[0], normal[1], normal[2]}, {0, 0}});
      const auto at = [&](int a, int b) { return static_cast<std::uint32_t>(a % rings * sides + b % sides); };
      mesh.indices.insert(mesh.indices.end(),
                          {at(i, j), at(i, j + 1), at(i + 1, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
    }
  }
  return mesh;
}

// Makes hills. View::plane sees them from above their near end.
Mesh make_landscape() {
  Mesh mesh = make_plane(30, 18);
  const auto height = [](float x, float z) {
    return 0.6F * std::sin(0.9F * x) * std::cos(0.7F * z) + 0.3F * std::sin(0.4F * x + 1.1F * z);
  };
  for (Vertex& vertex : mesh.vertices) {
    constexpr float step = 0.01F;
    const float x = vertex.position[0];
    const float z = vertex.position[2];
    const float slope_x = (height(x + step, z) - height(x - step, z)) / (2 * step);
    const float slope_z = (height(x, z + step) - height(x, z - step)) / (2 * step);
    const float size = std::hypot(slope_x, 1.0F, slope_z);
    vertex = {{x, height(x, z), z}, {-slope_x / size, 1 / size, -slope_z / size}, {vertex.uv[0], vertex.uv[1]}};
  }
  return mesh;
}

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

void compare(Report& report, const Effort& effort, const std::string& name, const Mesh& mesh,
             View view = View::sphere) {
  glARKinit(deepest);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  glARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  const Subject subject(mesh, Shading::glsl, view);
  const ErrorMeter meter(subject.refined(7), pixels_at_one);
  for (const unsigned level : {2U, 3U, 4U}) {
    const ScreenErrors uniform_errors = meter.of(subject.refined(level));
    const float error = error_within(subject, meter, uniform_errors.silhouette);
    const ScreenErrors errors = meter.of(subject.measured(ErrorMeter::zoom * error));
    const auto times = interleave({subject.measured(error), subject.refined(level)}, effort);
    const auto uniform = static_cast<double>(mesh.triangles() << (2 * level));
    report.add({"fig7.13/" + name + "/level" + std::to_string(level),
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
                 {"adaptive_ms", times[0].median() * 1e3}}});
  }
  glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_INPUTS_ARK);
}

void run_figure_7_13(Report& report, const Effort& effort) {
  compare(report, effort, "sphere", make_sphere(500));
  compare(report, effort, "landscape", make_landscape(), View::plane);
  compare(report, effort, "torus", make_torus(24, 12));
  for (const std::string& name : model_names()) compare(report, effort, name, load_model(name, 1500));
  if (model_names().empty()) report.note("fig7.13: models from files are left out; --models DIR says where they are");
}

void run_figure_7_14(Report& report, const Effort& effort) {
  constexpr int million = 1 << 20;
  glARKinit(8);
  for (unsigned depth = 0; depth <= 8; ++depth) {
    const Mesh mesh = make_sphere(std::max(million >> (2 * depth), 20));
    const Subject subject(mesh, Shading::glsl, View::sphere);
    const auto kept = interleave({subject.refined(depth), subject.touched(subject.refined(depth))}, effort);
    const auto refined = static_cast<double>(mesh.triangles() << (2 * depth));
    report.add(
        {"fig7.14/depth" + std::to_string(depth),
         "",
         Goal::none,
         0,
         refined / kept[0].median() * 1e-6,
         "M triangles/s",
         {{"depth", static_cast<double>(depth)},
          {"coarse_triangles", static_cast<double>(mesh.triangles())},
          {"refined_triangles", refined},
          {"ms", kept[0].median() * 1e3},
          {"ms_of_a_mesh_that_changes", kept[1].median() * 1e3},
          {"coarse_bytes", static_cast<double>(mesh.vertices.size() * sizeof(Vertex) + 4 * mesh.indices.size())}}});
  }
}

void run_depth_sweep(Report& report, const Effort& effort) {
  glARKinit(11);
  const Mesh mesh = first_triangles(make_sphere(20), 4);
  const Subject subject(mesh, Shading::glsl, View::sphere);
  for (unsigned depth = 1; depth <= 11; ++depth) {
    const auto times = interleave({subject.refined(depth)}, effort);
    const auto refined = static_cast<double>(mesh.triangles() << (2 * depth));
    report.add(
        {"sweep/depth" + std::to_string(depth),
         "",
         Goal::none,
         0,
         refined / times[0].median() * 1e-6,
         "M triangles/s",
         {{"depth", static_cast<double>(depth)}, {"refined_triangles", refined}, {"ms", times[0].median() * 1e3}}});
  }
}

}  // namespace

void add_figure_cases(std::vector<Case>& cases) {
  cases.push_back({"fig7.13", run_figure_7_13});
  cases.push_back({"fig7.14", run_figure_7_14});
  cases.push_back({"sweep", run_depth_sweep});
}

}  // namespace glark::bench
