// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Normals of displaced surfaces (11.R.7b), for planes whose heights are known by hand.
#include <cmath>
#include <tuple>

#include "conformance/cases/cases.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

constexpr GLint unit = 3;

void height_map(int width, int height, const std::function<float(int, int)>& value) {
  std::vector<float> texels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) texels.push_back(value(x, y));
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.ActiveTexture(GL_TEXTURE0 + unit);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R16F, width, height, 0, GL_RED, GL_FLOAT, texels.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.ActiveTexture(GL_TEXTURE0);
}

Mesh flat_triangle() {
  Mesh mesh = one_triangle();
  for (MeshVertex& vertex : mesh) {
    vertex.normal = {0, 0, 2};
    // Texture coordinates from 0.2 to 0.8, rotated against the position's axes.
    vertex.texture = {0.5F + 0.4F * vertex.position[1], 0.5F - 0.3F * vertex.position[0]};
  }
  return mesh;
}

// The normal of the plane displaced by half of a height with these slopes: dz/dx = 0.5 dh/dt (-0.3), dz/dy = 0.5 dh/ds
// 0.4.
reference::Vector flat_normal(double slope_s, double slope_t) {
  return 2.0 * reference::direction({0.5 * 0.3 * slope_t, -0.5 * 0.4 * slope_s, 1});
}

std::vector<SurfaceVertex> displaced_flat(Test& t, unsigned depth) {
  const Mesh mesh = flat_triangle();
  upload(mesh);
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, unit);
  gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.5F);
  refine_uniformly(depth);
  return capture_surface(t, mesh);
}

bool expect_flat_normal(Test& t, const SurfaceVertex& vertex, const reference::Vector& expected) {
  const double off = reference::length(reference::vector_of(vertex.normal) - expected);
  // R16F texels and the filter's 8 bits between texels give slopes with an error of some hundredths.
  return t.expect(off < 0.05, "the normal of a displaced plane is off by " + as_text(off));
}

// h is a ramp in s and another in t over a plane: the displaced surface is a plane, and its normal is known.
void check_normals(Test& t) {
  gl.UseProgram(surface_program(t));
  height_map(16, 16, [](int x, int y) { return 0.05F * static_cast<float>(x) - 0.02F * static_cast<float>(y); });
  for (const SurfaceVertex& vertex : displaced_flat(t, 3))
    if (!expect_flat_normal(t, vertex, flat_normal(0.05 * 16, -0.02 * 16))) return;
}

// Curved and flat triangles with bent normals. The height is the same everywhere.
void check_constant(Test& t, GLenum refinement) {
  gl.UseProgram(surface_program(t));
  height_map(16, 8, [](int /*x*/, int /*y*/) { return 0.75F; });
  const Mesh mesh = bent_mesh();
  upload(mesh);
  refine_uniformly(3, refinement);
  const auto plain = capture_surface(t, mesh);
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, unit);
  gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.5F);
  const auto displaced = capture_surface(t, mesh);
  t.require(plain.size() == displaced.size() && plain.size() > mesh.size(), "both are refined");
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const double moved =
        reference::length(reference::vector_of(displaced[i].position) - reference::vector_of(plain[i].position));
    if (!t.expect_near(moved, 0.375, 1e-3, "the way along the normal")) return;
    for (std::size_t k = 0; k < 3; ++k)
      if (!t.expect_near(displaced[i].normal[k], plain[i].normal[k], 1e-3, "the normal where h is constant")) return;
  }
}

constexpr int half_wave = 8;  // texels from the lowest to the highest height

// Waves along the longer side. Two texels from a turning point, a difference over one texel gives the slope of the
// wave. A step by the size of the shorter side spans several texels and gives another slope.
void check_waves(Test& t, int width, int height) {
  gl.UseProgram(surface_program(t));
  const bool is_wide = width > height;
  height_map(width, height, [is_wide](int x, int y) {
    const int place = (is_wide ? x : y) % (2 * half_wave);
    return 0.02F * static_cast<float>(std::min(place, 2 * half_wave - place));
  });
  int looked_at = 0;
  for (const SurfaceVertex& vertex : displaced_flat(t, 5)) {
    const int texels = is_wide ? width : height;
    // Texels have their values at their centres.
    const double place = std::fmod(static_cast<double>(vertex.texture[is_wide ? 0 : 1]) * texels - 0.5, 2 * half_wave);
    const double from_turn = std::fmod(place, half_wave);
    if (from_turn < 2 || from_turn > half_wave - 2) continue;
    const double slope = 0.02 * texels * (place < half_wave ? 1 : -1);
    ++looked_at;
    if (!expect_flat_normal(t, vertex, is_wide ? flat_normal(slope, 0) : flat_normal(0, slope))) return;
  }
  t.expect(looked_at > 100, "there are vertices between the turns");
}

void check_no_area(Test& t) {
  gl.UseProgram(surface_program(t));
  height_map(16, 16, [](int x, int y) { return 0.05F * static_cast<float>(x) - 0.02F * static_cast<float>(y); });
  Mesh mesh = flat_triangle();
  for (MeshVertex& vertex : mesh) vertex.position = {0.1F, 0.2F, 0.3F, 1};
  for (MeshVertex& vertex : mesh) vertex.normal = {0.5F, 1, -0.25F};
  upload(mesh);
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, unit);
  refine_uniformly(2);
  for (const SurfaceVertex& vertex : capture_surface(t, mesh))
    for (std::size_t i = 0; i < 3; ++i)
      if (!t.expect_near(vertex.normal[i], mesh[0].normal[i], 1e-6, "without an area the normal stays")) return;
}

// Fixed function without any enabled texture: the normals shift the triangle sideways.
void check_untextured(Test& t) {
  height_map(4, 4, [](int, int) { return 1.0F; });
  const auto draw = [](float shift) {
    gl.Begin(GL_TRIANGLES);
    gl.Normal3f(1, 0, 0);
    gl.TexCoord2f(0.4F, 0.6F);
    gl.Vertex2f(-0.75F + shift, -0.5F);
    gl.Vertex2f(0.25F + shift, -0.75F);
    gl.Vertex2f(-0.25F + shift, 0.5F);
    gl.End();
  };
  const Picture expected = picture_of([&] { draw(0.5F); });
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, unit);
  gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.5F);
  for (const GLuint level : {0U, 2U}) {
    refine_uniformly(level);
    t.expect_same_picture(picture_of([&] { draw(0); }), expected, "a triangle that is displaced sideways", 2, 24);
  }
}

}  // namespace

Cases displaced_normals_cases() {
  Cases cases;
  cases.push_back({.name = "ark.displacement.normal.ramp",
                   .clauses = {"11.R.7b-11"},
                   .plan = "A plane displaced by a ramp is a plane: its normal is known by hand.",
                   .wrong = "The normal stays, or slopes have the wrong sign or scale.",
                   .check = check_normals});
  for (const auto& [leaf, width, height] :
       {std::tuple<const char*, int, int>{"wide", 64, 8}, {"high", 8, 64}, {"square", 64, 64}})
    cases.push_back({.name = std::string("ark.displacement.normal.waves_") + leaf,
                     .clauses = {"11.R.7b-11", "11.R.7b-12"},
                     .plan = "A plane with waves of 16 texels: between its turns the normal is known by hand.",
                     .wrong = "Slopes over more than a texel, or over a texel of the other side.",
                     .check = [width = width, height = height](Test& t) { check_waves(t, width, height); }});
  cases.push_back({.name = "ark.displacement.untextured",
                   .clauses = {"11.R.7b-7"},
                   .plan = "Displace a fixed-function triangle while no texture is enabled.",
                   .wrong = "Nothing is displaced, as if there were no texture coordinates.",
                   .apis = compat_only,
                   .check = check_untextured});
  for (const auto& [leaf, refinement] : {std::pair<const char*, GLenum>{"linear", GL_LINEAR_INPUTS_ARK},
                                         {"curved", GL_CURVED_PN_ARK},
                                         {"tagged", GL_SCALAR_TAGGED_PN_ARK}})
    cases.push_back({.name = std::string("ark.displacement.normal.constant_") + leaf,
                     .clauses = {"11.R.7b-13"},
                     .plan = "A height that is the same everywhere: positions move, normals stay.",
                     .wrong = "The geometric normal of the displaced surface instead of N.",
                     .check = [mode = refinement](Test& t) { check_constant(t, mode); }});
  cases.push_back({.name = "ark.displacement.normal.no_area",
                   .clauses = {"11.R.7b-6"},
                   .plan = "All corners are at one place.",
                   .wrong = "0 / 0.",
                   .check = check_no_area});
  return cases;
}

}  // namespace glark::conformance
