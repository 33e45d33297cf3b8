// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Phong tessellation (11.R.7c): the formula, its parameter, welded edges and displacement.
#include <algorithm>
#include <cmath>
#include <limits>

#include "conformance/cases/cases.h"
#include "conformance/cases/curved/curved_checks.h"
#include "conformance/support/state.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

template <int percent>
reference::Surface phong(const reference::Corners& corners, const Vec3& weights) {
  return reference::phong(corners, weights, percent / 100.0);
}

void check_uniform(Test& t) {
  refine_uniformly(4, GL_PHONG_ARK);
  const Mesh mesh = bent_mesh();
  expect_surface(t, draw_surface(t, mesh), mesh, {}, phong<75>);
}

void check_tags(Test& t) {
  refine_by_tags(5, GL_PHONG_ARK);
  Mesh mesh = bent_mesh();
  for (std::size_t i = 0; i < mesh.size(); ++i) mesh[i].tag = static_cast<float>((2 * i + 1) % 6);
  expect_surface(t, draw_surface(t, mesh), mesh, {}, phong<75>);
}

// One program, drawn with several shapes.
void check_shapes(Test& t) {
  refine_uniformly(3, GL_PHONG_ARK);
  const Mesh mesh = bent_mesh();
  gl.UseProgram(surface_program(t));
  upload(mesh);
  struct Shape {
    float value;
    SurfaceOf surface;
  };
  for (const Shape& shape :
       {Shape{1, phong<100>}, Shape{0.25F, phong<25>}, Shape{0, phong<0>}, Shape{0.5F, phong<50>}}) {
    gl.ARKParameterfARK(GL_PHONG_SHAPE_ARK, shape.value);
    expect_surface(t, capture_surface(t, mesh), mesh, {}, shape.surface);
  }
}

void check_others(Test& t) {
  refine_uniformly(3, GL_PHONG_ARK);
  const Mesh mesh = bent_mesh();
  for (const SurfaceVertex& vertex : draw_surface(t, mesh)) {
    const std::size_t first = 3 * static_cast<std::size_t>(std::lround(vertex.triangle));
    for (std::size_t i = 0; i < 3; ++i)
      t.expect_near(vertex.normal[i],
                    reference::refined(vertex.weights, mesh[first].normal[i], mesh[first + 1].normal[i],
                                       mesh[first + 2].normal[i]),
                    t.is_gles() ? 2e-7 : 0, "the normal is refined linearly");
    for (std::size_t i = 0; i < 2; ++i)
      t.expect_near(vertex.texture[i],
                    reference::refined(vertex.weights, mesh[first].texture[i], mesh[first + 1].texture[i],
                                       mesh[first + 2].texture[i]),
                    t.is_gles() ? 2e-7 : 0, "the texture coordinate is refined linearly");
  }
}

void check_corners(Test& t) {
  refine_uniformly(3, GL_PHONG_ARK);
  const Mesh mesh = bent_mesh();
  int seen = 0;
  for (const SurfaceVertex& vertex : draw_surface(t, mesh))
    for (std::size_t i = 0; i < 3; ++i) {
      if (vertex.weights[i] != 1) continue;
      ++seen;
      const std::size_t corner = 3 * static_cast<std::size_t>(std::lround(vertex.triangle)) + i;
      t.expect(same_position(vertex.position, mesh[corner].position), "the position at a corner, by bits");
    }
  t.expect(seen >= 6, "all corners are drawn");
}

void check_fourth_components(Test& t) {
  refine_uniformly(3, GL_PHONG_ARK);
  Mesh mesh = bent_mesh();
  for (const std::size_t i : {2U, 3U}) mesh[i].position[3] = 1.5F;
  const auto vertices = draw_surface(t, mesh);
  expect_surface(t, vertices, mesh, {}, phong<75>);
  for (const SurfaceVertex& vertex : vertices) {
    const std::size_t first = 3 * static_cast<std::size_t>(std::lround(vertex.triangle));
    t.expect_near(vertex.position[3],
                  reference::refined(vertex.weights, mesh[first].position[3], mesh[first + 1].position[3],
                                     mesh[first + 2].position[3]),
                  t.is_gles() ? 3e-7 : 0, "the fourth component is refined linearly");
  }
}

// The same edge with other normals in the second triangle.
void check_welded(Test& t) {
  refine_uniformly(4, GL_PHONG_ARK);
  gl.ARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  Mesh mesh = bent_mesh();
  mesh[3].normal = {0.9F, -0.3F, 0.7F};
  mesh[5].normal = {-0.4F, 0.8F, 0.9F};
  const auto vertices = draw_surface(t, mesh);
  const auto sides = shared_edge(vertices, 16);
  for (std::size_t i = 0; i <= 16; ++i)
    t.expect(same_position(sides[0][i], sides[1][i]), "a welded edge has the same bits in both triangles");
  const reference::Corners corners = corners_of(mesh, 0);
  reference::ControlPoints b = reference::curved_control_points(corners);
  b[0][2] = reference::welded_control_point(corners[0], corners[2], mesh[5].normal);
  b[2][0] = reference::welded_control_point(corners[2], corners[0], mesh[3].normal);
  for (const SurfaceVertex& vertex : vertices) {
    if (vertex.triangle >= 1) continue;
    const reference::Vector expected = reference::phong_position(corners, b, vertex.weights, 0.75);
    const double off = reference::length(reference::vector_of(vertex.position) - expected);
    if (!t.expect_near(off, 0, 2e-6, "the distance from the surface with welded edges")) return;
  }
}

void check_shape_values(Test& t) {
  set_everything(t);
  for (const GLfloat value : {0.0F, 1.0F, 0.5F}) {
    gl.ARKParameterfARK(GL_PHONG_SHAPE_ARK, value);
    t.expect_no_error("a number from 0 to 1");
    t.expect_equal(number_of(GL_PHONG_SHAPE_ARK), value, "the parameter");
  }
  using Limits = std::numeric_limits<GLfloat>;
  for (const GLfloat value : {-0.01F, 1.01F, 2.0F, Limits::infinity(), Limits::quiet_NaN()})
    expect_refused(t, GL_INVALID_VALUE, "a number out of range",
                   [&] { gl.ARKParameterfARK(GL_PHONG_SHAPE_ARK, value); });
  for (const GLint value : {-1, 2})
    expect_refused(t, GL_INVALID_VALUE, "an integer out of range",
                   [&] { gl.ARKParameteriARK(GL_PHONG_SHAPE_ARK, value); });
  gl.ARKParameteriARK(GL_PHONG_SHAPE_ARK, 1);
  t.expect_equal(number_of(GL_PHONG_SHAPE_ARK), 1.0F, "the parameter, set as an integer");
}

void check_initial(Test& t) { t.expect_equal(number_of(GL_PHONG_SHAPE_ARK), 0.75F, "PHONG_SHAPE_ARK at first"); }

constexpr GLint unit = 3;
constexpr double scale = 0.5;
constexpr double rise_s = 0.05 * 16;
constexpr double rise_t = -0.02 * 16;

void ramp() {
  std::vector<float> texels;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) texels.push_back(0.05F * static_cast<float>(x) - 0.02F * static_cast<float>(y));
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.ActiveTexture(GL_TEXTURE0 + unit);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R16F, 16, 16, 0, GL_RED, GL_FLOAT, texels.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.ActiveTexture(GL_TEXTURE0);
}

// The surface, displaced everywhere by the height of one vertex. The sum of the weights need not be 1.
reference::Vector raised(const reference::Corners& corners, double w, double u, double v, double height) {
  const reference::Surface surface =
      reference::phong(corners, {static_cast<float>(w), static_cast<float>(u), static_cast<float>(v)}, 1);
  return surface.position + height * reference::direction(surface.normal);
}

// The first derivatives of a surface along its sides from corner 0.
struct Tangents {
  reference::Vector along_u;
  reference::Vector along_v;
};

Tangents tangents_of_surface(const reference::Corners& corners, const Vec3& at, double height) {
  const double step = 1.0 / 256;
  const auto along = [&](double u, double v) {
    const reference::Vector ahead = raised(corners, at[0] - step * (u + v), at[1] + step * u, at[2] + step * v, height);
    const reference::Vector back = raised(corners, at[0] + step * (u + v), at[1] - step * u, at[2] - step * v, height);
    return (ahead - back) / (2 * step);
  };
  return {along(1, 0), along(0, 1)};
}

Tangents tangents_of_triangle(const reference::Corners& corners) {
  const reference::Vector origin = reference::vector_of(corners[0].position);
  return {reference::vector_of(corners[1].position) - origin, reference::vector_of(corners[2].position) - origin};
}

double height_of(const SurfaceVertex& vertex) {
  return scale * (rise_s * (vertex.texture[0] - 0.5 / 16) + rise_t * (vertex.texture[1] - 0.5 / 16));
}

reference::Vector displaced_normal(const reference::Corners& corners, const SurfaceVertex& vertex,
                                   const Tangents& tangents, const MeshVertex* triangle) {
  const auto rise = [&](std::size_t corner) {
    return scale * (rise_s * static_cast<double>(triangle[corner].texture[0] - triangle[0].texture[0]) +
                    rise_t * static_cast<double>(triangle[corner].texture[1] - triangle[0].texture[1]));
  };
  const reference::Vector given = reference::phong(corners, vertex.weights, 1).normal;
  const reference::Vector n = reference::direction(given);
  const double area = reference::dot(n, reference::cross(tangents.along_u, tangents.along_v));
  const reference::Vector gradient =
      (rise(1) * reference::cross(tangents.along_v, n) + rise(2) * reference::cross(n, tangents.along_u)) / area;
  return reference::length(given) * reference::direction(n - gradient);
}

// Two triangles with normals that lean outwards so much that the slopes of the surface differ a lot from those of the
// flat triangles.
Mesh leaning_mesh() {
  Mesh mesh = bent_mesh();
  const Vec3 normals[4] = {{-0.9F, -0.8F, 0.5F}, {0.9F, -0.7F, 0.45F}, {0.8F, 0.9F, 0.5F}, {-0.9F, 0.8F, 0.45F}};
  const Vec2 texture[4] = {{0.3F, 0.35F}, {0.7F, 0.3F}, {0.65F, 0.7F}, {0.35F, 0.6F}};
  const std::size_t places[] = {0, 1, 2, 2, 3, 0};
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    mesh[i].normal = normals[places[i]];
    mesh[i].texture = texture[places[i]];
  }
  return mesh;
}

void check_displaced(Test& t) {
  constexpr double tolerance = 0.02;  // R16F texels, and 8 bits for the position between two texels
  ramp();
  const Mesh mesh = leaning_mesh();
  refine_uniformly(3, GL_PHONG_ARK);
  gl.ARKParameterfARK(GL_PHONG_SHAPE_ARK, 1);
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, unit);
  gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, static_cast<float>(scale));
  double apart = 0;  // from the normal by the slopes of the flat triangle
  for (const SurfaceVertex& vertex : draw_surface(t, mesh)) {
    const auto triangle = static_cast<std::size_t>(std::lround(vertex.triangle));
    const reference::Corners corners = corners_of(mesh, triangle);
    const double height = height_of(vertex);
    const reference::Vector place = raised(corners, vertex.weights[0], vertex.weights[1], vertex.weights[2], height);
    const double off = reference::length(reference::vector_of(vertex.position) - place);
    const auto normal_by = [&](const Tangents& tangents) {
      return displaced_normal(corners, vertex, tangents, &mesh[3 * triangle]);
    };
    const reference::Vector normal = normal_by(tangents_of_surface(corners, vertex.weights, height));
    apart = std::max(apart, reference::length(normal - normal_by(tangents_of_triangle(corners))));
    const double turned = reference::length(reference::vector_of(vertex.normal) - normal);
    if (!t.expect(off < 0.005, "a displaced position is off by " + as_text(off))) return;
    if (!t.expect(turned < tolerance, "the normal of the displaced surface is off by " + as_text(turned))) return;
  }
  t.expect(apart > 5 * tolerance, "a mesh that bends enough, by " + as_text(apart));
}

constexpr Area simple_case{"ark.phong."};

Cases formula_cases() {
  return {
      simple_case("formula.uniform", {"11.R.7c-1", "11.R.7c-4", "11.R.7c-6", "tokens-54"},
                  "Capture two bent triangles at depth 4 and compare with (11.R.10) in double precision.",
                  "Normals that are not scaled; projections onto the other end's plane; no interpolation with the flat "
                  "triangle.",
                  check_uniform),
      simple_case("formula.tags", {"11.R.7c-6"}, "The same with a different depth tag at every corner.",
                  "Edge patterns that are rotated against the corners put the surface elsewhere.", check_tags),
      simple_case("formula.shapes", {"11.R.7c-6", "11.R.2-35", "tokens-53"},
                  "Draw with one program and the shapes 1, 0.25, 0 and 0.5.",
                  "The shape of the first draw, or the initial one, is used for all.", check_shapes),
      simple_case("formula.other_inputs", {"11.R.7c-1"}, "Capture the normal and a texture coordinate.",
                  "The normal is refined as with CURVED_PN_ARK.", check_others),
      simple_case("formula.corners", {"11.R.7c-9"}, "Where a weight is 1, compare bits with the corner's position.",
                  "a P + (1 - a) P is not P: the last bit differs.", check_corners),
      simple_case("formula.fourth_components", {"11.R.7c-5", "11.R.7c-7"},
                  "The fourth components of positions differ along two edges: these stay straight.",
                  "Heights of points with different w are computed as if w were the same.", check_fourth_components),
      simple_case("formula.equal_corners", {"11.R.7c-8"},
                  "Two corners are at one place, for each edge: positions lie on one curve.",
                  "The stitching of a strip shows as slivers.",
                  [](Test& t) { check_equal_corners(t, GL_PHONG_ARK, phong<75>); }),
      simple_case("formula.one_place", {"11.R.7c-8"},
                  "All corners are at one place: every refined vertex is there, by bits.", "Rounding moves them.",
                  [](Test& t) { check_one_place(t, GL_PHONG_ARK); }),
      simple_case("formula.shared_edge", {"11.R.8-3", "11.R.8-6"},
                  "Two triangles that share an edge from opposite ends have the same positions along it, by bits.",
                  "Sums depend on the order of corners: cracks of one ulp.",
                  [](Test& t) { check_shared_edge(t, GL_PHONG_ARK); }),
  };
}

}  // namespace

Cases phong_tessellation_cases() {
  Cases cases = formula_cases();
  const Cases others = {
      simple_case("missing.normal", {"11.R.7c-3"}, "A vertex stage without a normal: positions are those of (11.R.1).",
                  "A constant replaces the missing normal, and the surface bends.",
                  [](Test& t) { check_missing_input(t, GL_PHONG_ARK, true); }),
      simple_case("missing.position", {"11.R.7c-3"},
                  "No input has a position's name or location 0: (11.R.1) refines every input.",
                  "The first vec4 counts as the position.",
                  [](Test& t) { check_missing_input(t, GL_PHONG_ARK, false); }),
      simple_case("welded", {"11.R.15-36", "11.R.15-7"},
                  "Two triangles with different normals at a common edge: the edge has the same bits in both, and is "
                  "that of (11.R.9) and (11.R.10).",
                  "WELD_ARK has no effect; the edge follows one side's normals.", check_welded),
      simple_case("displaced", {"11.R.7b-11", "11.R.7b-1"},
                  "Displace by a ramp; compare positions and normals with finite differences of the surface.",
                  "Slopes of the flat triangle.", check_displaced),
      simple_case("shape.values", {"11.R.2-39", "11.R.2-35", "11.R.2-29", "errors-25"},
                  "Set numbers and integers in the range and out of it.", "Every finite number is accepted.",
                  check_shape_values),
      simple_case("shape.initial", {"state-32"}, "Read PHONG_SHAPE_ARK at first.", "0, or 1.", check_initial),
  };
  cases.insert(cases.end(), others.begin(), others.end());
  return cases;
}

}  // namespace glark::conformance
