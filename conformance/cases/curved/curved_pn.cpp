// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Curved PN triangles (11.R.7): the formulas, and which inputs are the position and the normal.
#include "conformance/cases/cases.h"
#include "conformance/cases/curved/curved_checks.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

void check_uniform(Test& t) {
  refine_uniformly(4, GL_CURVED_PN_ARK);
  const Mesh mesh = bent_mesh();
  expect_surface(t, draw_surface(t, mesh), mesh, {}, reference::curved_pn);
}

void check_tags(Test& t) {
  refine_by_tags(5, GL_CURVED_PN_ARK);
  Mesh mesh = bent_mesh();
  for (std::size_t i = 0; i < mesh.size(); ++i) mesh[i].tag = static_cast<float>((2 * i + 1) % 6);
  expect_surface(t, draw_surface(t, mesh), mesh, {}, reference::curved_pn);
}

void check_others(Test& t) {
  refine_uniformly(3, GL_CURVED_PN_ARK);
  Mesh mesh = bent_mesh();
  for (const std::size_t i : {2U, 3U, 4U}) mesh[i].position[3] = i == 4 ? 2.0F : 1.5F;
  for (const SurfaceVertex& vertex : draw_surface(t, mesh)) {
    const std::size_t first = 3 * static_cast<std::size_t>(std::lround(vertex.triangle));
    for (std::size_t i = 0; i < 2; ++i)
      t.expect_near(vertex.texture[i],
                    reference::refined(vertex.weights, mesh[first].texture[i], mesh[first + 1].texture[i],
                                       mesh[first + 2].texture[i]),
                    t.is_gles() ? 1e-7 : 0, "the texture coordinate is refined linearly");
    t.expect_near(vertex.position[3],
                  reference::refined(vertex.weights, mesh[first].position[3], mesh[first + 1].position[3],
                                     mesh[first + 2].position[3]),
                  t.is_gles() ? 3e-7 : 0, "the fourth component is refined linearly");
  }
}

void check_corners(Test& t) {
  refine_uniformly(3, GL_CURVED_PN_ARK);
  const Mesh mesh = bent_mesh();
  int seen = 0;
  for (const SurfaceVertex& vertex : draw_surface(t, mesh))
    for (std::size_t i = 0; i < 3; ++i) {
      if (vertex.weights[i] != 1) continue;
      ++seen;
      const std::size_t corner = 3 * static_cast<std::size_t>(std::lround(vertex.triangle)) + i;
      t.expect(same_position(vertex.position, mesh[corner].position),
               "the position at a corner is the corner's, by bits");
      t.expect(vertex.normal == mesh[corner].normal, "the normal at a corner is the corner's, by bits");
    }
  t.expect(seen >= 6, "all corners are drawn");
}

void check_zero_normal(Test& t) {
  refine_uniformly(3, GL_CURVED_PN_ARK);
  Mesh mesh = bent_mesh();
  mesh[1].normal = {0, 0, 0};
  mesh[3].normal = {0, 0, 0};
  mesh[4].normal = {0, 0, 0};
  mesh[5].normal = {0, 0, 0};
  expect_surface(t, draw_surface(t, mesh), mesh, {}, reference::curved_pn);
}

void check_fourth_components(Test& t) {
  refine_uniformly(3, GL_CURVED_PN_ARK);
  Mesh mesh = bent_mesh();
  for (const std::size_t i : {2U, 3U}) mesh[i].position[3] = 1.5F;
  expect_surface(t, draw_surface(t, mesh), mesh, {}, reference::curved_pn);
}

void check_opposite_normals(Test& t) {
  refine_uniformly(2, GL_CURVED_PN_ARK);
  Mesh mesh = bent_mesh();
  mesh.resize(3);
  // N_0 + N_1 = 0, so h_01 is zero, and so is n_01. Their products with everything else are exact.
  mesh[0].normal = {0, 0, 1};
  mesh[1].normal = {0, 0, -1};
  mesh[2].normal = {0, 1, 0};
  for (const SurfaceVertex& vertex : draw_surface(t, mesh)) {
    const bool is_middle = vertex.weights[0] == 0.5F && vertex.weights[1] == 0.5F;
    const reference::Surface expected = reference::curved_pn(corners_of(mesh, 0), vertex.weights);
    for (std::size_t i = 0; i < 3; ++i) {
      const double component = i == 0 ? expected.normal.x : i == 1 ? expected.normal.y : expected.normal.z;
      t.expect_near(vertex.normal[i], component, 2e-6,
                    is_middle ? "a zero refined normal stays zero" : "the refined normal");
    }
  }
}

constexpr Area simple_case{"ark.pn."};

}  // namespace

Cases curved_pn_cases() {
  return {
      simple_case(
          "formula.uniform", {"11.R.7-1", "11.R.7-2", "11.R.7-7", "11.R.7-8", "11.R.7-10", "11.R.7-18", "11.R.7-13"},
          "Capture two bent triangles, whose normals are not of unit length, at depth 4, and compare with the patch "
          "evaluated on the CPU in double precision.",
          "Normals that are not scaled bulge too much; control points at the wrong end; the middle control point "
          "without its half; linear refined normals.",
          check_uniform),
      simple_case("formula.tags", {"11.R.7-1", "11.R.7-10", "11.R.7-18"},
                  "The same with a different depth tag at every corner.",
                  "Edge patterns that are rotated against the corners put the patch elsewhere.", check_tags),
      simple_case("formula.other_inputs", {"11.R.7-1", "11.R.7-11"},
                  "Capture a texture coordinate, and the fourth component of positions with different w.",
                  "Every vec4 is curved, or w is lost.", check_others),
      simple_case("formula.corners", {"11.R.7-14", "11.R.7-20"},
                  "Where a weight is 1, compare bits with the corner's position.",
                  "2 P / 3 + P / 3 is not P: the last bit differs.", check_corners),
      simple_case("formula.zero_normal", {"11.R.7-7", "11.R.7-18"},
                  "One corner, then all three, have a zero normal: edges are straight there.",
                  "0 / 0: the triangle vanishes, or positions are NaN.", check_zero_normal),
      simple_case("formula.equal_corners", {"11.R.7-18", "11.R.7-16"},
                  "Two corners are at one place, for each edge: positions lie on one curve, and no normal is NaN.",
                  "D . D = 0 gives NaN; the stitching of a strip shows as slivers.",
                  [](Test& t) { check_equal_corners(t, GL_CURVED_PN_ARK, reference::curved_pn); }),
      simple_case("formula.fourth_components", {"11.R.7-15"},
                  "The fourth components of positions differ along two edges: these edges stay straight.",
                  "Heights of points with different w are computed as if w were the same.", check_fourth_components),
      simple_case("formula.opposite_normals", {"11.R.7-19"},
                  "N_0 + N_1 is zero, and so are n_01 and the refined normal in the middle.",
                  "Scaling a zero to unit length gives NaN.", check_opposite_normals),
      simple_case("formula.shared_edge", {"11.R.7-9", "11.R.7-13", "11.R.8-3"},
                  "Two triangles that share an edge from opposite ends have the same positions along it, by bits.",
                  "Sums depend on the order of corners: cracks of one ulp.",
                  [](Test& t) { check_shared_edge(t, GL_CURVED_PN_ARK); }),
      simple_case("formula.one_place", {"11.R.7-17"},
                  "All corners are at one place: every refined vertex is there, by bits.",
                  "Rounding moves them; D . D = 0 gives NaN.", [](Test& t) { check_one_place(t, GL_CURVED_PN_ARK); }),
      {.name = "ark.pn.missing.normal",
       .clauses = {"11.R.7-6"},
       .plan = "The vertex stage has no normal: positions are those of (11.R.1).",
       .wrong = "A constant replaces the missing normal, and the surface bends.",
       .check = [](Test& t) { check_missing_input(t, GL_CURVED_PN_ARK, true); }},
      {.name = "ark.pn.missing.position",
       .clauses = {"11.R.7-6"},
       .plan = "No input has a position's name or location 0: (11.R.1) refines every input.",
       .wrong = "The first vec4 counts as the position.",
       .check = [](Test& t) { check_missing_input(t, GL_CURVED_PN_ARK, false); }},
  };
}

}  // namespace glark::conformance
