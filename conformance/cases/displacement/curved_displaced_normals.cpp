// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Positions and normals of displaced curved triangles (11.R.7b) at all vertices, against the formulas. Derivatives of the
// surface are differences in double precision. The texture is a ramp of single texels, whose slope over one texel is
// the same everywhere.
#include <fmt/core.h>

#include <cmath>

#include "conformance/cases/cases.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

using reference::Vector;

constexpr GLint ramp_unit = 3;
constexpr int ramp_size = 8;                                 // texels in each direction
constexpr float ramp_by_s = 0.0625F, ramp_by_t = -0.03125F;  // from texel to texel
constexpr double ramp_scale = 0.5, ramp_bias = 0.125;

void bind_ramp(std::size_t channel) {
  std::vector<float> texels;
  for (int y = 0; y < ramp_size; ++y)
    for (int x = 0; x < ramp_size; ++x)
      for (std::size_t i = 0; i < 4; ++i)
        texels.push_back(i == channel ? ramp_by_s * static_cast<float>(x) + ramp_by_t * static_cast<float>(y) : 0.75F);
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.ActiveTexture(GL_TEXTURE0 + ramp_unit);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, ramp_size, ramp_size, 0, GL_RGBA, GL_FLOAT, texels.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.ActiveTexture(GL_TEXTURE0);
}

double height_at(const Vec2& coordinate) {
  return ramp_by_s * std::floor(ramp_size * static_cast<double>(coordinate[0])) +
         ramp_by_t * std::floor(ramp_size * static_cast<double>(coordinate[1]));
}

// Rounding may choose another texel there.
bool is_between_texels(const Vec2& coordinate) {
  for (const float part : coordinate) {
    const double place = ramp_size * static_cast<double>(part);
    if (std::abs(place - std::round(place)) < 0.01) return true;
  }
  return false;
}

using SurfaceAt = std::function<reference::Surface(const reference::Corners&, const Vec3&)>;

Vec3 weights_at(double u, double v) {
  return {static_cast<float>(1 - u - v), static_cast<float>(u), static_cast<float>(v)};
}

struct Displaced {
  Vector position;
  Vector normal;
};

// (11.R.7) and the N' of 11.R.7b.
Displaced displaced(const SurfaceAt& surface_at, const reference::Corners& corners, const std::array<Vec2, 3>& texture,
                    const SurfaceVertex& vertex) {
  const double height = ramp_scale * height_at(vertex.texture) + ramp_bias;
  const auto raised = [&](double u, double v) {
    const reference::Surface surface = surface_at(corners, weights_at(u, v));
    return surface.position + height * reference::direction(surface.normal);
  };
  constexpr double step = 1.0 / 1024;
  const double u = vertex.weights[1];
  const double v = vertex.weights[2];
  const Vector along_u = (raised(u + step, v) - raised(u - step, v)) / (2 * step);
  const Vector along_v = (raised(u, v + step) - raised(u, v - step)) / (2 * step);
  const Vector normal = surface_at(corners, vertex.weights).normal;
  const Vector n = reference::direction(normal);
  const auto slope = [&](std::size_t k) {
    const double ds = static_cast<double>(texture[k][0]) - texture[0][0];
    const double dt = static_cast<double>(texture[k][1]) - texture[0][1];
    return ramp_scale * ramp_size * (ramp_by_s * ds + ramp_by_t * dt);
  };
  // The gradient g lies in the surface: g . along_u = slope(1), g . along_v = slope(2).
  const double area = reference::dot(n, reference::cross(along_u, along_v));
  const Vector gradient = (slope(1) * reference::cross(along_v, n) + slope(2) * reference::cross(n, along_u)) / area;
  return {raised(u, v), reference::length(normal) * reference::direction(n - gradient)};
}

struct DisplacedKind {
  const char* leaf;
  GLenum refinement;
  reference::Surface (*surface)(const reference::Corners&, const Vec3&);
};

reference::Surface linear(const reference::Corners& corners, const Vec3& weights) {
  reference::Surface surface;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto weight = static_cast<double>(weights[i]);
    surface.position = surface.position + weight * reference::vector_of(corners[i].position);
    surface.normal = surface.normal + weight * reference::vector_of(corners[i].normal);
  }
  return surface;
}

constexpr DisplacedKind displaced_kinds[] = {
    {"linear", GL_LINEAR_INPUTS_ARK, linear},
    {"curved", GL_CURVED_PN_ARK, reference::curved_pn},
    {"tagged", GL_SCALAR_TAGGED_PN_ARK, reference::scalar_tagged_pn},
    {"phong", GL_PHONG_ARK,
     [](const reference::Corners& corners, const Vec3& weights) { return reference::phong(corners, weights, 0.75); }}};

void expect_displaced(Test& t, const DisplacedKind& kind, const Mesh& mesh, const ShapeTags& tags,
                      const std::string& what) {
  std::size_t looked_at = 0;
  for (const SurfaceVertex& vertex : capture_surface(t, mesh)) {
    if (is_between_texels(vertex.texture)) continue;
    ++looked_at;
    const auto first = 3 * static_cast<std::size_t>(std::lround(vertex.triangle));
    t.require(first + 2 < mesh.size(), "every refined vertex belongs to a coarse triangle");
    const Displaced expected =
        displaced(kind.surface, corners_of(mesh, first / 3, tags),
                  {mesh[first].texture, mesh[first + 1].texture, mesh[first + 2].texture}, vertex);
    const double off = reference::length(reference::vector_of(vertex.position) - expected.position);
    const double turned = reference::length(reference::vector_of(vertex.normal) - expected.normal);
    const std::string place =
        fmt::format("{}, at {} {} {}", what, vertex.weights[0], vertex.weights[1], vertex.weights[2]);
    if (!t.expect(off < 1e-4, fmt::format("{}: the position is off by {}", place, off)) ||
        !t.expect(turned < 2e-3 * (1 + reference::length(expected.normal)),
                  fmt::format("{}: the normal is off by {}", place, turned)))
      return;
  }
  t.expect(looked_at > 40, what + ": there are vertices inside texels");
}

// Corners in each order, with normals that differ in all of them.
void check_formula(Test& t, const DisplacedKind& kind) {
  gl.UseProgram(surface_program(t));
  ShapeTags tags;
  tags.discontinuities.assign(6, Vec4{0, 0, 0, 1});
  tags.scalars.assign(6, Vec3{0.5F, 0.25F, 0});
  const Vec2 coordinates[] = {{0.13F, 0.17F}, {0.83F, 0.21F}, {0.37F, 0.79F}};
  for (std::size_t turn = 0; turn < 3; ++turn) {
    Mesh mesh = bent_mesh();
    for (std::size_t i = 0; i < mesh.size(); ++i) mesh[i].texture = coordinates[(i + turn) % 3];
    for (std::size_t i = 0; i < 3; ++i) {
      if (turn > 0) std::swap(mesh[i].normal, mesh[3 + i].normal);
      mesh[i].normal[turn] += 0.2F;
    }
    if (kind.refinement == GL_SCALAR_TAGGED_PN_ARK && turn == 1) tags.discontinuities[0] = {0.2F, -0.1F, 0.15F, 2};
    upload(mesh);
    upload_shape_tags(tags);
    bind_ramp(turn);
    refine_uniformly(3, kind.refinement);
    gl.ARKParameterfARK(GL_PHONG_SHAPE_ARK, 0.75F);
    gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, ramp_unit);
    gl.ARKParameteriARK(GL_DISPLACEMENT_CHANNEL_ARK, static_cast<GLint>(std::array{GL_RED, GL_GREEN, GL_BLUE}[turn]));
    gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, static_cast<float>(ramp_scale));
    gl.ARKParameterfARK(GL_DISPLACEMENT_BIAS_ARK, static_cast<float>(ramp_bias));
    expect_displaced(t, kind, mesh, tags, fmt::format("turn {}", turn));
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases curved_displaced_normals_cases() {
  Cases cases;
  for (const DisplacedKind& kind : displaced_kinds)
    cases.push_back({.name = std::string("ark.displacement.formula.") + kind.leaf,
                     .clauses = {"11.R.7b-1", "11.R.7b-11", "11.R.7b-12"},
                     .plan = "Displace bent triangles by a ramp, and compare all positions and normals with (11.R.7) "
                             "and the turned normal.",
                     .wrong = "The derivative by one weight has a wrong control point; slopes of the flat triangle.",
                     .check = [&kind](Test& t) { check_formula(t, kind); }});
  return cases;
}

}  // namespace glark::conformance
