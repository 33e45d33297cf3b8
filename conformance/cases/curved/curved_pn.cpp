// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Curved PN triangles (11.R.7): the formulas, and which inputs are the position and the normal.
#include "conformance/cases/cases.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

std::vector<SurfaceVertex> curved(Test& t, const Mesh& mesh, GLuint program) {
  gl.UseProgram(program);
  upload(mesh);
  return capture_surface(t, mesh);
}

void check_uniform(Test& t) {
  refine_uniformly(4, GL_CURVED_PN_ARK);
  const Mesh mesh = bent_mesh();
  expect_surface(t, curved(t, mesh, surface_program(t)), mesh, {}, reference::curved_pn);
}

void check_tags(Test& t) {
  refine_by_tags(5, GL_CURVED_PN_ARK);
  Mesh mesh = bent_mesh();
  for (std::size_t i = 0; i < mesh.size(); ++i) mesh[i].tag = static_cast<float>((2 * i + 1) % 6);
  expect_surface(t, curved(t, mesh, surface_program(t)), mesh, {}, reference::curved_pn);
}

void check_others(Test& t) {
  refine_uniformly(3, GL_CURVED_PN_ARK);
  Mesh mesh = bent_mesh();
  for (const std::size_t i : {2U, 3U, 4U}) mesh[i].position[3] = i == 4 ? 2.0F : 1.5F;
  for (const SurfaceVertex& vertex : curved(t, mesh, surface_program(t))) {
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
  for (const SurfaceVertex& vertex : curved(t, mesh, surface_program(t)))
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
  expect_surface(t, curved(t, mesh, surface_program(t)), mesh, {}, reference::curved_pn);
}

void check_equal_corners(Test& t) {
  refine_uniformly(3, GL_CURVED_PN_ARK);
  for (const std::size_t from : {0U, 1U, 2U}) {
    Mesh mesh = bent_mesh();
    mesh.resize(3);
    mesh[(from + 1) % 3].position = mesh[from].position;
    expect_surface(t, curved(t, mesh, surface_program(t)), mesh, {}, reference::curved_pn);
  }
}

void check_fourth_components(Test& t) {
  refine_uniformly(3, GL_CURVED_PN_ARK);
  Mesh mesh = bent_mesh();
  for (const std::size_t i : {2U, 3U}) mesh[i].position[3] = 1.5F;
  expect_surface(t, curved(t, mesh, surface_program(t)), mesh, {}, reference::curved_pn);
}

void check_opposite_normals(Test& t) {
  refine_uniformly(2, GL_CURVED_PN_ARK);
  Mesh mesh = bent_mesh();
  mesh.resize(3);
  // N_0 + N_1 = 0, so h_01 is zero, and so is n_01. Their products with everything else are exact.
  mesh[0].normal = {0, 0, 1};
  mesh[1].normal = {0, 0, -1};
  mesh[2].normal = {0, 1, 0};
  for (const SurfaceVertex& vertex : curved(t, mesh, surface_program(t))) {
    const bool is_middle = vertex.weights[0] == 0.5F && vertex.weights[1] == 0.5F;
    const reference::Surface expected = reference::curved_pn(corners_of(mesh, 0), vertex.weights);
    for (std::size_t i = 0; i < 3; ++i) {
      const double component = i == 0 ? expected.normal.x : i == 1 ? expected.normal.y : expected.normal.z;
      t.expect_near(vertex.normal[i], component, 2e-6,
                    is_middle ? "a zero refined normal stays zero" : "the refined normal");
    }
  }
}

// Only the ends of the shared edge count: the third corners differ.
void check_shared_edge(Test& t) {
  refine_uniformly(4, GL_CURVED_PN_ARK);
  const Mesh mesh = bent_mesh();
  std::array<std::vector<Vec4>, 2> sides = {std::vector<Vec4>(17), std::vector<Vec4>(17)};
  for (const SurfaceVertex& vertex : curved(t, mesh, surface_program(t))) {
    // The edge from corner 0 to corner 2 of the first triangle is the edge from corner 2 to corner 0 of the second.
    if (vertex.weights[1] != 0) continue;
    const bool is_second = vertex.triangle == 1;
    sides[is_second ? 1 : 0][static_cast<std::size_t>(std::lround(16 * vertex.weights[is_second ? 2 : 0]))] =
        vertex.position;
  }
  for (std::size_t i = 0; i <= 16; ++i)
    t.expect(same_position(sides[0][i], sides[1][i]), "the edge has the same bits in both triangles");
}

void check_missing(Test& t, bool has_position) {
  refine_uniformly(2, GL_CURVED_PN_ARK);
  const Mesh mesh = bent_mesh();
  // The position is at location 8 wherever no input may count as a position.
  const std::string vertex_shader =
      has_position ? "layout(location = 0) in vec4 position; layout(location = 2) in vec3 weights; out vec4 colour;\n"
                     "layout(location = 6) in float triangle; out vec3 weights_out; out float triangle_out;\n"
                     "void main() { weights_out = weights; triangle_out = triangle; colour = vec4(1.0);\n"
                     "  gl_Position = position; }\n"
                   : "layout(location = 8) in vec4 where; layout(location = 1) in vec3 normal; out vec4 colour;\n"
                     "layout(location = 2) in vec3 weights; layout(location = 6) in float triangle;\n"
                     "out vec3 weights_out; out float triangle_out;\n"
                     "void main() { weights_out = weights; triangle_out = triangle; colour = vec4(normal, 1.0);\n"
                     "  gl_Position = where; }\n";
  gl.UseProgram(
      build_program(t, {.vertex = vertex_shader, .captured = {"gl_Position", "weights_out", "triangle_out"}}));
  upload(mesh);
  gl.VertexAttribPointer(8, 4, GL_FLOAT, GL_FALSE, sizeof(MeshVertex), nullptr);
  gl.EnableVertexAttribArray(8);
  for (const CapturedVertex& vertex : capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 6); })) {
    const std::size_t first = 3 * static_cast<std::size_t>(std::lround(vertex.triangle));
    for (std::size_t i = 0; i < 4; ++i)
      t.expect_near(vertex.position[i],
                    reference::refined(vertex.weights, mesh[first].position[i], mesh[first + 1].position[i],
                                       mesh[first + 2].position[i]),
                    t.is_gles() ? 3e-7 : 0, "the position is refined linearly");
  }
}

constexpr Area simple_case{"ark.pn."};

void check_one_place(Test& t) {
  gl.UseProgram(surface_program(t));
  Mesh mesh = bent_mesh();
  mesh.resize(3);
  for (MeshVertex& vertex : mesh) vertex.position = {0.1F, -0.7F, 0.3F, 1};
  upload(mesh);
  refine_uniformly(4, GL_CURVED_PN_ARK);
  const auto vertices = capture_surface(t, mesh);
  t.require(vertices.size() == 768, "the triangle is refined");
  for (const SurfaceVertex& vertex : vertices)
    if (!t.expect(std::equal(vertex.position.begin(), vertex.position.begin() + 3, mesh[0].position.begin()),
                  "every refined vertex has the bits of P_0"))
      return;
}

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
                  "D . D = 0 gives NaN; the stitching of a strip shows as slivers.", check_equal_corners),
      simple_case("formula.fourth_components", {"11.R.7-15"},
                  "The fourth components of positions differ along two edges: these edges stay straight.",
                  "Heights of points with different w are computed as if w were the same.", check_fourth_components),
      simple_case("formula.opposite_normals", {"11.R.7-19"},
                  "N_0 + N_1 is zero, and so are n_01 and the refined normal in the middle.",
                  "Scaling a zero to unit length gives NaN.", check_opposite_normals),
      simple_case("formula.shared_edge", {"11.R.7-9", "11.R.7-13", "11.R.8-3"},
                  "Two triangles that share an edge from opposite ends have the same positions along it, by bits.",
                  "Sums depend on the order of corners: cracks of one ulp.", check_shared_edge),
      simple_case("formula.one_place", {"11.R.7-17"},
                  "All corners are at one place: every refined vertex is there, by bits.",
                  "Rounding moves them; D . D = 0 gives NaN.", check_one_place),
      {.name = "ark.pn.missing.normal",
       .clauses = {"11.R.7-6"},
       .plan = "The vertex stage has no normal: positions are those of (11.R.1).",
       .wrong = "A constant replaces the missing normal, and the surface bends.",
       .check = [](Test& t) { check_missing(t, true); }},
      {.name = "ark.pn.missing.position",
       .clauses = {"11.R.7-6"},
       .plan = "No input has a position's name or location 0: (11.R.1) refines every input.",
       .wrong = "The first vec4 is taken for the position.",
       .check = [](Test& t) { check_missing(t, false); }},
  };
}

}  // namespace glark::conformance
