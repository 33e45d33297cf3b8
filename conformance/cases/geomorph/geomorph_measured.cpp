// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Geomorphing (11.R.14) with measured depths, and the budget of triangles.
#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/support/geomorph.h"

namespace glark::conformance {
namespace {

constexpr GLint measure = 4;  // in pixels or degrees

// Edge 0 is `size` pixels long and lies along the lower border. Its normals are `size` degrees apart.
Mesh measured_triangle(double size) {
  Mesh mesh = morph_triangle({0, 0, 0});
  const auto length = static_cast<float>(2 * size / surface_size);
  mesh[0].position = {-0.9F, -0.9F, 0, 1};
  mesh[1].position = {-0.9F + length, -0.9F, 0, 1};
  mesh[2].position = {-0.9F + length / 2, -0.6F, 0, 1};
  const double half = size * std::acos(-1.0) / 360;
  mesh[0].normal = {static_cast<float>(-std::sin(half)), 0, static_cast<float>(std::cos(half))};
  mesh[1].normal = {static_cast<float>(std::sin(half)), 0, static_cast<float>(std::cos(half))};
  mesh[2].normal = {0, 0, 1};
  return mesh;
}

// The depth of edge 0, from the number of its vertices and from how far its odd vertices have moved; 0 if there are
// none.
double found_depth(Test& t, const std::vector<MorphVertex>& vertices, const Mesh& mesh) {
  const Vec2 from = mesh[0].texture;
  const Vec2 to = mesh[1].texture;
  const auto found = found_on_edge(vertices, from, to);
  const int steps = static_cast<int>(found.size()) - 1;
  t.require(steps >= 1 && (steps & (steps - 1)) == 0, "an edge has 2^d + 1 vertices");
  if (steps == 1) return 0;
  const auto at = [&](int k) {
    return bend_of({to[0] * static_cast<float>(k) / static_cast<float>(steps),
                    to[1] * static_cast<float>(k) / static_cast<float>(steps)});
  };
  const float chord = (at(0)[0] + at(2)[0]) / 2;
  for (const PlaceAndBend& vertex : found)
    if (vertex[0] == to[0] / static_cast<float>(steps))
      return std::log2(steps) - 1 + static_cast<double>((vertex[2] - chord) / (at(1)[0] - chord));
  t.require(false, "vertices lie at equal distances");
  return 0;
}

void measure_with(GLint pixels, GLint degrees) {
  morph_by_tags(6);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, pixels);
  gl.ARKParameteriARK(GL_EDGE_DEGREES_ARK, degrees);
  gl.Viewport(0, 0, surface_size, surface_size);
}

void check_growth(Test& t, bool by_degrees) {
  gl.UseProgram(morph_program(t));
  measure_with(by_degrees ? 0 : measure, by_degrees ? measure : 0);
  double before = -1;
  double size_before = 0;
  // From less than the measure to 16 times as much, in 16 steps an octave.
  for (int step = -8; step <= 64; ++step) {
    const double size = measure * std::exp2((step + 0.25) / 16.0);
    const Mesh mesh = measured_triangle(size);
    upload(mesh);
    const double depth = found_depth(t, capture_morph(t, mesh), mesh);
    const double whole = std::max(0.0, std::ceil(std::log2(size / measure)));
    const std::string what = as_text(size) + (by_degrees ? " degrees" : " pixels");
    t.expect(depth <= whole && depth > whole - 1,
             what + ": a depth of " + as_text(depth) + ", which 11.R.4 says is " + as_text(whole));
    t.expect_near(64 * depth, std::round(64 * depth), 1e-3, what + ": 64 times the depth is whole");
    if (before >= 0) {
      t.expect(depth >= before, what + ": the depth grows with what is measured");
      // A depth that grows linearly from level to level would differ by 4/64, one that grows with the size itself by
      // 6/64.
      t.expect(depth - before <= 8.0 / 64,
               as_text(size_before) + " to " + what + ": the depth grows by " + as_text(depth - before));
    }
    before = depth;
    size_before = size;
  }
}

constexpr int ladder = 64;  // triangles
constexpr int octave = 32;  // steps of the ladder for a factor of 2

// Triangles of growing size: edge 0 is 8 to 32 times as long as the measure, which is 2 pixels. The budget multiplies
// the measure by a factor c. The first edge of depth 4 tells c.
Mesh ladder_mesh() {
  Mesh mesh;
  for (int i = 0; i < ladder; ++i) {
    const Mesh one = measured_triangle(16 * std::exp2((i + 0.5) / octave));
    mesh.insert(mesh.end(), one.begin(), one.end());
  }
  number_triangles(mesh);
  return mesh;
}

struct Frame {
  std::size_t triangles;
  int first;  // the first of the ladder whose edge 0 has more than 8 segments, or `ladder`
};

Frame draw_frame(Test& t) {
  const auto vertices = capture(
      t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3 * ladder); }, 60000);
  std::vector<std::set<float>> edges(ladder);
  for (const CapturedVertex& vertex : vertices)
    if (vertex.weights[2] == 0) edges[static_cast<std::size_t>(std::lround(vertex.triangle))].insert(vertex.weights[0]);
  Frame frame{vertices.size() / 3, 0};
  while (frame.first < ladder && edges[static_cast<std::size_t>(frame.first)].size() <= 9) ++frame.first;
  t.context().end_frame();
  return frame;
}

// The ladder gives log2 c to within 1/32.
void check_budget(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(ladder_mesh());
  measure_with(2, 0);
  const Frame free = draw_frame(t);
  t.expect_equal(free.first, 0, "the first of the ladder with depth 4, without a budget");
  const auto budget = static_cast<GLint>(free.triangles / 3);
  gl.ARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, budget);
  Frame before = draw_frame(t);
  t.expect_equal(before.first, 0, "the first of the ladder with depth 4, in the frame after the budget is set");
  for (int i = 0; i < 32; ++i) {
    const Frame frame = draw_frame(t);
    t.expect(
        std::abs(frame.first - before.first) <= octave / 16 + 1,
        fmt::format("frame {}: the logarithm of c changes by {}/32", i, as_text(std::abs(frame.first - before.first))));
    before = frame;
  }
  t.expect(before.first > octave / 2, "c has become greater");
  t.expect(before.triangles <= static_cast<std::size_t>(budget),
           fmt::format("{} triangles with a budget of {}", before.triangles, budget));
}

}  // namespace

Cases geomorph_measured_cases() {
  Cases cases;
  for (const bool by_degrees : {false, true})
    cases.push_back({.name = std::string("ark.geomorph.measured.") + (by_degrees ? "degrees" : "pixels"),
                     .clauses = {"11.R.14-4"},
                     .plan = "An edge grows from a size without refinement to 16 times the measure, in 72 steps.",
                     .wrong = "Whole depths; a depth above that of 11.R.4; a jump from one level to the next.",
                     .check = [by_degrees](Test& t) { check_growth(t, by_degrees); }});
  cases.push_back({.name = "ark.geomorph.budget",
                   .clauses = {"11.R.14-20"},
                   .plan = "The edges of 64 triangles show c, with a budget of a third of their triangles.",
                   .wrong = "c jumps to its value in one frame, or never settles.",
                   .check = check_budget});
  return cases;
}

}  // namespace glark::conformance
