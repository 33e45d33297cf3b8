// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Compares a refined draw with the same triangles refined beforehand, and with tessellation shaders.
#include <memory>

#include "tests/bench/cases/case.h"
#include "tests/bench/offscreen.h"
#include "tests/bench/same_picture.h"
#include "tests/bench/subject/subject.h"

namespace glark::bench {
namespace {

constexpr unsigned deepest_tessellation = 6;  // 64 segments
constexpr unsigned pool_level = 11;

struct DrawCase {
  Shading shading;
  int coarse;  // drawn triangles
  unsigned level;
  View view = View::sphere;  // with culled, only the vertex stage runs
};

// A prototype without a library, whose vertex stage was written by hand, against a static mesh without shared vertices.
std::string known_speed(unsigned level) {
  constexpr const char* prototype[] = {"", "1.1x", "1.7x", "1.75x", "1.7x", "", "1.6x", "", "1.0x"};
  return level < std::size(prototype) && prototype[level][0] != 0 ? std::string("prototype ") + prototype[level] : "";
}

Mesh coarse_mesh(int triangles) {
  constexpr int smallest_sphere = 20;
  return triangles >= smallest_sphere
             ? make_sphere(triangles)
             : first_triangles(make_sphere(smallest_sphere), static_cast<std::size_t>(triangles));
}

void add_ratio(Report& report, Row row, const std::vector<Times>& times) {
  row.measured = speed_ratio(times[1], times[0]);
  row.unit = "x";
  row.detail = {{"refined_ms", times[0].median() * 1e3},
                {"other_ms", times[1].median() * 1e3},
                {"ratio_of_least", times[1].least() / times[0].least()},
                {"rounds", static_cast<double>(times[0].seconds.size())}};
  report.add(std::move(row));
}

void run_static(const std::string& name, const DrawCase& which, const Mesh& mesh, Report& report,
                const Effort& effort) {
  const Subject coarse(mesh, which.shading, which.view);
  const Subject fine(refine(mesh, which.level), which.shading, which.view);
  if (which.view == View::culled) {
    const auto times = interleave({coarse.refined(which.level), fine.as_is()}, effort);
    add_ratio(report, {name + "/static", "", Goal::none, 0, 0, "", {}}, times);
    return;
  }
  expect_same(name, coarse.refined(which.level), fine.as_is());
  const auto times = interleave({coarse.refined(which.level), fine.as_is()}, effort);
  add_ratio(report, {name + "/static", "", Goal::at_least, like_static, 0, "", {}}, times);
}

// For comparison with published figures. Most of them use a mesh without shared vertices.
void run_separate(const std::string& name, const DrawCase& which, const Mesh& mesh, Report& report,
                  const Effort& effort) {
  const Subject coarse(mesh, which.shading, which.view);
  const Subject fine(separate(refine(mesh, which.level)), which.shading, which.view);
  expect_same(name, coarse.refined(which.level), fine.as_is());
  const auto times = interleave({coarse.refined(which.level), fine.as_is()}, effort);
  add_ratio(report, {name + "/static-not-indexed", known_speed(which.level), Goal::none, 0, 0, "", {}}, times);
}

void run_tessellation(const std::string& name, const DrawCase& which, const Mesh& mesh, Report& report,
                      const Effort& effort) {
  const Subject coarse(mesh, which.shading, View::sphere);
  expect_same(name, coarse.refined(which.level), coarse.tessellated(which.level));
  const auto times = interleave({coarse.refined(which.level), coarse.tessellated(which.level)}, effort);
  add_ratio(report, {name + "/tessellation", "", Goal::at_least, 2, 0, "", {}}, times);
}

std::string name_of(const DrawCase& which) {
  return std::string(which.view == View::culled ? "vertices/" : "draw/") +
         (which.shading == Shading::glsl ? "glsl" : "fixed") + "/" + std::to_string(which.coarse) + "/level" +
         std::to_string(which.level);
}

using Run = void (*)(const std::string&, const DrawCase&, const Mesh&, Report&, const Effort&);

void add_case(std::vector<Case>& cases, const DrawCase& which, const char* against, Run run) {
  cases.push_back({name_of(which) + "/" + against, [which, run](Report& report, const Effort& effort) {
                     glARKinit(pool_level);
                     run(name_of(which), which, coarse_mesh(which.coarse), report, effort);
                   }});
}

}  // namespace

void add_draw_cases(std::vector<Case>& cases) {
  constexpr DrawCase deep[] = {{Shading::glsl, 200, 7},
                               {Shading::glsl, 20, 8},
                               {Shading::glsl, 4, 9},
                               {Shading::glsl, 4, 10},
                               {Shading::glsl, 4, 11}};
  for (const Shading shading : {Shading::glsl, Shading::fixed_function}) {
    for (const int coarse : {200, 1246}) {
      for (unsigned level = 0; level <= 6; ++level) add_case(cases, {shading, coarse, level}, "static", run_static);
    }
    for (DrawCase which : deep) {
      which.shading = shading;
      add_case(cases, which, "static", run_static);
    }
  }
  for (unsigned level = 1; level <= 6; ++level)
    add_case(cases, {Shading::glsl, 1246, level, View::culled}, "static", run_static);
  for (unsigned level = 1; level <= 5; ++level) {
    add_case(cases, {Shading::glsl, 1246, level}, "static-not-indexed", run_separate);
  }
  for (unsigned level = 1; level <= deepest_tessellation; ++level)
    add_case(cases, {Shading::glsl, 200, level}, "tessellation", run_tessellation);
  for (unsigned level = 1; level <= deepest_tessellation; ++level)
    add_case(cases, {Shading::glsl, 1246, level}, "tessellation", run_tessellation);
}

}  // namespace glark::bench
