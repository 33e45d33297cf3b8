// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Welded positions (11.R.15): a roof of two triangles over one ridge. Each side has its own normal.
#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

constexpr std::size_t shared_steps = 16;

// In bent_mesh, the edge of vertices 0 and 2 is the edge of vertices 5 and 3.
Mesh roof(const Vec3& normal_5, const Vec3& normal_3) {
  Mesh mesh = bent_mesh();
  mesh[5].normal = normal_5;
  mesh[3].normal = normal_3;
  return mesh;
}

Mesh hard_roof() { return roof({-0.9F, 0.4F, 0.3F}, {0.2F, -0.9F, 0.7F}); }

using Edge = std::array<std::vector<SurfaceVertex>, 2>;

// The positions of each triangle along the ridge, from vertex 0 to vertex 2.
Edge ridge_of(const std::vector<SurfaceVertex>& vertices) {
  Edge edge;
  for (auto& side : edge) side.resize(shared_steps + 1);
  for (const SurfaceVertex& vertex : vertices) {
    const bool is_second = vertex.triangle >= 1;
    if (vertex.weights[1] != 0) continue;
    const float along = vertex.weights[is_second ? 0 : 2];
    edge[is_second ? 1 : 0][static_cast<std::size_t>(std::lround(shared_steps * along))] = vertex;
  }
  return edge;
}

std::vector<SurfaceVertex> welded(Test& t, const Mesh& mesh, GLenum refinement, bool is_welded = true) {
  gl.UseProgram(surface_program(t));
  upload(mesh);
  refine_uniformly(4, refinement);
  gl.ARKParameteriARK(GL_WELD_ARK, is_welded ? GL_TRUE : GL_FALSE);
  return capture_surface(t, mesh);
}

// Vertex 0 of the first triangle is corner 2 of the second, whose corner 0 is vertex 2.
void expect_same_ridge(Test& t, const Edge& edge) {
  for (std::size_t i = 0; i <= shared_steps; ++i) {
    // weights[0] of the second triangle belongs to vertex 2: the same step.
    if (!t.expect(same_position(edge[0][i].position, edge[1][i].position),
                  fmt::format("step {} of the ridge has the same position on both sides, by bits", i)))
      return;
  }
}

reference::Vector cubic(const reference::Vector& p0, const reference::Vector& b0, const reference::Vector& b1,
                        const reference::Vector& p1, double s) {
  const double r = 1 - s;
  return r * r * r * p0 + 3 * r * r * s * b0 + 3 * r * s * s * b1 + s * s * s * p1;
}

void expect_ridge(Test& t, const Mesh& mesh, const Edge& edge) {
  const reference::Corners first = corners_of(mesh, 0);
  const reference::Vector b02 = reference::welded_control_point(first[0], first[2], mesh[5].normal);
  const reference::Vector b20 = reference::welded_control_point(first[2], first[0], mesh[3].normal);
  for (std::size_t i = 0; i <= shared_steps; ++i) {
    const reference::Vector expected =
        cubic(reference::vector_of(first[0].position), b02, b20, reference::vector_of(first[2].position),
              static_cast<double>(i) / shared_steps);
    for (const auto& side : edge)
      if (!t.expect(reference::length(reference::vector_of(side[i].position) - expected) < 3e-6,
                    fmt::format("step {} of the ridge is that of (11.R.9)", i)))
        return;
  }
}

void check_formula(Test& t) {
  const Mesh mesh = hard_roof();
  const Edge edge = ridge_of(welded(t, mesh, GL_CURVED_PN_ARK));
  expect_same_ridge(t, edge);
  expect_ridge(t, mesh, edge);
}

// With and without welding, the refined vertices are the same up to rounding.
void expect_not_welded(Test& t, const Mesh& mesh, const char* what) {
  const Edge with = ridge_of(welded(t, mesh, GL_CURVED_PN_ARK));
  const Edge without = ridge_of(welded(t, mesh, GL_CURVED_PN_ARK, false));
  for (std::size_t side = 0; side < 2; ++side)
    for (std::size_t i = 0; i <= shared_steps; ++i)
      if (!t.expect(reference::length(reference::vector_of(with[side][i].position) -
                                      reference::vector_of(without[side][i].position)) < 3e-6,
                    fmt::format("{}: step {} of the ridge", what, i)))
        return;
}

void check_fourth_component(Test& t) {
  Mesh mesh = hard_roof();
  for (const std::size_t i : {3U, 5U}) mesh[i].position[3] = 1.25F;
  expect_not_welded(t, mesh, "positions with another fourth component");
}

void check_faint(Test& t) {
  // S . S is large, R . R is below c: the planes are nearly the same.
  Mesh mesh = bent_mesh();
  for (const auto& [from, to] : {std::pair<std::size_t, std::size_t>{0, 5}, {2, 3}}) {
    mesh[to].normal = mesh[from].normal;
    mesh[to].normal[0] += 0.12F;
  }
  const Edge edge = ridge_of(welded(t, mesh, GL_CURVED_PN_ARK));
  expect_same_ridge(t, edge);
  expect_ridge(t, mesh, edge);
}

void check_without(Test& t) {
  const Edge edge = ridge_of(welded(t, hard_roof(), GL_CURVED_PN_ARK, false));
  int apart = 0;
  for (std::size_t i = 1; i < shared_steps; ++i)
    apart += same_position(edge[0][i].position, edge[1][i].position) ? 0 : 1;
  t.expect(apart > 0, "without WELD_ARK two normals bend the ridge apart");
}

void expect_as_unwelded(Test& t, const Mesh& mesh, const char* what, GLenum refinement = GL_CURVED_PN_ARK) {
  const auto plain = welded(t, mesh, refinement, false);
  const auto with = welded(t, mesh, refinement, true);
  t.require(plain.size() == with.size() && plain.size() > mesh.size(), "both are refined");
  for (std::size_t i = 0; i < plain.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (!t.expect_near(with[i].position[k], plain[i].position[k], 2e-6, what)) return;
}

void check_same_normals(Test& t) { expect_as_unwelded(t, bent_mesh(), "with the same normals (11.R.2) holds"); }

// Places 0/5 and 2/3 are the ends of the ridge. The control points stay those of (11.R.2) if w differs along it.
void check_same_normals_at_other_w(Test& t) {
  for (const GLenum refinement : {GL_CURVED_PN_ARK, GL_SCALAR_TAGGED_PN_ARK, GL_PHONG_ARK})
    for (const auto& [first, second] : {std::pair<std::size_t, std::size_t>{0, 5}, {2, 3}}) {
      Mesh mesh = bent_mesh();
      mesh[first].position[3] = mesh[second].position[3] = 1.5F;
      expect_as_unwelded(t, mesh, "with the same normals (11.R.2) holds", refinement);
    }
}

void check_opposite(Test& t) {
  Mesh mesh = bent_mesh();
  for (const std::size_t i : {3U, 5U})
    for (float& component : mesh[i].normal) component = -component;
  expect_as_unwelded(t, mesh, "a normal and its opposite count as the same");
}

void check_zero_normal(Test& t) {
  // A side without a normal does not count: the ridge follows the other side.
  Mesh mesh = bent_mesh();
  mesh[3].normal = mesh[5].normal = {0, 0, 0};
  const Edge edge = ridge_of(welded(t, mesh, GL_CURVED_PN_ARK));
  expect_same_ridge(t, edge);
  const reference::Corners first = corners_of(mesh, 0);
  for (std::size_t i = 0; i <= shared_steps; ++i) {
    const float s = static_cast<float>(i) / shared_steps;
    const reference::Vector expected = reference::curved_pn(first, {1 - s, 0, s}).position;
    if (!t.expect(reference::length(reference::vector_of(edge[1][i].position) - expected) < 3e-6,
                  "a zero normal does not count"))
      return;
  }
}

void check_normals_kept(Test& t) {
  const Mesh mesh = hard_roof();
  const auto plain = welded(t, mesh, GL_CURVED_PN_ARK, false);
  const auto with = welded(t, mesh, GL_CURVED_PN_ARK, true);
  t.require(plain.size() == with.size() && plain.size() > mesh.size(), "both are refined");
  for (std::size_t i = 0; i < plain.size(); ++i)
    if (!t.expect(plain[i].normal == with[i].normal && plain[i].texture == with[i].texture,
                  "normals and texture coordinates have the same bits with and without WELD_ARK"))
      return;
}

void check_sign_of_zero(Test& t) {
  Mesh mesh = hard_roof();
  mesh[0].position[2] = 0.0F;
  mesh[5].position[2] = -0.0F;
  expect_same_ridge(t, ridge_of(welded(t, mesh, GL_CURVED_PN_ARK)));
}

void check_other_places(Test& t) {
  Mesh mesh = hard_roof();
  // The places differ in one bit, so nothing is welded.
  mesh[5].position[0] = std::nextafter(mesh[5].position[0], 1.0F);
  mesh[3].position[0] = std::nextafter(mesh[3].position[0], 1.0F);
  expect_as_unwelded(t, mesh, "places that differ by a bit are different");
}

void check_tags(Test& t) {
  gl.UseProgram(surface_program(t));
  Mesh mesh = hard_roof();
  const float tags[] = {1, 2, 4, 3, 0, 5};
  for (std::size_t i = 0; i < mesh.size(); ++i) mesh[i].tag = tags[i];
  upload(mesh);
  refine_by_tags(6);
  gl.ARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  // Places 0/5 have tag 5, places 2/3 have tag 4. The ridge has depth 4, the other edges floor((5 + 2) / 2) = 3, 3, 2,
  // 2.
  std::array<std::map<float, int>, 6> edges;
  for (const SurfaceVertex& vertex : capture_surface(t, mesh)) {
    const std::size_t first = vertex.triangle >= 1 ? 3 : 0;
    for (std::size_t k = 0; k < 3; ++k)
      if (vertex.weights[(k + 2) % 3] == 0) ++edges[first + k][vertex.weights[k]];
  }
  const std::size_t expected[6] = {9, 9, 17, 5, 5, 17};
  for (std::size_t i = 0; i < 6; ++i)
    t.expect_equal(edges[i].size(), expected[i],
                   fmt::format("vertices on edge {}, with the greatest tags of each place", i));
}

// With the normals of the faces, all edges stay straight.
Mesh cube() {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-0.5F, 0.5F}) {
      const float corners[4][2] = {{-0.5F, -0.5F}, {0.5F, -0.5F}, {0.5F, 0.5F}, {-0.5F, 0.5F}};
      for (const int i : {0, 1, 2, 2, 3, 0}) {
        MeshVertex vertex;
        const auto a = static_cast<std::size_t>(axis);
        vertex.position[a] = side;
        vertex.position[(a + 1) % 3] = corners[i][0];
        vertex.position[(a + 2) % 3] = corners[i][1];
        vertex.normal = {0, 0, 0};
        vertex.normal[a] = side > 0 ? 1.0F : -1.0F;
        mesh.push_back(vertex);
      }
    }
  number_triangles(mesh);
  return mesh;
}

void check_cube(Test& t) {
  for (const SurfaceVertex& vertex : welded(t, cube(), GL_CURVED_PN_ARK)) {
    float largest = 0;
    for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, std::abs(vertex.position[i]));
    if (!t.expect_near(largest, 0.5, 1e-6, "a cube stays a cube")) return;
  }
}

// (1 - t) b + t P, where t is the tension as section 11.R.7a clamps it.
reference::Vector tightened(const reference::Corner& corner, const reference::Vector& control_point) {
  const float given = corner.tags[1];
  const double tension = std::isnan(given) ? 0 : std::clamp(static_cast<double>(given), -1.0, 1.0);
  return (1 - tension) * control_point + tension * reference::vector_of(corner.position);
}

// The ridge of a mesh that has these tensions at its ends. If `is_tagged`, its beginning is tagged.
void expect_tense_ridge(Test& t, const Vec2& tensions, bool is_tagged) {
  Mesh mesh = hard_roof();
  ShapeTags tags;
  tags.discontinuities.assign(6, Vec4{0, 0, 0, 1});
  tags.scalars.assign(6, Vec3{0, 0.25F, 0});
  for (const std::size_t i : {0U, 5U}) tags.scalars[i] = {0.5F, tensions[0], 0.5F};
  for (const std::size_t i : {2U, 3U}) tags.scalars[i][1] = tensions[1];
  if (is_tagged) {
    tags.discontinuities[0] = tags.discontinuities[5] = {0.25F, -0.5F, 0.125F, 3};
    mesh[5].normal = mesh[0].normal;
  }
  upload(mesh);
  upload_shape_tags(tags);
  const Edge edge = ridge_of(capture_surface(t, mesh));
  if (!is_tagged) expect_same_ridge(t, edge);
  const reference::Corners first = corners_of(mesh, 0, tags);
  const reference::Corners second = corners_of(mesh, 1, tags);
  const reference::Vector b20 =
      tightened(first[2], reference::welded_control_point(first[2], first[0], mesh[3].normal));
  for (std::size_t side = 0; side < 2; ++side) {
    const reference::Vector b02 =
        is_tagged ? (side == 0 ? reference::tagged_control_point(first[0], first[2])
                               : reference::tagged_control_point(second[2], second[0]))
                  : tightened(first[0], reference::welded_control_point(first[0], first[2], mesh[5].normal));
    for (std::size_t i = 0; i <= shared_steps; ++i) {
      const reference::Vector expected =
          cubic(reference::vector_of(first[0].position), b02, b20, reference::vector_of(first[2].position),
                static_cast<double>(i) / shared_steps);
      if (!t.expect(reference::length(reference::vector_of(edge[side][i].position) - expected) < 4e-6,
                    fmt::format("tensions {} and {}: step {} of the ridge has the control points (1 - t) b + t P",
                                tensions[0], tensions[1], i)))
        return;
    }
  }
}

void check_tagged_tension(Test& t, bool is_tagged) {
  gl.UseProgram(surface_program(t));
  refine_uniformly(4, GL_SCALAR_TAGGED_PN_ARK);
  gl.ARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();
  for (const Vec2& tensions : {Vec2{0.5F, 0.5F},
                               {-0.5F, 0.25F},
                               {0, -0.75F},
                               {-1, 0},
                               {1, -0.25F},
                               {7, -7},
                               {nan_value, 0.75F},
                               {-0.25F, nan_value}})
    expect_tense_ridge(t, tensions, is_tagged);
}

void check_tagged_bits(Test& t) {
  const auto curved = welded(t, hard_roof(), GL_CURVED_PN_ARK);
  const auto tagged = welded(t, hard_roof(), GL_SCALAR_TAGGED_PN_ARK);
  t.require(curved.size() == tagged.size() && curved.size() > 6, "both are refined");
  for (std::size_t i = 0; i < curved.size(); ++i)
    if (!t.expect(curved[i].position == tagged[i].position, "the bits of CURVED_PN_ARK")) return;
}

// Three triangles with three normals share one edge.
void check_three_sides(Test& t) {
  Mesh mesh = hard_roof();
  MeshVertex third[3] = {mesh[0], mesh[2], mesh[1]};
  third[0].normal = {0.2F, 0.1F, -1};
  third[1].normal = {0.9F, 0.3F, -0.1F};
  third[2].position = {0.2F, -0.1F, 0.9F, 1};
  mesh.insert(mesh.end(), third, third + 3);
  number_triangles(mesh);
  const auto vertices = welded(t, mesh, GL_CURVED_PN_ARK);
  Mesh turned(mesh.begin() + 3, mesh.end());
  turned.insert(turned.end(), mesh.begin(), mesh.begin() + 3);
  number_triangles(turned);
  const auto again = welded(t, turned, GL_CURVED_PN_ARK);
  std::map<int, Vec4> steps;
  const auto collect = [&](const std::vector<SurfaceVertex>& of, std::size_t shift) {
    for (const SurfaceVertex& vertex : of) {
      const auto triangle = (static_cast<std::size_t>(std::lround(vertex.triangle)) + shift) % 3;
      const std::size_t off = triangle == 2 ? 2 : 1;
      if (vertex.weights[off] != 0) continue;
      const float along = triangle == 0 ? vertex.weights[2] : triangle == 1 ? vertex.weights[0] : vertex.weights[1];
      const auto [at, is_new] = steps.try_emplace(static_cast<int>(std::lround(16 * along)), vertex.position);
      if (!is_new) t.expect(same_position(at->second, vertex.position), "all sides, in any order, have the same ridge");
    }
  };
  collect(vertices, 0);
  collect(again, 1);
  t.expect_equal(steps.size(), 17U, "vertices on the edge");
}

// The third side has the opposite normals of the first side, so two sides are the same. An implementation may take any
// of the three.
void check_opposite_of_three(Test& t) {
  for (const Vec3& other : {Vec3{-0.9F, 0.4F, 0.3F}, {0.9F, 0.4F, 0.3F}, {0.01F, 0.9F, 0.5F}, {-0.01F, -0.9F, 0.5F}}) {
    const Mesh two = roof(other, {other[0], -other[2], other[1]});
    for (const std::size_t place_of_third : {0U, 3U, 6U}) {
      MeshVertex third[3] = {two[0], two[2], two[1]};
      for (MeshVertex& vertex : third)
        for (float& component : vertex.normal) component = -component;
      third[2].position = {0.2F, -0.1F, 0.9F, 1};
      Mesh three = two;
      three.insert(three.begin() + static_cast<std::ptrdiff_t>(place_of_third), third, third + 3);
      number_triangles(three);
      const auto vertices = welded(t, three, GL_CURVED_PN_ARK);
      std::vector<SurfaceVertex> pair;
      for (SurfaceVertex vertex : vertices) {
        const auto triangle = static_cast<std::size_t>(std::lround(vertex.triangle));
        if (3 * triangle == place_of_third) continue;
        vertex.triangle = 3 * triangle > place_of_third ? vertex.triangle - 1 : vertex.triangle;
        pair.push_back(vertex);
      }
      expect_ridge(t, two, ridge_of(pair));
    }
  }
}

constexpr Area weld_case{"ark.weld."};

}  // namespace

Cases welded_ridge_cases() {
  return {
      weld_case("curved.formula", {"11.R.15-3", "11.R.15-7", "11.R.15-10"},
                "Two triangles with different normals on their common edge: both have the curve of (11.R.9), by the "
                "same bits.",
                "The mean of the normals; S and R are not divided by their squares; each side keeps its own.",
                check_formula),
      weld_case("curved.fourth_component", {"11.R.15-4"},
                "The ends of the ridge differ only in their fourth component: nothing is welded.",
                "Only three components are compared.", check_fourth_component),
      weld_case("curved.faint", {"11.R.15-10"}, "Normals that differ little, so that R . R is below c.",
                "A division by R . R moves the edge far away.", check_faint),
      weld_case("curved.off", {"11.R.15-2", "issues-42"}, "Without WELD_ARK the same two triangles separate.",
                "Always welded.", check_without),
      weld_case("curved.same_normals", {"11.R.15-9"}, "With the same normals WELD_ARK changes nothing.",
                "(11.R.9) with N = M differs from (11.R.2).", check_same_normals),
      weld_case("curved.opposite_normals", {"11.R.15-8"}, "One side has the opposite normals: nothing changes.",
                "S = 0 leaves the edge straight, or without bounds.", check_opposite),
      weld_case("curved.zero_normal", {"11.R.15-8"}, "One side has zero normals: the edge is that of the other side.",
                "A side without a normal counts.", check_zero_normal),
      weld_case("curved.three_sides", {"11.R.15-7", "11.R.15-12"},
                "Three sides with three normals have the same edge, in either order of the triangles.",
                "The first two sides win; the third cracks.", check_three_sides),
      weld_case("curved.opposite_of_three", {"11.R.15-8", "11.R.15-12"},
                "Of three sides, one has the opposite normals of another: the ridge is that of two.",
                "These two count as different, and the third side is left out.", check_opposite_of_three),
      weld_case("curved.cube", {"11.R.15-11"}, "A cube with the normals of its faces stays a cube.",
                "The cube becomes a cushion, or its edges crack.", check_cube),
      weld_case("normals_kept", {"11.R.15-13"},
                "Normals and texture coordinates have the bits that they have without WELD_ARK.",
                "The welded normal is drawn: hard edges are smoothed.", check_normals_kept),
      weld_case("place.sign_of_zero", {"11.R.15-4"}, "0 and -0 are one place.",
                "Bits are compared, so they count as two places.", check_sign_of_zero),
      weld_case("place.one_bit", {"11.R.15-4"}, "Places that differ in one bit are different.",
                "Places are rounded to a grid.", check_other_places),
      weld_case("tags.greatest", {"11.R.15-6"},
                "Vertices at one place have different tags: the greatest counts in every triangle.",
                "The first tag, the least, or each its own: a T-junction.", check_tags),
      weld_case("tagged.bits", {"11.R.15-14", "11.R.15-15"},
                "SCALAR_TAGGED_PN_ARK without tags has the bits of CURVED_PN_ARK.", "Not welded.", check_tagged_bits),
      weld_case("curved.same_normals_at_other_w", {"11.R.15-9", "11.R.7-15", "11.R.7c-5"},
                "With the same normals WELD_ARK changes nothing where fourth components differ along the ridge.",
                "The welded control points bend an edge that stays straight.", check_same_normals_at_other_w),
      weld_case("tagged.tension", {"11.R.15-14", "11.R.7a-8"},
                "Tensions of both signs, beyond the range and NaN pull the welded control points to the corner, or "
                "push them away.",
                "Tension is lost in welding, or only one sign of it counts.",
                [](Test& t) { check_tagged_tension(t, false); }),
      weld_case("tagged.one_end", {"11.R.15-14", "11.R.15-16"},
                "The same with one tagged end of the ridge: only the other end is welded.",
                "Both ends are welded, or neither.", [](Test& t) { check_tagged_tension(t, true); }),
  };
}

}  // namespace glark::conformance
