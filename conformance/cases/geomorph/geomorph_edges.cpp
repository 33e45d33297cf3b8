// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Geomorphing (11.R.14): the depths of edges in 64ths, and the vertices on edges.
#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/support/counted.h"
#include "conformance/support/geomorph.h"

namespace glark::conformance {
namespace {

using Depths3 = std::array<double, 3>;
constexpr GLuint pool = 6;

double rounded_tag(float tag) { return std::floor(64 * static_cast<double>(tag) + 0.5) / 64; }

double depth_between(float a, float b) { return std::floor(64 * ((rounded_tag(a) + rounded_tag(b)) / 2)) / 64; }

Depths3 depths_with(const std::array<float, 3>& tags) {
  return {depth_between(tags[0], tags[1]), depth_between(tags[1], tags[2]), depth_between(tags[2], tags[0])};
}

std::string text_of_tags(const std::array<float, 3>& tags) {
  return "tags " + as_text(tags[0]) + " " + as_text(tags[1]) + " " + as_text(tags[2]);
}

void expect_tags(Test& t, const std::array<float, 3>& tags, const Depths3& depths, GLenum refinement) {
  const Mesh mesh = morph_triangle(tags);
  upload(mesh);
  morph_by_tags(pool, refinement);
  expect_edges(t, capture_morph(t, mesh), mesh, depths, text_of_tags(tags));
}

constexpr float one = 1.0F / 64;

// Tags that are multiples of 1/64. No two edges are alike.
void check_formula(Test& t, GLenum refinement) {
  gl.UseProgram(morph_program(t));
  const std::array<float, 3> tags[] = {
      {0.5F, 1.25F, 2.75F},    {3 * one, 20 * one, 5 * one}, {1 + one, 2 - one, 3},     {0, 63 * one, 3.5F},
      {2.25F, 0, 4 - 2 * one}, {4 - one, 4, 3 + 2 * one},    {1.5F, 1.5F, 1 + 62 * one}};
  for (const auto& each : tags) expect_tags(t, each, depths_with(each), refinement);
}

void check_depth_rounding(Test& t) {
  gl.UseProgram(morph_program(t));
  // (1 + 1/64 + 2) / 2 = 1 + 32/64 + 1/128 is rounded down to 1 + 32/64, and so on.
  expect_tags(t, {1 + one, 2, 1}, {1.5, 1.5, 1}, GL_LINEAR_INPUTS_ARK);
  expect_tags(t, {one, 0, 2 * one}, {0, one, one}, GL_LINEAR_INPUTS_ARK);
  expect_tags(t, {2 + one, 2, 2 + 3 * one}, {2, 2 + one, 2 + 2 * one}, GL_LINEAR_INPUTS_ARK);
}

void check_tag_rounding(Test& t) {
  gl.UseProgram(morph_program(t));
  expect_tags(t, {1 + 0.4F * one, 1, 2 + 0.6F * one}, {1, 1.5, 1.5}, GL_LINEAR_INPUTS_ARK);
  expect_tags(t, {1 + 1.6F * one, 1, 3 - 1.6F * one}, {1 + one, 2 - one, 2}, GL_LINEAR_INPUTS_ARK);
  expect_tags(t, {-3.5F, 0, 0.3F * one}, {0, 0, 0}, GL_LINEAR_INPUTS_ARK);
}

void check_clamped_tags(Test& t) {
  gl.UseProgram(morph_program(t));
  const Mesh mesh = morph_triangle({7.5F, 2.5F, -1.25F});
  upload(mesh);
  morph_by_tags(3);
  expect_edges(t, capture_morph(t, mesh), mesh, {2.75, 1.25, 1.5}, "tags beyond 0 and the pool's level of 3");
}

// With whole depths, the outputs are those of GEOMORPH_ARK FALSE, and the vertices are those of 11.R.5.
void check_whole(Test& t) {
  gl.UseProgram(morph_program(t));
  for (const Depths3& depths : {Depths3{1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {1, 2, 2}, {2, 3, 4}, {0, 1, 1}, {4, 4, 2}}) {
    const Mesh mesh = morph_triangle(tags_for(depths));
    upload(mesh);
    morph_by_tags(pool);
    const auto morphing = capture_morph(t, mesh);
    expect_edges(t, morphing, mesh, depths, "whole depths");
    gl.ARKParameteriARK(GL_GEOMORPH_ARK, GL_FALSE);
    std::set<PlaceAndBend> found;
    const auto joined = [](const MorphVertex& v) {
      return PlaceAndBend{v.place[0], v.place[1], v.bend[0], v.bend[1], v.bend[2], v.bend[3]};
    };
    for (const MorphVertex& vertex : morphing) found.insert(joined(vertex));
    for (const MorphVertex& vertex : capture_morph(t, mesh))
      if (!t.expect(found.contains(joined(vertex)), "a pattern vertex of 11.R.5 is among those of depths " +
                                                        as_text(depths[0]) + " " + as_text(depths[1]) + " " +
                                                        as_text(depths[2]) + ", with the same outputs"))
        break;
  }
}

// GEOMORPH_ARK does not matter here; compares by bits.
void check_uniform(Test& t) {
  gl.UseProgram(morph_program(t));
  const Mesh mesh = morph_triangle({0.25F, 1.5F, 2.75F});
  upload(mesh);
  for (const GLuint level : {0U, 1U, 3U}) {
    refine_uniformly(level);
    gl.ARKParameteriARK(GL_GEOMORPH_ARK, GL_FALSE);
    const auto plain = capture_morph(t, mesh);
    gl.ARKParameteriARK(GL_GEOMORPH_ARK, GL_TRUE);
    const auto morphing = capture_morph(t, mesh);
    t.expect_equal(plain.size(), std::size_t{3} << (2 * level), "vertices of a uniform depth");
    t.expect(plain.size() == morphing.size() &&
                 std::memcmp(plain.data(), morphing.data(), plain.size() * sizeof(MorphVertex)) == 0,
             "GEOMORPH_ARK changes no bit of UNIFORM_DEPTH_ARK");
  }
}

// Draws to the screen too: an implementation may refine in another way than with transform feedback.
void expect_current_tag(Test& t, const Mesh& mesh, float tag) {
  const std::string what = "a current tag of " + as_text(tag);
  const double depth = rounded_tag(tag);
  for (int again = 0; again < 3; ++again) {
    expect_edges(t, capture_morph(t, mesh), mesh, {depth, depth, depth}, what);
    // Each edge of the pattern is divided by 2^ceil(depth), and at least as many corners have two triangles fewer. With
    // one vertex inside, there are two triangles more.
    const GLuint least = 3 * (1U << static_cast<unsigned>(std::ceil(depth))) - 2;
    const GLuint drawn = count_generated([] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
    t.expect(drawn >= least, fmt::format("{}: {} triangles, at least {}", what, drawn, least));
    if (depth <= 1) t.expect_equal(drawn, depth > 0 ? 6U : 1U, what + ": triangles");
  }
}

// The attribute of the tags gets its value by commands of several types.
void check_current_tag(Test& t) {
  gl.UseProgram(morph_program(t));
  const Mesh mesh = morph_triangle({0, 0, 0});
  upload(mesh, false);
  morph_by_tags(pool);
  GLint attribute = 0;
  gl.GetIntegerv(GL_DEPTH_TAG_ATTRIBUTE_ARK, &attribute);
  const auto index = static_cast<GLuint>(attribute);
  for (const float tag : {1.25F, 2.25F, 2.0F, 2.75F, 0.5F, one, 0.0F, 1.0F, 0.4F * one, 1 - one, 0.75F, 0.25F}) {
    gl.VertexAttrib1f(index, tag);
    expect_current_tag(t, mesh, tag);
  }
  if (t.is_gles()) return;
  gl.VertexAttrib1d(index, 0.625);
  expect_current_tag(t, mesh, 0.625F);
  gl.VertexAttrib4Nub(index, 51, 255, 255, 255);
  expect_current_tag(t, mesh, 51.0F / 255);
  gl.DepthTag1i(1);
  expect_current_tag(t, mesh, 1);
  gl.VertexAttribP1ui(index, GL_UNSIGNED_INT_2_10_10_10_REV, GL_TRUE, 341);
  expect_current_tag(t, mesh, 341.0F / 1023);
}

void check_off(Test& t) {
  gl.UseProgram(morph_program(t));
  const Mesh mesh = morph_triangle({0.75F, 1.25F, 2.75F});  // 1, 1, 3
  upload(mesh);
  morph_by_tags(pool);
  gl.ARKParameteriARK(GL_GEOMORPH_ARK, GL_FALSE);
  expect_edges(t, capture_morph(t, mesh), mesh, {1, 2, 2}, "without GEOMORPH_ARK");
}

void check_interior_ignored(Test& t) {
  gl.UseProgram(morph_program(t));
  for (const Depths3& depths : {Depths3{1.5, 2.25, 3}, {2, 4, 4}, {0, 0.5, 0.5}, {3.25, 5, 4}}) {
    const Mesh mesh = morph_triangle(tags_for(depths));
    upload(mesh);
    morph_by_tags(8);
    gl.ARKParameteriARK(GL_PATTERN_INTERIOR_ARK, GL_MINIMUM_INTERIOR_ARK);
    const auto minimum = capture_morph(t, mesh);
    gl.ARKParameteriARK(GL_PATTERN_INTERIOR_ARK, GL_SMOOTH_INTERIOR_ARK);
    const auto smooth = capture_morph(t, mesh);
    const auto sorted = [](const std::vector<MorphVertex>& vertices) {
      std::multiset<std::array<float, sizeof(MorphVertex) / sizeof(float)>> all;
      for (const MorphVertex& vertex : vertices) {
        std::array<float, sizeof(MorphVertex) / sizeof(float)> values{};
        std::memcpy(values.data(), &vertex, sizeof(vertex));
        all.insert(values);
      }
      return all;
    };
    t.expect(sorted(minimum) == sorted(smooth), "PATTERN_INTERIOR_ARK changes nothing");
  }
}

// gl_Position follows (11.R.8) too: it lies between the points of the curve at k - 1, k and k + 1.
void check_curve(Test& t) {
  gl.UseProgram(morph_program(t));
  const std::array<float, 3> tags = {1.5F, 2.25F, 3};
  const Mesh mesh = morph_triangle(tags);
  upload(mesh);
  morph_by_tags(pool, GL_CURVED_PN_ARK);
  const reference::Corners corners = corners_of(mesh, 0);
  const double depth = depth_between(tags[0], tags[1]);
  const int steps = 1 << static_cast<int>(std::ceil(depth));
  const double s = depth - std::ceil(depth) + 1;
  const auto curve = [&](int k) {
    const float along = static_cast<float>(k) / static_cast<float>(steps);
    return reference::curved_pn(corners, {1 - along, along, 0}).position;
  };
  int seen = 0;
  for (const MorphVertex& vertex : capture_morph(t, mesh)) {
    if (vertex.place[0] != 3 * vertex.place[1]) continue;
    ++seen;
    const int k = static_cast<int>(std::lround(static_cast<float>(steps) * vertex.place[1]));
    const reference::Vector expected =
        k % 2 == 0 ? curve(k) : ((1 - s) / 2) * curve(k - 1) + ((1 - s) / 2) * curve(k + 1) + s * curve(k);
    if (!t.expect(reference::length(reference::vector_of(vertex.position) - expected) < 3e-6,
                  fmt::format("step {} of a curved edge lies where (11.R.8) puts it", k)))
      return;
  }
  t.expect(seen > steps, "the edge has vertices");
}

// Outputs that are already linear along an edge: those of (11.R.1).
void check_linear_outputs(Test& t) {
  gl.UseProgram(morph_program(t));
  const std::array<float, 3> tags = {0.5F, 1.75F, 3};
  const Mesh mesh = morph_triangle(tags);
  upload(mesh);
  morph_by_tags(pool, GL_LINEAR_OUTPUTS_ARK);
  const auto vertices = capture_morph(t, mesh);
  const Depths3 depths = depths_with(tags);
  for (std::size_t edge = 0; edge < 3; ++edge) {
    const Vec2 from = mesh[edge].texture;
    const Vec2 to = mesh[(edge + 1) % 3].texture;
    const auto found = found_on_edge(vertices, from, to);
    t.expect_equal(found.size(), (std::size_t{1} << static_cast<int>(std::ceil(depths[edge]))) + 1,
                   fmt::format("vertices on edge {}", edge));
    const Vec4 a = bend_of(from);
    const Vec4 b = bend_of(to);
    for (const PlaceAndBend& vertex : found) {
      const std::size_t axis = from[0] != to[0] ? 0 : 1;
      const double along = (vertex[axis] - from[axis]) / static_cast<double>(to[axis] - from[axis]);
      for (std::size_t i = 0; i < 4; ++i)
        if (!t.expect_near(vertex[2 + i], (1 - along) * a[i] + along * b[i], 1e-6, "a refined output")) return;
    }
  }
}

struct FlatVertex {
  float position[4];
  float value;
  GLint number;
};

void check_flat(Test& t) {
  gl.UseProgram(build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 4) in vec2 place;\n"
                    "flat out float value; flat out int number; out vec4 colour;\n"
                    "void main() { value = place.x * place.x + place.y; number = int(16.0 * place.y * place.y) - 7;\n"
                    "  colour = vec4(1.0); gl_Position = position; }\n",
          .captured = {"gl_Position", "value", "number"}}));
  const Mesh mesh = morph_triangle({0.5F, 1.75F, 3});
  upload(mesh);
  morph_by_tags(pool);
  const auto vertices = capture_as<FlatVertex>(t, 60000, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
  t.require(vertices.size() > 9, "the triangle is refined");
  // Corner 2 is the provoking one: (1, 4).
  for (const FlatVertex& vertex : vertices) {
    if (!t.expect_equal(vertex.value, 5.0F, "a flat output has the value of the provoking corner")) return;
    if (!t.expect_equal(vertex.number, 249, "an integer output has the value of the provoking corner")) return;
  }
}

// Edges that meet in the centroid of a quadrilateral have the mean of the outer depths, rounded down to 1/64.
void check_centroid(Test& t) {
  gl.UseProgram(morph_program(t));
  const float tags[4] = {1, 1 + 10 * one, 2 + 4 * one, 2.5F};
  const Vec2 places[4] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  Mesh mesh(4);
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    mesh[i].position = {places[i][0] * 0.25F - 0.5F, places[i][1] * 0.25F - 0.5F, 0, 1};
    mesh[i].texture = places[i];
    mesh[i].tag = tags[i];
    sum += depth_between(tags[i], tags[(i + 1) % 4]);
  }
  const double face = std::floor(64 * sum / 4) / 64;
  upload(mesh);
  morph_by_tags(pool);
  gl.ARKParameteriARK(GL_POLYGON_SPLIT_ARK, GL_POLYGON_CENTROID_ARK);
  const auto vertices = capture_morph(t, mesh, GL_QUADS);
  for (std::size_t i = 0; i < 4; ++i) {
    expect_edge(t, vertices, places[i], places[(i + 1) % 4], depth_between(tags[i], tags[(i + 1) % 4]), "outer edge");
    expect_edge(t, vertices, places[i], {2, 2}, face, "the edge to the centroid");
  }
}

constexpr Area morph_case{"ark.geomorph."};

}  // namespace

Cases geomorph_edges_cases() {
  Cases cases = {
      morph_case("edge.rounded_down", {"11.R.14-3"}, "Sums of tags that are odd multiples of 1/64.",
                 "Rounded to nearest, up, or not at all.", check_depth_rounding),
      morph_case("tag.rounded", {"11.R.14-3", "10.R.1-3"}, "Tags between two multiples of 1/64 are rounded.",
                 "Truncated; not rounded; rounded to whole numbers.", check_tag_rounding),
      morph_case("tag.clamped", {"11.R.14-3", "10.R.1-3"}, "Tags below 0 and above the pool's level.",
                 "Depths that the pool does not have.", check_clamped_tags),
      morph_case("whole", {"11.R.14-13", "11.R.14-19", "11.R.14-11"},
                 "With whole depths, every vertex of the pattern without GEOMORPH_ARK is there, with the same outputs.",
                 "Odd vertices stay on the coarser level; another interior.", check_whole),
      morph_case("uniform", {"11.R.14-1"}, "UNIFORM_DEPTH_ARK has the same bits with GEOMORPH_ARK.",
                 "An additional vertex inside; fractions of tags.", check_uniform),
      morph_case("off", {"11.R.14-1"}, "Without GEOMORPH_ARK, fractional tags are rounded to whole ones.",
                 "Always morphed.", check_off),
      morph_case("current_tag", {"11.R.14-1", "11.R.14-3", "11.R.14-5", "11.R.14-17"},
                 "Fractional current depth tags, on the screen and with transform feedback.",
                 "A current tag, which all triangles of a draw share, is rounded, perhaps only below 1.",
                 check_current_tag),
      morph_case("interior_ignored", {"11.R.14-8"}, "Both interiors give the same triangles.",
                 "The smooth interior has more.", check_interior_ignored),
      morph_case("edge.position", {"11.R.14-10", "11.R.14-2"}, "gl_Position on a curved edge of depth 1.875.",
                 "The position is not morphed, only the outputs that depend on it.", check_curve),
      morph_case("linear_outputs", {"11.R.14-14"}, "With LINEAR_OUTPUTS_ARK outputs are linear along an edge.",
                 "The outputs of a vertex stage that ran inside the edge.", check_linear_outputs),
      morph_case("flat", {"11.R.14-14"}, "A flat output and an integer have the provoking corner's values.",
                 "Means of the values.", check_flat)};
  for (const auto& [leaf, refinement] : {std::pair<const char*, GLenum>{"linear", GL_LINEAR_INPUTS_ARK},
                                         {"curved", GL_CURVED_PN_ARK},
                                         {"tagged", GL_SCALAR_TAGGED_PN_ARK}})
    cases.push_back(morph_case(std::string("edge.formula.") + leaf,
                               {"11.R.14-1", "11.R.14-5", "11.R.14-9", "11.R.14-10", "11.R.14-11"},
                               "Seven triples of tags in 64ths: compare the number of vertices on each edge and their "
                               "outputs by bits. Even vertices have the stage's output.",
                               "The blend is reversed; s of another edge; depths rounded to whole ones.",
                               [mode = refinement](Test& t) { check_formula(t, mode); }));
  cases.push_back(morph_case("centroid", {"11.R.14-3", "11.R.4-16"}, "A quadrilateral split at its centroid.",
                             "The face depth is whole, or rounded to the nearest.", check_centroid));
  cases.back().apis = compat_only;
  return cases;
}

}  // namespace glark::conformance
