// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// WELD_ARK (11.R.15): a normal and its opposite count as the same, whichever of their components are zero, in every
// order of the sides.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "conformance/cases/cases.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

using reference::Vector;

constexpr std::size_t edge_steps = 4;  // of an edge at depth 2
constexpr Vec3 edge_from = {-0.3F, -0.2F, 0.1F};
constexpr Vec3 edge_to = {0.5F, 0.25F, 0.4F};
constexpr Vec3 side_tips[] = {{-0.4F, 0.7F, 0}, {0.6F, -0.6F, 0.2F}, {0.1F, 0.4F, 0.9F}, {-0.2F, -0.7F, -0.6F}};

// The sides of one edge. Each has its normal at all corners; every other triangle has the edge in the other direction.
Mesh fan_of(const std::vector<Vec3>& normals) {
  Mesh mesh;
  for (std::size_t side = 0; side < normals.size(); ++side) {
    const bool is_turned = side % 2 == 1;
    const Vec3 places[] = {is_turned ? edge_to : edge_from, is_turned ? edge_from : edge_to, side_tips[side]};
    for (const Vec3& place : places) {
      MeshVertex vertex;
      vertex.position = {place[0], place[1], place[2], 1};
      vertex.normal = normals[side];
      mesh.push_back(vertex);
    }
  }
  number_triangles(mesh);
  return mesh;
}

// The positions of each side along the edge.
std::vector<std::array<Vec4, edge_steps + 1>> welded_edge_of(Test& t, const Mesh& mesh) {
  std::vector<std::array<Vec4, edge_steps + 1>> sides(mesh.size() / 3);
  for (const SurfaceVertex& vertex : capture_surface(t, mesh)) {
    if (vertex.weights[2] != 0) continue;
    const auto side = static_cast<std::size_t>(std::lround(vertex.triangle));
    t.require(side < sides.size(), "every refined vertex belongs to a coarse triangle");
    const float along = vertex.weights[side % 2 == 1 ? 0 : 1];
    sides[side][static_cast<std::size_t>(std::lround(edge_steps * along))] = vertex.position;
  }
  return sides;
}

reference::Corner corner_at(const Vec3& place, const Vec3& normal) {
  return {.position = {place[0], place[1], place[2], 1}, .normal = normal};
}

// Two classes of normals: those of `n` and those of `m`.
std::array<Vector, edge_steps + 1> expected_edge(const Vec3& n, const Vec3& m) {
  const Vector b01 = reference::welded_control_point(corner_at(edge_from, n), corner_at(edge_to, n), m);
  const Vector b10 = reference::welded_control_point(corner_at(edge_to, n), corner_at(edge_from, n), m);
  std::array<Vector, edge_steps + 1> expected;
  for (std::size_t i = 0; i <= edge_steps; ++i) {
    const double s = static_cast<double>(i) / edge_steps;
    const double r = 1 - s;
    expected[i] = r * r * r * reference::vector_of(edge_from) + 3 * r * r * s * b01 + 3 * r * s * s * b10 +
                  s * s * s * reference::vector_of(edge_to);
  }
  return expected;
}

std::array<Vector, edge_steps + 1> smooth_edge(const Vec3& n) {
  const Vector b01 = reference::curved_control_point(corner_at(edge_from, n), corner_at(edge_to, n));
  const Vector b10 = reference::curved_control_point(corner_at(edge_to, n), corner_at(edge_from, n));
  std::array<Vector, edge_steps + 1> expected;
  for (std::size_t i = 0; i <= edge_steps; ++i) {
    const double s = static_cast<double>(i) / edge_steps;
    const double r = 1 - s;
    expected[i] = r * r * r * reference::vector_of(edge_from) + 3 * r * r * s * b01 + 3 * r * s * s * b10 +
                  s * s * s * reference::vector_of(edge_to);
  }
  return expected;
}

void expect_welded_edge(Test& t, const std::vector<Vec3>& normals, const std::array<Vector, edge_steps + 1>& expected,
                        const std::string& what) {
  const Mesh mesh = fan_of(normals);
  upload(mesh);
  const auto sides = welded_edge_of(t, mesh);
  for (std::size_t side = 0; side < sides.size(); ++side)
    for (std::size_t i = 0; i <= edge_steps; ++i) {
      t.expect(same_position(sides[side][i], sides[0][i]), fmt::format("{}: step {} of all sides", what, i));
      const double off = reference::length(reference::vector_of(sides[side][i]) - expected[i]);
      if (!t.expect(off < 4e-6, fmt::format("{}: step {} of side {} is off by {}", what, i, side, off))) return;
    }
}

Vec3 scaled(float factor, const Vec3& n) { return {factor * n[0], factor * n[1], factor * n[2]}; }

// All 26 directions of components below, at and above zero. The magnitudes differ.
std::vector<Vec3> directions() {
  std::vector<Vec3> all;
  for (int code = 0; code < 27; ++code) {
    const std::array<int, 3> signs = {code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1};
    const Vec3 n = {0.4F * static_cast<float>(signs[0]), 0.8F * static_cast<float>(signs[1]),
                    0.6F * static_cast<float>(signs[2])};
    if (code != 13) all.push_back(n);
  }
  return all;
}

// By their bits, they lie before, between and behind a normal and its opposite.
constexpr Vec3 other_normals[] = {{0.7F, -0.2F, 0.5F}, {0, 1, 0},        {0, 0, 1},     {1, 0, 0},
                                  {0, -1, 0.2F},       {-0.6F, 0, 0.5F}, {0.3F, 1, 0},  {0, 0.3F, -1},
                                  {0.5F, 0, 0},        {-0.2F, -1, -1},  {0.1F, -1, 1}, {-1, 0.1F, 0}};

bool is_parallel(const Vec3& n, const Vec3& m) {
  return reference::length(reference::cross(reference::vector_of(n), reference::vector_of(m))) < 1e-3;
}

// `n`, its opposite and another normal, in this order and turned; then with the opposite of the other one.
void expect_two_planes(Test& t, const Vec3& n, const Vec3& other, const std::string& what) {
  const Vec3 opposite = scaled(-1, n);
  const auto expected = expected_edge(n, other);
  std::vector<Vec3> three = {n, opposite, other};
  for (int order = 0; order < 3; ++order) {
    expect_welded_edge(t, three, expected, fmt::format("{}, its opposite and another, turned by {}", what, order));
    std::rotate(three.begin(), three.begin() + 1, three.end());
  }
  expect_welded_edge(t, {n, other, opposite, scaled(-1, other)}, expected, what + ", another, both opposites");
  expect_welded_edge(t, {scaled(-1, other), n, opposite, other}, expected, what + " between two opposites");
}

void check_opposites(Test& t, GLenum refinement) {
  gl.UseProgram(surface_program(t));
  refine_uniformly(2, refinement);
  gl.ARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  std::size_t turn = 0;
  for (const Vec3& n : directions()) {
    const std::string what = fmt::format("the normal {} {} {}", n[0], n[1], n[2]);
    const Vec3 opposite = scaled(-1, n);
    expect_welded_edge(t, {n, opposite}, smooth_edge(n), what + " and its opposite");
    expect_welded_edge(t, {n, opposite, scaled(2, n)}, smooth_edge(n), what + ", its opposite and its double");
    for (std::size_t i = turn++ % 3; i < std::size(other_normals); i += 3)
      if (const Vec3& other = other_normals[i]; !is_parallel(n, other))
        expect_two_planes(t, n, other, what + fmt::format(" with {} {} {}", other[0], other[1], other[2]));
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases opposite_normals_cases() {
  Cases cases;
  for (const auto& [leaf, refinement] :
       {std::pair<const char*, GLenum>{"curved", GL_CURVED_PN_ARK}, {"tagged", GL_SCALAR_TAGGED_PN_ARK}})
    cases.push_back({.name = std::string("ark.weld.opposites.") + leaf,
                     .clauses = {"11.R.15-8", "11.R.15-9", "11.R.15-10", "11.R.15-12"},
                     .plan = "Two to four sides of an edge, with a normal, its opposite and another one. The normals "
                             "have zero components in all ways.",
                     .wrong = "Two normals of one plane count as two planes if a component is zero, and a third side "
                              "does not count.",
                     .check = [mode = refinement](Test& t) { check_opposites(t, mode); }});
  return cases;
}

}  // namespace glark::conformance
