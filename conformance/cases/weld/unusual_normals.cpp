// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// WELD_ARK (11.R.15): normals of which one component is infinite or not a number, and places that differ in one
// component.
#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "conformance/cases/cases.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

using reference::Vector;

constexpr std::size_t roof_steps = 8;
constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float not_finite[] = {infinite, -infinite, not_a_number, -not_a_number};
constexpr char component_names[] = "xyzw";

// In bent_mesh, the edge of vertices 0 and 2 is the edge of vertices 5 and 3. Sides by triangle, then steps.
using RoofRidge = std::array<std::array<Vec4, roof_steps + 1>, 2>;

RoofRidge roof_ridge(Test& t, const Mesh& mesh, bool is_welded = true) {
  gl.UseProgram(surface_program(t));
  upload(mesh);
  refine_uniformly(3, GL_CURVED_PN_ARK);
  gl.ARKParameteriARK(GL_WELD_ARK, is_welded ? GL_TRUE : GL_FALSE);
  RoofRidge ridge{};
  for (const SurfaceVertex& vertex : capture_surface(t, mesh)) {
    if (vertex.weights[1] != 0) continue;
    const bool is_second = vertex.triangle >= 1;
    const float along = vertex.weights[is_second ? 0 : 2];
    ridge[is_second ? 1 : 0][static_cast<std::size_t>(std::lround(roof_steps * along))] = vertex.position;
  }
  return ridge;
}

Mesh roof_of_two_normals() {
  Mesh mesh = bent_mesh();
  mesh[5].normal = {-0.9F, 0.4F, 0.3F};
  mesh[3].normal = {0.2F, -0.9F, 0.7F};
  return mesh;
}

// The control point next to corner i, if `other` is the normal of the second side there.
Vector control_point(const reference::Corner& i, const reference::Corner& j, const Vec3& other) {
  const bool counts = std::isfinite(other[0]) && std::isfinite(other[1]) && std::isfinite(other[2]);
  return counts ? reference::welded_control_point(i, j, other) : reference::curved_control_point(i, j);
}

void expect_ridge_of_finite_normals(Test& t, const Mesh& mesh, const std::string& what) {
  const RoofRidge ridge = roof_ridge(t, mesh);
  const reference::Corners first = corners_of(mesh, 0);
  const Vector b02 = control_point(first[0], first[2], mesh[5].normal);
  const Vector b20 = control_point(first[2], first[0], mesh[3].normal);
  const Vector p0 = reference::vector_of(first[0].position);
  const Vector p2 = reference::vector_of(first[2].position);
  for (std::size_t i = 0; i <= roof_steps; ++i) {
    const double s = static_cast<double>(i) / roof_steps;
    const double r = 1 - s;
    const Vector expected = r * r * r * p0 + 3 * r * r * s * b02 + 3 * r * s * s * b20 + s * s * s * p2;
    for (const auto& side : ridge)
      if (!t.expect(reference::length(reference::vector_of(side[i]) - expected) < 3e-6,
                    fmt::format("{}: step {} of the ridge follows the normals that count", what, i)))
        return;
    if (!t.expect(same_position(ridge[0][i], ridge[1][i]), what + ": both sides have the same bits")) return;
  }
}

void check_component(Test& t, std::size_t component) {
  for (const float value : not_finite)
    for (const std::vector<std::size_t>& corners : {std::vector<std::size_t>{5}, {3}, {3, 5}})
      for (const bool are_others_zero : {false, true}) {
        Mesh mesh = roof_of_two_normals();
        for (const std::size_t corner : corners) {
          if (are_others_zero) mesh[corner].normal = {0, 0, 0};
          mesh[corner].normal[component] = value;
        }
        expect_ridge_of_finite_normals(
            t, mesh, fmt::format("{} {} at {} corners", component_names[component], value, corners.size()));
      }
}

// The places differ in one bit of one component, so nothing is welded.
void check_one_component(Test& t, std::size_t component) {
  for (const float towards : {-2.0F, 2.0F}) {
    Mesh mesh = roof_of_two_normals();
    for (const std::size_t corner : {3U, 5U})
      mesh[corner].position[component] = std::nextafter(mesh[corner].position[component], towards);
    const RoofRidge welded = roof_ridge(t, mesh);
    const RoofRidge plain = roof_ridge(t, mesh, false);
    t.expect(!same_position(plain[0][3], plain[1][3]), "without WELD_ARK the sides separate");
    for (std::size_t side = 0; side < 2; ++side)
      for (std::size_t i = 0; i <= roof_steps; ++i)
        for (std::size_t k = 0; k < 3; ++k)
          if (!t.expect_near(welded[side][i][k], plain[side][i][k], 2e-6,
                             fmt::format("places that differ in {} are different", component_names[component])))
            return;
  }
}

// 0 and -0 are the same in every component.
void check_zero(Test& t, std::size_t component) {
  for (const auto& [first, second] : {std::pair<std::size_t, std::size_t>{0, 5}, {2, 3}})
    for (const float sign : {1.0F, -1.0F}) {
      Mesh mesh = roof_of_two_normals();
      mesh[first].position[component] = sign * 0.0F;
      mesh[second].position[component] = -sign * 0.0F;
      const RoofRidge ridge = roof_ridge(t, mesh);
      for (std::size_t i = 0; i <= roof_steps; ++i)
        if (!t.expect(same_position(ridge[0][i], ridge[1][i]),
                      fmt::format("places with {} 0 and -0 are one", component_names[component])))
          return;
    }
}

}  // namespace

Cases unusual_normals_cases() {
  Cases cases;
  for (std::size_t component = 0; component < 3; ++component) {
    const std::string leaf(1, component_names[component]);
    cases.push_back({.name = "ark.weld.curved.not_finite." + leaf,
                     .clauses = {"11.R.15-8", "11.R.15-9"},
                     .plan = "One component of the normals of one side is infinite or not a number: these normals do "
                             "not count.",
                     .wrong = "Only the first component is looked at; the ridge vanishes.",
                     .check = [component](Test& t) { check_component(t, component); }});
    cases.push_back({.name = "ark.weld.place.zero." + leaf,
                     .clauses = {"11.R.15-4"},
                     .plan = "Places have 0 and -0 as this component of their positions.",
                     .wrong = "Bits are compared.",
                     .check = [component](Test& t) { check_zero(t, component); }});
  }
  for (std::size_t component = 0; component < 4; ++component)
    cases.push_back({.name = std::string("ark.weld.place.differs.") + component_names[component],
                     .clauses = {"11.R.15-4"},
                     .plan = "The positions of two places differ in one bit of one component.",
                     .wrong = "Some component is not compared.",
                     .check = [component](Test& t) { check_one_component(t, component); }});
  return cases;
}

}  // namespace glark::conformance
