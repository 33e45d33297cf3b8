// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Edges whose ends have different fourth components stay straight (11.R.7, 11.R.7c), with WELD_ARK and without it, whatever
// the normals of their sides are. Other edges of the same triangles are curved.
#include <fmt/core.h>
#include <cmath>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

constexpr Vec4 straight_from = {-0.4F, -0.3F, 0.1F, 1};
constexpr Vec4 straight_to = {0.5F, 0.2F, 0.3F, 2};
constexpr Vec4 straight_tips[] = {{-0.3F, 0.8F, 0, 1}, {0.7F, -0.7F, 0.2F, 1}, {0.2F, 0.5F, 0.9F, 1}};

// The normals at the common edge's ends and at the tip of a side.
using SideNormals = std::array<Vec3, 3>;
constexpr SideNormals rounded = {{{-0.5F, -0.2F, 1}, {0.6F, 0.1F, 0.9F}, {0.1F, 0.7F, 0.8F}}};
constexpr SideNormals other_side = {{{0.4F, 0.8F, 0.3F}, {-0.7F, 0.6F, 0.2F}, {0.1F, -0.3F, 0.9F}}};
constexpr SideNormals third_side = {{{0.2F, -0.6F, 0.7F}, {0.9F, 0.3F, -0.4F}, {-0.3F, 0.2F, 0.5F}}};

Mesh straight_fan(const std::vector<SideNormals>& sides, bool is_reversed) {
  Mesh mesh;
  for (std::size_t side = 0; side < sides.size(); ++side) {
    const bool is_turned = (side % 2 == 1) != is_reversed;
    const std::array<Vec4, 3> places = {is_turned ? straight_to : straight_from,
                                        is_turned ? straight_from : straight_to, straight_tips[side]};
    for (std::size_t i = 0; i < 3; ++i) {
      MeshVertex vertex;
      vertex.position = places[i];
      vertex.normal = sides[side][i == 2 ? 2 : is_turned ? 1 - i : i];
      mesh.push_back(vertex);
    }
  }
  number_triangles(mesh);
  return mesh;
}

double distance_to_line(const Vec4& place, const Vec4& from, const Vec4& to, float along) {
  double square = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double off =
        static_cast<double>(place[i]) - ((1 - static_cast<double>(along)) * static_cast<double>(from[i]) +
                                         static_cast<double>(along) * static_cast<double>(to[i]));
    square += off * off;
  }
  return std::sqrt(square);
}

void expect_straight(Test& t, const Mesh& mesh, bool is_curved_elsewhere, const std::string& what) {
  upload(mesh);
  double greatest_elsewhere = 0;
  for (const SurfaceVertex& vertex : capture_surface(t, mesh)) {
    const std::size_t first = 3 * static_cast<std::size_t>(std::lround(vertex.triangle));
    for (std::size_t edge = 0; edge < 3; ++edge) {
      if (vertex.weights[(edge + 2) % 3] != 0) continue;
      const Vec4& from = mesh[first + edge].position;
      const Vec4& to = mesh[first + (edge + 1) % 3].position;
      const double off = distance_to_line(vertex.position, from, to, vertex.weights[(edge + 1) % 3]);
      if (from[3] == to[3])
        greatest_elsewhere = std::max(greatest_elsewhere, off);
      else if (!t.expect(off < 2e-6, fmt::format("{}: edge {} is off by {}", what, edge, off)))
        return;
    }
  }
  if (is_curved_elsewhere) t.expect(greatest_elsewhere > 0.01, what + ": other edges are curved");
}

void check_straight_edges(Test& t, GLenum refinement, bool is_welded) {
  gl.UseProgram(surface_program(t));
  refine_uniformly(2, refinement);
  gl.ARKParameteriARK(GL_WELD_ARK, is_welded ? GL_TRUE : GL_FALSE);
  gl.ARKParameterfARK(GL_PHONG_SHAPE_ARK, 1);
  struct Sides {
    const char* what;
    std::vector<SideNormals> normals;
  };
  const std::vector<Sides> all = {{"one side", {rounded}},
                                  {"two smooth sides", {rounded, rounded}},
                                  {"three smooth sides", {rounded, rounded, rounded}},
                                  {"two sides of a crease", {rounded, other_side}},
                                  {"three sides of a crease", {rounded, other_side, third_side}},
                                  {"a crease beside a double side", {other_side, rounded, rounded}}};
  for (const Sides& sides : all)
    for (const bool is_reversed : {false, true})
      expect_straight(t, straight_fan(sides.normals, is_reversed), true,
                      sides.what + std::string(is_reversed ? ", reversed" : ""));
  t.expect_no_error("the draws");
}

}  // namespace

Cases straight_edges_cases() {
  Cases cases;
  for (const auto& [leaf, refinement] : {std::pair<const char*, GLenum>{"curved", GL_CURVED_PN_ARK},
                                         {"tagged", GL_SCALAR_TAGGED_PN_ARK},
                                         {"phong", GL_PHONG_ARK}})
    for (const bool is_welded : {false, true})
      cases.push_back({.name = fmt::format("ark.weld.straight.{}{}", leaf, is_welded ? "" : "_not_welded"),
                       .clauses = {"11.R.7-15", "11.R.7c-5"},
                       .plan = "Sides of an edge whose ends have the fourth components 1 and 2, with the same normals "
                               "and with different ones.",
                       .wrong = "The welded control points ignore the fourth component, or all edges are straight.",
                       .check = [mode = refinement, is_welded](Test& t) { check_straight_edges(t, mode, is_welded); }});
  return cases;
}

}  // namespace glark::conformance
