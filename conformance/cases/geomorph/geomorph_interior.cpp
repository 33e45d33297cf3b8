// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Geomorphing (11.R.14): the interior, coverage, continuity, and shared edges.
#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/support/geomorph.h"

namespace glark::conformance {
namespace {

using Depths3 = std::array<double, 3>;
constexpr GLuint pool = 8;

std::vector<MorphVertex> morphed(Test& t, const Mesh& mesh) {
  upload(mesh);
  morph_by_tags(pool);
  return capture_morph(t, mesh);
}

std::string text_of_depths(const Depths3& depths) {
  return "depths " + as_text(depths[0]) + " " + as_text(depths[1]) + " " + as_text(depths[2]);
}

// Twice the signed area of three places.
double area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (static_cast<double>(b[0]) - a[0]) * (static_cast<double>(c[1]) - a[1]) -
         (static_cast<double>(c[0]) - a[0]) * (static_cast<double>(b[1]) - a[1]);
}

std::set<Vec2> places_inside(const std::vector<MorphVertex>& vertices, const Mesh& mesh) {
  std::set<Vec2> inside;
  for (const MorphVertex& vertex : vertices) {
    bool is_inside = true;
    for (std::size_t i = 0; i < 3; ++i)
      is_inside = is_inside && area(mesh[i].texture, mesh[(i + 1) % 3].texture, vertex.place) > 0;
    if (is_inside) inside.insert(vertex.place);
  }
  return inside;
}

std::size_t inside_count(int depth) {
  const std::size_t steps = std::size_t{1} << depth;
  return (steps - 1) * (steps - 2) / 2;
}

// max(l, min(m, 3)), a whole number.
void check_interior_depth(Test& t) {
  gl.UseProgram(morph_program(t));
  const std::pair<Depths3, int> expected[] = {{{2, 2, 2}, 2}, {{3, 3, 3}, 3}, {{5, 5, 5}, 5}, {{0, 2, 2}, 2},
                                              {{3, 3, 0}, 3}, {{4, 1, 4}, 3}, {{2, 2, 4}, 2}, {{5, 4, 4}, 4},
                                              {{2, 4, 5}, 3}, {{2, 3, 1}, 2}};
  for (const auto& [depths, interior] : expected) {
    const Mesh mesh = morph_triangle(tags_for(depths));
    const std::size_t inside = places_inside(morphed(t, mesh), mesh).size();
    const std::string what =
        fmt::format("{}: {} vertices inside, of a depth of {}", text_of_depths(depths), inside, interior);
    if (std::min({depths[0], depths[1], depths[2]}) >= interior) {
      t.expect(inside == inside_count(interior), what);
      continue;
    }
    // Next to a shallower edge, several vertices may have moved to one place.
    t.expect(inside <= inside_count(interior) && inside > inside_count(interior - 1), what);
  }
}

void check_one_inside(Test& t) {
  gl.UseProgram(morph_program(t));
  for (const Depths3& depths : {Depths3{0.5, 0.5, 0.5},
                                {1, 1, 1},
                                {0, 0.25, 0.25},
                                {0.75, 1, 0.5},
                                {2, 1, 1},
                                {1.5, 1, 0.5},
                                {1.75, 0.875, 0.875}}) {
    const Mesh mesh = morph_triangle(tags_for(depths));
    t.expect_equal(places_inside(morphed(t, mesh), mesh).size(), 1U, text_of_depths(depths) + ": vertices inside");
  }
  t.expect_equal(morphed(t, morph_triangle({0, 0, 0})).size(), 3U, "depths of 0: vertices");
}

// s * A + (1 - s) / 3 * (A_0 + A_1 + A_2), s = min(q, 1).
void check_middle(Test& t) {
  gl.UseProgram(morph_program(t));
  for (const Depths3& depths :
       {Depths3{0.5, 0.5, 0.5}, {0.25, 0.5, 0.75}, {0, 0.125, 0.125}, {0.75, 1, 0.5}, {1, 1, 1}, {1.5, 1, 0.5}}) {
    const Mesh mesh = morph_triangle(tags_for(depths));
    const double s = std::min(std::max({depths[0], depths[1], depths[2]}), 1.0);
    const Vec2 centre = {4.0F / 3, 5.0F / 3};
    const Vec4 at_centre = bend_of(centre);
    int seen = 0;
    const auto vertices = morphed(t, mesh);
    for (const MorphVertex& vertex : vertices) {
      if (std::abs(vertex.place[0] - centre[0]) > 1e-4F || std::abs(vertex.place[1] - centre[1]) > 1e-4F) continue;
      ++seen;
      for (std::size_t i = 0; i < 4; ++i) {
        double mean = 0;
        for (const MeshVertex& corner : mesh) mean += static_cast<double>(bend_of(corner.texture)[i]) / 3;
        if (!t.expect_near(vertex.bend[i], s * at_centre[i] + (1 - s) * mean, 1e-3,
                           text_of_depths(depths) + ": an output of the vertex inside"))
          return;
      }
    }
    t.expect(seen >= 3, text_of_depths(depths) + ": a vertex in the centre");
  }
}

// Every refined triangle has the right orientation, and every inner edge has one triangle on either side: the triangle
// is covered once.
void expect_covered(Test& t, const Mesh& mesh, const std::vector<MorphVertex>& vertices, const std::string& what) {
  double sum = 0;
  std::map<std::pair<Vec2, Vec2>, int> edges;
  for (std::size_t i = 0; i + 2 < vertices.size(); i += 3) {
    const double one = area(vertices[i].place, vertices[i + 1].place, vertices[i + 2].place);
    if (!t.expect(one > -1e-6, what + ": no refined triangle has the wrong orientation")) return;
    sum += one;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 from = vertices[i + k].place;
      const Vec2 to = vertices[i + (k + 1) % 3].place;
      ++edges[{from, to}];
      --edges[{to, from}];
    }
  }
  t.expect_near(sum, area(mesh[0].texture, mesh[1].texture, mesh[2].texture), 1e-4, what + ": area");
  int open = 0;
  for (const auto& [edge, count] : edges) {
    if (count == 0) continue;
    bool is_outer = false;
    for (std::size_t i = 0; i < 3; ++i)
      is_outer = is_outer || (area(mesh[i].texture, mesh[(i + 1) % 3].texture, edge.first) == 0 &&
                              area(mesh[i].texture, mesh[(i + 1) % 3].texture, edge.second) == 0);
    open += is_outer && std::abs(count) == 1 ? 0 : 1;
  }
  t.expect_equal(open, 0, what + ": edges inside without a triangle on either side");
}

void check_coverage(Test& t) {
  gl.UseProgram(morph_program(t));
  for (const Depths3& depths : {Depths3{0.5, 0.5, 0.5},
                                {1.25, 1.25, 1.25},
                                {2.5, 2.5, 2.5},
                                {3.75, 3.75, 3.75},
                                {0, 2, 2},
                                {1.5, 2.25, 3},
                                {0.25, 4, 4},
                                {1, 3.5, 4.25},
                                {4.5, 3, 5.75},
                                {2, 2, 1.0 / 64}}) {
    const Mesh mesh = morph_triangle(tags_for(depths));
    expect_covered(t, mesh, morphed(t, mesh), text_of_depths(depths));
  }
}

// The outputs at a place in the triangle, interpolated in the refined triangle that covers it.
Vec4 surface_at(const std::vector<MorphVertex>& vertices, const Vec2& place) {
  Vec4 best = {NAN, NAN, NAN, NAN};
  double most = -1;
  for (std::size_t i = 0; i + 2 < vertices.size(); i += 3) {
    const MorphVertex* const v = &vertices[i];
    const double whole = area(v[0].place, v[1].place, v[2].place);
    if (whole < 1e-7) continue;
    const double w[3] = {area(place, v[1].place, v[2].place) / whole, area(v[0].place, place, v[2].place) / whole,
                         area(v[0].place, v[1].place, place) / whole};
    const double least = std::min({w[0], w[1], w[2]});
    if (least < -1e-5 || least < most) continue;
    most = least;
    for (std::size_t k = 0; k < 4; ++k)
      best[k] = static_cast<float>(w[0] * v[0].bend[k] + w[1] * v[1].bend[k] + w[2] * v[2].bend[k]);
  }
  return best;
}

std::vector<Vec4> samples_of(const std::vector<MorphVertex>& vertices, const Mesh& mesh) {
  std::vector<Vec4> samples;
  constexpr int n = 13;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const float u = static_cast<float>(i) / n;
      const float v = static_cast<float>(j) / n;
      const float w = 1 - u - v;
      samples.push_back(
          surface_at(vertices, {w * mesh[0].texture[0] + u * mesh[1].texture[0] + v * mesh[2].texture[0],
                                w * mesh[0].texture[1] + u * mesh[1].texture[1] + v * mesh[2].texture[1]}));
    }
  return samples;
}

double greatest_step(Test& t, const Depths3& before, const Depths3& after) {
  const Mesh mesh = morph_triangle(tags_for(before));
  const Mesh next = morph_triangle(tags_for(after));
  const auto a = samples_of(morphed(t, mesh), mesh);
  const auto b = samples_of(morphed(t, next), next);
  double greatest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      t.require(!std::isnan(a[i][k]) && !std::isnan(b[i][k]), "every place is covered");
      greatest = std::max(greatest, std::abs(static_cast<double>(a[i][k]) - b[i][k]));
    }
  return greatest;
}

// An implementation without a morph makes steps between two levels that are at least 8 times the greatest step allowed
// here.
void check_continuity(Test& t) {
  gl.UseProgram(morph_program(t));
  constexpr double one = 1.0 / 64;
  const auto steady = [&](const Depths3& before, const Depths3& after, double most) {
    const double step = greatest_step(t, before, after);
    t.expect(step <= most, text_of_depths(before) + " to " + text_of_depths(after) + ": the surface moves by " +
                               as_text(step) + ", not at most " + as_text(most));
  };
  // Outputs are quadratic, and at most 16: the chord of a whole edge is off by up to 4.
  for (const int level : {0, 1, 2}) {
    const double most = 0.5 * std::exp2(-2 * level);
    const double d = level;
    steady({d, d, d}, {d + one, d + one, d + one}, most);
    steady({d + 0.5, d + 0.5, d + 0.5}, {d + 0.5 + one, d + 0.5 + one, d + 0.5 + one}, most);
    steady({d + 1 - one, d + 1 - one, d + 1 - one}, {d + 1, d + 1, d + 1}, most);
  }
  steady({1, 2, 2}, {1 + one, 2, 2}, 0.125);
  steady({1, 2, 2}, {1, 2 + one, 2}, 0.125);
  steady({0, 2, 2}, {one, 2 + one, 2}, 0.5);
  steady({2, 2, 2}, {2 + one, 2, 2 + one}, 0.0625);
  steady({3, 2, 2 + one}, {3 + one, 2 + one, 2}, 0.0625);
  steady({3, 3, 3}, {3, 3, 3 + one}, 0.03125);
}

struct EdgeVertex {
  Vec4 position;
  Vec2 along;  // (1, 0) and (0, 1) at the ends
  Vec4 colour;
};
using EdgeValues = std::array<float, sizeof(EdgeVertex) / sizeof(float)>;

GLuint edge_program(Test& t) {
  const GLuint program = build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
                    "layout(location = 3) in vec4 vertex_colour; layout(location = 4) in vec2 along;\n"
                    "out vec2 along_out; out vec4 colour;\n"
                    "void main() { along_out = along; colour = sin(vertex_colour * 3.0 + vec4(normal, 1.0));\n"
                    "  vec4 p = position;\n"
                    "  gl_Position = p + vec4(0.1 * sin(3.0 * p.y), 0.1 * p.x * p.z, p.x * p.y, 0.25 * p.z + 0.3); }\n",
          .captured = {"gl_Position", "along_out", "colour"}});
  gl.UseProgram(program);
  return program;
}

MeshVertex random_vertex(Test& t) {
  MeshVertex vertex;
  for (std::size_t i = 0; i < 3; ++i) vertex.position[i] = t.random_float(-0.9F, 0.9F);
  vertex.normal = {t.random_float(-0.5F, 0.5F), t.random_float(-0.5F, 0.5F), t.random_float(0.3F, 1.2F)};
  for (float& value : vertex.colour) value = t.random_float(0, 1);
  vertex.tag = t.random_float(0, 4);
  return vertex;
}

std::set<EdgeValues> edge_of(Test& t, const Mesh& mesh) {
  upload(mesh);
  std::set<EdgeValues> found;
  for (EdgeValues values : capture_as<EdgeValues>(t, 60000, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); })) {
    if (values[4] + values[5] != 1.0F) continue;
    for (float& value : values) value += 0.0F;  // makes -0 equal to 0
    found.insert(values);
  }
  return found;
}

// Two triangles share an edge, with fractional tags, different third corners, and the ends in either order.
void check_shared(Test& t, GLenum refinement) {
  edge_program(t);
  morph_by_tags(5, refinement);
  for (int pair = 0; pair < 24; ++pair) {
    MeshVertex first = random_vertex(t);
    MeshVertex second = random_vertex(t);
    first.texture = {1, 0};
    second.texture = {0, 1};
    Mesh here = {first, second, random_vertex(t)};
    Mesh there = {second, first, random_vertex(t)};
    std::rotate(here.begin(), here.begin() + t.random_int(0, 2), here.end());
    std::rotate(there.begin(), there.begin() + t.random_int(0, 2), there.end());
    const auto a = edge_of(t, here);
    const auto b = edge_of(t, there);
    t.require(a.size() >= 2, "an edge has its ends");
    if (!t.expect(a == b, fmt::format("tags {} and {}: {} and {} vertices on both sides of an edge, the same by bits",
                                      as_text(first.tag), as_text(second.tag), a.size(), b.size())))
      return;
  }
}

constexpr Area morph_case{"ark.geomorph."};

}  // namespace

Cases geomorph_interior_cases() {
  Cases cases = {
      morph_case("inside.depth", {"11.R.14-16"}, "Whole depths, ten triples: count the vertices inside.",
                 "The least depth; the second least without the limit of 3; the greatest.", check_interior_depth),
      morph_case("inside.one", {"11.R.14-17"},
                 "Interiors of a depth of at most 1 have one vertex; depths of 0 have none.",
                 "No vertex below 1; one vertex for depths of 0.", check_one_inside),
      morph_case("inside.middle", {"11.R.14-18"}, "The outputs of the inner vertex, with six triples of depths.",
                 "s comes from the least depth; the stage's output in the centre from the beginning.", check_middle),
      morph_case("coverage", {"11.R.14-7"},
                 "Ten triples: the areas add up to the triangle's, and every edge has two sides.",
                 "A hole or a T-junction inside; triangles with the wrong orientation.", check_coverage),
      morph_case(
          "continuity", {"11.R.14-13"},
          "A step of 1/64 in one or all depths, at whole depths and between them, moves the surface only a little.",
          "The interior pops when a depth passes a whole number.", check_continuity)};
  for (const auto& [leaf, refinement] : {std::pair<const char*, GLenum>{"linear", GL_LINEAR_INPUTS_ARK},
                                         {"curved", GL_CURVED_PN_ARK},
                                         {"tagged", GL_SCALAR_TAGGED_PN_ARK},
                                         {"outputs", GL_LINEAR_OUTPUTS_ARK}})
    cases.push_back(morph_case(std::string("shared_edges.") + leaf, {"11.R.14-12"},
                               "24 pairs of triangles with fractional tags and a bent vertex stage.",
                               "The vertices of an edge depend on the third corner, or on the order of the ends.",
                               [mode = refinement](Test& t) { check_shared(t, mode); }));
  return cases;
}

}  // namespace glark::conformance
