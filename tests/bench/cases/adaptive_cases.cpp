// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Compares depth tags by distance with the uniform level that gives the nearest triangles edges of the same length on
// the screen.
#include <algorithm>
#include <cmath>

#include "glark/core/pattern/expand.h"
#include "glark/core/pattern/pool.h"
#include "tests/bench/cases/case.h"
#include "tests/bench/offscreen.h"
#include "tests/bench/subject/subject.h"

namespace glark::bench {
namespace {

constexpr int cells = 30;
constexpr float half_side = 18;
constexpr float eye_distance = 20;  // along z, as in View::plane
constexpr unsigned deepest = 5;

std::vector<std::uint8_t> tags_by_distance(const Mesh& mesh) {
  std::vector<std::uint8_t> tags;
  for (const Vertex& vertex : mesh.vertices) {
    const float distance = std::max(eye_distance - vertex.position[2], 1.0F);
    const float nearest = eye_distance - half_side;
    const float depth = static_cast<float>(deepest) - std::log2(distance / nearest);
    tags.push_back(static_cast<std::uint8_t>(std::clamp(depth + 0.5F, 0.0F, static_cast<float>(deepest))));
  }
  return tags;
}

std::size_t refined_triangles(const Mesh& mesh, const std::vector<std::uint8_t>& tags, const pattern::Pool& pool) {
  std::size_t total = 0;
  for (std::size_t t = 0; t < mesh.triangles(); ++t) {
    const int a = tags[mesh.indices[3 * t]];
    const int b = tags[mesh.indices[3 * t + 1]];
    const int c = tags[mesh.indices[3 * t + 2]];
    for (const pattern::Instance& instance :
         pattern::expand((a + b) >> 1, (b + c) >> 1, (c + a) >> 1, pattern::Interior::minimum)) {
      total += pool.pieces[static_cast<std::size_t>(instance.piece)].index_count / 3;
    }
  }
  return total;
}

void run(Report& report, const Effort& effort) {
  glARKinit(deepest);
  const Mesh mesh = make_plane(cells, half_side);
  const std::vector<std::uint8_t> tags = tags_by_distance(mesh);
  const Subject plane(mesh, Shading::glsl, View::plane, tags);
  const auto times = interleave({plane.tagged(), plane.refined(deepest)}, effort);
  const double uniform = static_cast<double>(mesh.triangles() << (2 * deepest));
  const double adaptive = static_cast<double>(refined_triangles(mesh, tags, pattern::build_pool(deepest)));
  report.add({"adaptive/plane/fewer-triangles",
              "",
              Goal::none,
              0,
              uniform / adaptive,
              "x",
              {{"adaptive", adaptive}, {"uniform", uniform}}});
  report.add({"adaptive/plane/faster",
              "thesis 2.5x to 4.6x",
              Goal::at_least,
              4.6,
              speed_ratio(times[1], times[0]),
              "x",
              {{"adaptive_ms", times[0].median() * 1e3}, {"uniform_ms", times[1].median() * 1e3}}});
}

}  // namespace

void add_adaptive_cases(std::vector<Case>& cases) { cases.push_back({"adaptive/plane", run}); }

}  // namespace glark::bench
