// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Displacement along seams with WELD_ARK (11.R.15): the normal and the coordinate of a place, and the dominant side.
#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/cases/displacement/nearest_texture.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

using reference::Vector;

constexpr int size = 4;
constexpr GLint unit = 2;
constexpr double scale = 0.25;

// One height for each texel, or `constant` everywhere if that is not negative.
float height_at(int x, int y, float constant) {
  return constant >= 0 ? constant : static_cast<float>((37 * x + 59 * y + 11 * x * y) % 256) / 255;
}

double sampled(const std::array<double, 2>& at, float constant) {
  const auto texel = [](double coordinate) {
    return ((static_cast<int>(std::floor(coordinate * size)) % size) + size) % size;
  };
  return static_cast<double>(height_at(texel(at[0]), texel(at[1]), constant));
}

void set_displacement(float constant) {
  std::vector<GLubyte> texels;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      texels.insert(texels.end(), 4, static_cast<GLubyte>(std::lround(255 * height_at(x, y, constant))));
  bind_nearest_texture(unit, size, texels);
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, unit);
  gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, static_cast<float>(scale));
}

// Vertices 0 and 5 are at one place, and so are 2 and 3. Each has its own normal and texture coordinates.
Mesh seam(bool second_dominates) {
  Mesh mesh = bent_mesh();
  const auto set = [&](std::size_t i, const Vec3& normal, const Vec2& texture) {
    const Vector unit_normal = reference::direction(reference::vector_of(normal));
    mesh[i].normal = {static_cast<float>(unit_normal.x), static_cast<float>(unit_normal.y),
                      static_cast<float>(unit_normal.z)};
    mesh[i].texture = texture;
  };
  // First components are positive, so that their bits have the order of the numbers.
  const float here = second_dominates ? 0.6F : 0.2F;
  const float there = second_dominates ? 0.2F : 0.6F;
  set(0, {here, 0.3F, 0.7F}, {0.06F, 0.41F});
  set(2, {here, -0.4F, 0.5F}, {0.87F, 0.33F});
  set(5, {there, -0.5F, 0.4F}, {0.31F, 0.12F});
  set(3, {there, 0.1F, 0.8F}, {0.57F, 0.93F});
  return mesh;
}

std::vector<SurfaceVertex> drawn(Test& t, const Mesh& mesh, GLenum refinement, float constant) {
  gl.UseProgram(surface_program(t));
  upload(mesh);
  set_displacement(constant);
  refine_uniformly(3, refinement);
  gl.ARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  auto vertices = capture_surface(t, mesh);
  t.require(vertices.size() == mesh.size() << 6U, "the mesh is refined");
  return vertices;
}

bool is_on_border(const SurfaceVertex& vertex) {
  return vertex.weights[0] == 0 || vertex.weights[1] == 0 || vertex.weights[2] == 0;
}

void check_position(Test& t, GLenum refinement) {
  for (const bool second : {false, true}) {
    std::array<std::vector<Vec4>, 2> ridge;
    for (auto& side : ridge) side.resize(9);
    for (const SurfaceVertex& vertex : drawn(t, seam(second), refinement, -1)) {
      if (vertex.weights[1] != 0) continue;
      const bool is_second = vertex.triangle >= 1;
      const auto step = static_cast<std::size_t>(std::lround(8 * vertex.weights[is_second ? 0 : 2]));
      ridge[is_second ? 1 : 0][step] = vertex.position;
    }
    for (std::size_t i = 0; i < 9; ++i)
      t.expect(same_position(ridge[0][i], ridge[1][i]),
               fmt::format("step {} of a displaced seam has the same position on both sides, by bits", i));
  }
}

bool same_place(const MeshVertex& a, const MeshVertex& b) { return same_position(a.position, b.position); }

double angle_at(const Mesh& mesh, std::size_t i) {
  const std::size_t first = i - i % 3;
  const Vector at = reference::vector_of(mesh[i].position);
  const Vector a = reference::direction(reference::vector_of(mesh[first + (i + 1) % 3].position) - at);
  const Vector b = reference::direction(reference::vector_of(mesh[first + (i + 2) % 3].position) - at);
  return std::acos(std::clamp(reference::dot(a, b), -1.0, 1.0));
}

Vector normal_of_place(const Mesh& mesh, std::size_t corner) {
  Vector sum;
  bool is_one = true;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    if (!same_place(mesh[i], mesh[corner])) continue;
    is_one = is_one && mesh[i].normal == mesh[corner].normal;
    sum = sum + angle_at(mesh, i) * reference::direction(reference::vector_of(mesh[i].normal));
  }
  if (is_one) return reference::vector_of(mesh[corner].normal);
  const double most = std::max({std::abs(sum.x), std::abs(sum.y), std::abs(sum.z)});
  return most < std::exp2(-10) ? Vector{} : reference::direction(sum);
}

Vector flat(const Mesh& mesh, const SurfaceVertex& vertex, bool is_of_place, bool is_normal) {
  const auto first = 3 * static_cast<std::size_t>(std::lround(vertex.triangle));
  Vector sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const MeshVertex& corner = mesh[first + i];
    const Vector value = !is_normal    ? reference::vector_of(corner.position)
                         : is_of_place ? normal_of_place(mesh, first + i)
                                       : reference::vector_of(corner.normal);
    sum = sum + static_cast<double>(vertex.weights[i]) * value;
  }
  return sum;
}

// Heights are 1 everywhere, so that the case sees how far and in which direction each vertex moves.
void expect_normals(Test& t, const Mesh& mesh, const std::string& what) {
  for (const SurfaceVertex& vertex : drawn(t, mesh, GL_LINEAR_INPUTS_ARK, 1)) {
    const bool is_border = is_on_border(vertex);
    const Vector expected =
        flat(mesh, vertex, false, false) + scale * reference::direction(flat(mesh, vertex, is_border, true));
    const double off = reference::length(reference::vector_of(vertex.position) - expected);
    if (!t.expect(off < 1e-4, what + (is_border ? "on the border" : "inside") +
                                  " a vertex moves along the normal of the places, or its own: off by " + as_text(off)))
      return;
  }
}

// The angles of thin triangles are small, and so are their sums.
void check_normal(Test& t, bool is_thin) {
  Mesh mesh = seam(false);
  for (const std::size_t tip : {1U, 4U})
    for (std::size_t k = 0; k < 3 && is_thin; ++k) {
      const float middle = 0.5F * (mesh[0].position[k] + mesh[2].position[k]);
      mesh[tip].position[k] = middle + 0.1F * (mesh[tip].position[k] - middle);
    }
  expect_normals(t, mesh, "");
}

// All sums have the same three signs: each sign in turn.
void check_octants(Test& t) {
  for (unsigned octant = 0; octant < 8; ++octant) {
    Mesh mesh = seam(false);
    for (MeshVertex& vertex : mesh)
      for (std::size_t k = 0; k < 3; ++k)
        vertex.normal[k] = ((octant >> k) & 1U) != 0 ? -std::abs(vertex.normal[k]) : std::abs(vertex.normal[k]);
    expect_normals(t, mesh, fmt::format("octant {}: ", octant));
  }
}

using Coordinate = std::array<double, 2>;

Coordinate coordinate_of_place(const Mesh& mesh, std::size_t corner) {
  Vec2 least = mesh[corner].texture;
  for (const MeshVertex& vertex : mesh)
    if (same_place(vertex, mesh[corner])) least = std::min(least, vertex.texture);  // none is negative
  return {least[0], least[1]};
}

// The corners of a triangle, and the corners of the side that counts if an edge is the seam.
Coordinate coordinate_at(const Mesh& mesh, const SurfaceVertex& vertex, bool second_dominates) {
  const auto first = 3 * static_cast<std::size_t>(std::lround(vertex.triangle));
  const bool is_seam = vertex.weights[1] == 0 && is_on_border(vertex);
  Coordinate sum{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (vertex.weights[i] == 1) return coordinate_of_place(mesh, first + i);
    std::size_t from = first + i;
    if (is_seam)
      for (std::size_t k = 0; k < 3; ++k)
        if (const std::size_t other = (second_dominates ? 3U : 0U) + k; same_place(mesh[other], mesh[first + i]))
          from = other;
    for (std::size_t k = 0; k < 2; ++k)
      sum[k] += static_cast<double>(vertex.weights[i]) * static_cast<double>(mesh[from].texture[k]);
  }
  return sum;
}

bool near_texel_edge(const Coordinate& at) {
  return std::abs(at[0] * size - std::round(at[0] * size)) < 1e-4 ||
         std::abs(at[1] * size - std::round(at[1] * size)) < 1e-4;
}

void check_coordinate(Test& t, bool second_dominates) {
  const Mesh mesh = seam(second_dominates);
  for (const SurfaceVertex& vertex : drawn(t, mesh, GL_LINEAR_INPUTS_ARK, -1)) {
    const Coordinate at = coordinate_at(mesh, vertex, second_dominates);
    if (near_texel_edge(at)) continue;
    const Vector normal = reference::direction(flat(mesh, vertex, is_on_border(vertex), true));
    const Vector expected = flat(mesh, vertex, false, false) + scale * sampled(at, -1) * normal;
    const double off = reference::length(reference::vector_of(vertex.position) - expected);
    if (!t.expect(off < 1e-4, "weights " + as_text(vertex.weights[0]) + " " + as_text(vertex.weights[1]) + " " +
                                  as_text(vertex.weights[2]) + " of triangle " + as_text(vertex.triangle) +
                                  ": displaced by the height at another coordinate, off by " + as_text(off)))
      return;
  }
}

// Two corners of the triangle are at one place: T comes from the coordinates of both places.
void check_no_side(Test& t) {
  Mesh mesh = seam(false);
  mesh.resize(3);
  mesh[2].position = mesh[1].position;
  for (MeshVertex& vertex : mesh) vertex.normal = {0, 0, 1};
  mesh[1].texture = {0.81F, 0.2F};
  mesh[2].texture = {0.44F, 0.7F};
  for (const SurfaceVertex& vertex : drawn(t, mesh, GL_LINEAR_INPUTS_ARK, -1)) {
    if (vertex.weights[1] != 0 && vertex.weights[2] != 0) continue;
    const double s = 1 - static_cast<double>(vertex.weights[0]);
    const Coordinate from = {mesh[0].texture[0], mesh[0].texture[1]};
    const Coordinate to = {mesh[2].texture[0], mesh[2].texture[1]};  // the lesser of both
    const Coordinate at = {(1 - s) * from[0] + s * to[0], (1 - s) * from[1] + s * to[1]};
    if (near_texel_edge(at)) continue;
    const double expected = flat(mesh, vertex, false, false).z + scale * sampled(at, -1);
    if (!t.expect_near(vertex.position[2], expected, 1e-4, "a vertex on an edge without a dominant side")) return;
  }
}

// Two mirrored triangles with opposite normals: their sum is zero along the edge.
void check_zero(Test& t) {
  Mesh mesh = seam(false);
  const Vec4 places[] = {{-0.5F, 0, 0, 1}, {0.25F, 0.5F, 0, 1},  {0.5F, 0, 0, 1},
                         {0.5F, 0, 0, 1},  {0.25F, -0.5F, 0, 1}, {-0.5F, 0, 0, 1}};
  for (std::size_t i = 0; i < 6; ++i) {
    mesh[i].position = places[i];
    mesh[i].normal = {0, 0, i < 3 ? 1.0F : -1.0F};
  }
  int moved = 0;
  for (const SurfaceVertex& vertex : drawn(t, mesh, GL_LINEAR_INPUTS_ARK, 1)) {
    moved += std::abs(vertex.position[2]) > 0.2F ? 1 : 0;
    if (vertex.weights[1] == 0 &&
        !t.expect_near(vertex.position[2], 0, 1e-6, "nothing is displaced where the normal of the places is zero"))
      return;
  }
  t.expect(moved > 0, "the inside is displaced");
}

// A program with two texture coordinates: repeated draws with one of them must not affect draws with the other.
void check_other_attribute(Test& t) {
  Mesh mesh = seam(false);
  for (std::size_t i = 0; i < mesh.size(); ++i)
    mesh[i].colour = {0.17F * static_cast<float>(i) + 0.05F, 0.9F - 0.13F * static_cast<float>(i), 0, 1};
  gl.UseProgram(build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
                    "layout(location = 2) in vec3 weights; layout(location = 3) in vec4 first;\n"
                    "layout(location = 4) in vec2 second; layout(location = 6) in float triangle;\n"
                    "out vec3 weights_out; out float triangle_out; out vec4 colour;\n"
                    "void main() { gl_Position = position; weights_out = weights; triangle_out = triangle;\n"
                    "  colour = vec4(normal.xy, first.x, second.x); }\n",
          .captured = {"gl_Position", "weights_out", "triangle_out"}}));
  upload(mesh);
  set_displacement(-1);
  refine_uniformly(3);
  gl.ARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 6); };
  const auto positions_by = [&](GLuint attribute) {
    gl.ARKParameteriARK(GL_DISPLACEMENT_COORDINATE_ARK, static_cast<GLint>(attribute));
    std::vector<std::pair<float, Vec4>> positions;
    for (const CapturedVertex& vertex : capture(t, draw)) positions.emplace_back(vertex.triangle, vertex.position);
    std::sort(positions.begin(), positions.end());
    return positions;
  };
  const auto expected = positions_by(at_colour);
  for (int round = 0; round < 2; ++round) {
    t.expect(positions_by(at_texture) != expected, "the other attribute has other heights");
    for (int again = 0; again < 4; ++again) draw();
    t.expect(positions_by(at_colour) == expected, "the same vertices with the first attribute again, by bits");
    for (int again = 0; again < 4; ++again) draw();
  }
}

constexpr Area weld_case{"ark.weld.displacement."};

}  // namespace

Cases welded_displacement_cases() {
  Cases cases = {weld_case("normal", {"11.R.15-22", "11.R.15-23", "11.R.15-24", "11.R.15-30"},
                           "A height of 1 everywhere: vertices on the border of a triangle move along the normals of "
                           "the places, vertices inside along their own.",
                           "Each side's own normal; the mean without angles; the inside is welded too.",
                           [](Test& t) { check_normal(t, false); }),
                 weld_case("normal_of_thin_triangles", {"11.R.15-24", "11.R.15-25"},
                           "The same for triangles with small angles: their sum is short, but still has a direction.",
                           "Nothing is displaced where the sum is short.", [](Test& t) { check_normal(t, true); }),
                 weld_case("normal_of_octants", {"11.R.15-24", "11.R.15-25"},
                           "The same with sums whose components have all signs.",
                           "A sum of negative components counts as zero.", check_octants),
                 weld_case("other_attribute", {"11.R.15-26", "11.R.15-32", "11.R.13-1"},
                           "Repeat a draw with one DISPLACEMENT_COORDINATE_ARK, then with another.",
                           "The border has the heights of the earlier attribute.", check_other_attribute),
                 weld_case("no_side", {"11.R.15-29", "11.R.15-32"}, "Two corners of a triangle are at one place.",
                           "The height of one of its own ends.", check_no_side),
                 weld_case("zero", {"11.R.15-25", "11.R.15-33"}, "Opposite normals on both sides of an edge.",
                           "NaN; along one of the two normals.", check_zero)};
  for (const auto& [leaf, refinement] : {std::pair<const char*, GLenum>{"linear", GL_LINEAR_INPUTS_ARK},
                                         {"curved", GL_CURVED_PN_ARK},
                                         {"tagged", GL_SCALAR_TAGGED_PN_ARK}})
    cases.push_back(
        weld_case(std::string("position.") + leaf, {"11.R.15-21", "11.R.15-3", "11.R.15-28"},
                  "A seam of texture coordinates and normals has the same positions on both sides, by bits.",
                  "The sides separate.", [mode = refinement](Test& t) { check_position(t, mode); }));
  for (const bool second : {false, true})
    cases.push_back(weld_case(second ? "coordinate.second" : "coordinate.first",
                              {"11.R.15-26", "11.R.15-27", "11.R.15-31", "11.R.15-32", "11.R.15-34"},
                              "The height along a seam is that of the side with the lesser normals. At a corner it is "
                              "that of the least coordinate.",
                              "The first triangle's height; the mean; each side's own.",
                              [second](Test& t) { check_coordinate(t, second); }));
  return cases;
}

}  // namespace glark::conformance
