// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// GL_WELD_ARK: measures the cost of finding the sides of all edges in a capture, and the cost of the longer records in
// a draw. All triangles are culled.
#include <algorithm>

#include "tests/bench/cases/case.h"
#include "tests/bench/gl.h"
#include "tests/bench/subject/subject.h"

namespace glark::bench {
namespace {

constexpr unsigned pool_level = 6;

Competitor curved(const Subject& subject, unsigned level, bool welded) {
  const Competitor refined = subject.refined(level);
  return {[refined, welded] {
            refined.prepare();
            glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
            glARKParameteriARK(GL_WELD_ARK, welded ? GL_TRUE : GL_FALSE);
            for (int i = 0; i < 3; ++i) refined.draw();  // fills the caches again
          },
          refined.draw};
}

void run(int triangles, Report& report, const Effort& effort) {
  glARKinit(pool_level);
  const Mesh mesh = first_triangles(make_sphere(std::max(20, triangles)), static_cast<std::size_t>(triangles));
  const std::string name = "weld/" + std::to_string(triangles);
  {
    const Subject subject(mesh, Shading::glsl, View::culled);
    const auto times =
        interleave({subject.touched(curved(subject, 1, false)), subject.touched(curved(subject, 1, true))}, effort);
    report.add(
        {name + "/added", "", Goal::none, 0, 1e6 / triangles * least_combination(times, {-1, 1}), "us/triangle", {}});
  }
  for (const unsigned level : {1U, 3U}) {
    const Subject subject(mesh, Shading::glsl, View::culled);
    const auto times = interleave({curved(subject, level, false), curved(subject, level, true)}, effort);
    report.add({name + "/kept/level" + std::to_string(level) + "/unwelded",
                "",
                Goal::none,
                0,
                times[0].least() / times[1].least(),
                "x",
                {}});
  }
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_INPUTS_ARK);
  glARKParameteriARK(GL_WELD_ARK, GL_FALSE);
}

}  // namespace

void add_weld_cases(std::vector<Case>& cases) {
  for (const int triangles : {100, 1000, 10000, 100000}) {
    cases.push_back({"weld/" + std::to_string(triangles),
                     [triangles](Report& report, const Effort& effort) { run(triangles, report, effort); }});
  }
}

}  // namespace glark::bench
