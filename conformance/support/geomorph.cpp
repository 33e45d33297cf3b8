// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/support/geomorph.h"

#include <fmt/core.h>
#include <cmath>

namespace glark::conformance {
namespace {

Vec2 between(const Vec2& from, const Vec2& to, float along) {
  return {from[0] + along * (to[0] - from[0]), from[1] + along * (to[1] - from[1])};
}

PlaceAndBend joined(const Vec2& place, const Vec4& bend) {
  return {place[0] + 0.0F, place[1] + 0.0F, bend[0] + 0.0F, bend[1] + 0.0F, bend[2] + 0.0F, bend[3] + 0.0F};
}

bool lies_on(const Vec2& place, const Vec2& from, const Vec2& to) {
  const double x = to[0] - from[0];
  const double y = to[1] - from[1];
  const double across = x * (place[1] - from[1]) - y * (place[0] - from[0]);
  const double along = x * (place[0] - from[0]) + y * (place[1] - from[1]);
  return across == 0 && along >= 0 && along <= x * x + y * y;
}

}  // namespace

GLuint morph_program(Test& t) {
  return build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
                    "layout(location = 4) in vec2 place; out vec2 place_out; out vec4 bend; out vec4 colour;\n"
                    "void main() { float x = place.x; float y = place.y; place_out = place;\n"
                    "  bend = vec4(x * x - 0.25 * y * y, x * y, 0.5 * y * y + x, x * x + x * y);\n"
                    "  colour = abs(vec4(normal, 1.0)); gl_Position = position; }\n",
          .captured = {"gl_Position", "place_out", "bend"}});
}

Vec4 bend_of(const Vec2& place) {
  const float x = place[0];
  const float y = place[1];
  return {x * x - 0.25F * y * y, x * y, 0.5F * y * y + x, x * x + x * y};
}

Mesh morph_triangle(const std::array<float, 3>& tags) {
  Mesh mesh = one_triangle(tags);
  const Vec2 places[3] = {{0, 0}, {3, 1}, {1, 4}};
  const Vec3 normals[3] = {{-0.3F, -0.1F, 1}, {0.4F, 0.2F, 0.8F}, {0.1F, 0.5F, 1.5F}};
  for (std::size_t i = 0; i < 3; ++i) {
    mesh[i].texture = places[i];
    mesh[i].normal = normals[i];
  }
  return mesh;
}

std::array<float, 3> tags_for(const std::array<double, 3>& depths) {
  return {static_cast<float>(depths[0] + depths[2] - depths[1]), static_cast<float>(depths[0] + depths[1] - depths[2]),
          static_cast<float>(depths[1] + depths[2] - depths[0])};
}

std::vector<MorphVertex> capture_morph(Test& t, const Mesh& mesh, GLenum mode) {
  return capture_as<MorphVertex>(t, 100000, [&] { gl.DrawArrays(mode, 0, static_cast<GLsizei>(mesh.size())); });
}

std::set<PlaceAndBend> found_on_edge(const std::vector<MorphVertex>& vertices, const Vec2& from, const Vec2& to) {
  std::set<PlaceAndBend> found;
  for (const MorphVertex& vertex : vertices)
    if (lies_on(vertex.place, from, to)) found.insert(joined(vertex.place, vertex.bend));
  return found;
}

std::set<PlaceAndBend> expected_on_edge(const Vec2& from, const Vec2& to, double depth) {
  const int whole = static_cast<int>(std::ceil(depth));
  const auto s = static_cast<float>(depth - whole + 1);
  const int steps = 1 << whole;
  const auto place_at = [&](int k) { return between(from, to, static_cast<float>(k) / static_cast<float>(steps)); };
  std::set<PlaceAndBend> expected;
  for (int k = 0; k <= steps; ++k) {
    Vec4 bend = bend_of(place_at(k));
    if (k % 2 != 0 && steps > 1) {
      const Vec4 before = bend_of(place_at(k - 1));
      const Vec4 after = bend_of(place_at(k + 1));
      for (std::size_t i = 0; i < 4; ++i) bend[i] = ((1 - s) / 2 * before[i] + (1 - s) / 2 * after[i]) + s * bend[i];
    }
    expected.insert(joined(place_at(k), bend));
  }
  return expected;
}

bool expect_edge(Test& t, const std::vector<MorphVertex>& vertices, const Vec2& from, const Vec2& to, double depth,
                 const std::string& what) {
  const auto found = found_on_edge(vertices, from, to);
  const auto expected = expected_on_edge(from, to, depth);
  if (!t.expect_equal(found.size(), expected.size(), what + ": vertices on an edge of depth " + as_text(depth)))
    return false;
  return t.expect(found == expected, what + ": the vertices on an edge of depth " + as_text(depth) +
                                         " have the outputs of (11.R.8), by bits");
}

void expect_edges(Test& t, const std::vector<MorphVertex>& vertices, const Mesh& mesh,
                  const std::array<double, 3>& depths, const std::string& what) {
  for (std::size_t i = 0; i < 3; ++i)
    expect_edge(t, vertices, mesh[i].texture, mesh[(i + 1) % 3].texture, depths[i],
                fmt::format("{}, edge {}", what, i));
}

void morph_by_tags(GLuint pool_level, GLenum refinement) {
  refine_by_tags(pool_level, refinement);
  gl.ARKParameteriARK(GL_GEOMORPH_ARK, GL_TRUE);
}

}  // namespace glark::conformance
