// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/support/refined_draw.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <set>

namespace glark::conformance {
namespace {

constexpr std::size_t components = sizeof(DrawVertex) / sizeof(float);
using Values = std::array<float, components>;
using Corners = std::array<Values, 3>;

reference::Depths depths_of_corners(const Corners& corners, const Expected& expected) {
  const int level = expected.uniform_level;
  if (level >= 0) return {level, level, level};
  std::array<int, 3> tags{};
  for (std::size_t i = 0; i < 3; ++i) tags[i] = reference::depth_tag(corners[i][8], expected.pool_level);
  return reference::edge_depths(tags);
}

Values refined_values(const Corners& corners, const reference::Weights& weights) {
  Values values{};
  for (std::size_t i = 0; i < components; ++i)  // adding 0 makes -0 equal to 0
    values[i] = reference::refined(corners[0][i], corners[1][i], corners[2][i], weights) + 0.0F;
  return values;
}

double area_of(const Values& a, const Values& b, const Values& c) {
  const auto across = [](const Values& at, const Values& from, std::size_t i) {
    return static_cast<double>(at[i]) - static_cast<double>(from[i]);
  };
  return across(b, a, 0) * across(c, a, 1) - across(c, a, 0) * across(b, a, 1);
}

double area_of(const std::vector<Values>& vertices) {
  double area = 0;
  for (std::size_t i = 0; i + 2 < vertices.size(); i += 3)
    area += area_of(vertices[i], vertices[i + 1], vertices[i + 2]);
  return area;
}

std::vector<Values> captured_values(Test& t, const std::function<void()>& draw) {
  std::vector<Values> vertices = capture_as<Values>(t, 60000, draw);
  for (Values& vertex : vertices)
    for (float& value : vertex) value += 0.0F;
  return vertices;
}

std::string text_of(const Values& values) {
  std::string text;
  for (const float value : values) text += (text.empty() ? "" : " ") + as_text(value);
  return text;
}

// One message for each side: the first missing or surplus vertex says most.
void expect_same_vertices(Test& t, const std::set<Values>& actual, const std::set<Values>& expected,
                          const std::string& what) {
  std::vector<Values> missing;
  std::vector<Values> surplus;
  std::set_difference(expected.begin(), expected.end(), actual.begin(), actual.end(), std::back_inserter(missing));
  std::set_difference(actual.begin(), actual.end(), expected.begin(), expected.end(), std::back_inserter(surplus));
  t.expect(missing.empty(), fmt::format("{}: {} vertices are missing{}", what, missing.size(),
                                        (missing.empty() ? "" : ", one of them " + text_of(missing.front()))));
  t.expect(surplus.empty(), fmt::format("{}: {} vertices belong to no pattern{}", what, surplus.size(),
                                        (surplus.empty() ? "" : ", one of them " + text_of(surplus.front()))));
}

}  // namespace

std::vector<reference::Weights> weights_of(Test& t, const std::vector<CapturedVertex>& vertices) {
  std::vector<reference::Weights> weights;
  weights.reserve(vertices.size());
  for (const CapturedVertex& vertex : vertices) {
    const auto exact = reference::exact_weights(vertex.weights[0], vertex.weights[1], vertex.weights[2]);
    if (!exact.has_value())
      t.require(false, "weights lie between 0 and 1 and have the sum 1: " + as_text(vertex.weights[0]) + " " +
                           as_text(vertex.weights[1]) + " " + as_text(vertex.weights[2]));
    weights.push_back(*exact);
  }
  return weights;
}

std::vector<std::vector<reference::Weights>> patterns_of(Test& t, const std::vector<CapturedVertex>& vertices,
                                                         std::size_t count) {
  std::vector<std::vector<reference::Weights>> patterns(count);
  const auto weights = weights_of(t, vertices);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const float number = vertices[i - i % 3].triangle;
    const auto triangle = static_cast<std::size_t>(std::lround(std::max(number, 0.0F)));
    t.require(triangle < count && std::abs(vertices[i].triangle - number) < 0.01F,
              "the corners of a refined triangle come from one coarse triangle");
    patterns[triangle].push_back(weights[i]);
  }
  return patterns;
}

std::vector<reference::Depths> depths_of(Test& t, std::size_t count, const std::function<void()>& draw) {
  std::vector<reference::Depths> depths;
  for (const auto& pattern : patterns_of(t, capture(t, draw, 100000), count))
    depths.push_back(reference::depths_found(pattern));
  return depths;
}

std::string text_of(const reference::Depths& depths) {
  return fmt::format("({}, {}, {})", depths[0], depths[1], depths[2]);
}

void use_readable_tags() { gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, at_tag); }

GLuint draw_program(Test& t) {
  return build_program(
      t, {.vertex =
              "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour;\n"
              "layout(location = 5) in float tag; layout(location = 6) in float extra;\n"
              "out vec4 colour; out float tag_out; out float instance;\n"
              "void main() { colour = vertex_colour; tag_out = tag; instance = float(gl_InstanceID) + 16.0 * extra;\n"
              "  gl_Position = position; }\n",
          .captured = {"gl_Position", "colour", "tag_out", "instance"}});
}

void expect_triangles(Test& t, const std::vector<CoarseTriangle>& coarse, const std::function<void()>& draw,
                      const std::string& what) {
  std::set<Values> vertices;
  std::int64_t triangles = 0;
  double area = 0;
  for (const CoarseTriangle& triangle : coarse) {
    Corners corners{};
    std::memcpy(corners.data(), triangle.corners.data(), sizeof(corners));
    for (const reference::Weights& weights : reference::minimum_vertices(triangle.depths))
      vertices.insert(refined_values(corners, weights));
    triangles += reference::minimum_triangles(triangle.depths);
    area += area_of(corners[0], corners[1], corners[2]);
  }
  const std::vector<Values> actual = captured_values(t, draw);
  t.expect_equal(static_cast<std::int64_t>(actual.size() / 3), triangles, what + ": refined triangles");
  expect_same_vertices(t, {actual.begin(), actual.end()}, vertices, what);
  t.expect_near(area_of(actual), area, 1e-4, what + ": area with orientation");
}

void expect_refinement(Test& t, const Expected& expected, const std::function<void()>& coarse,
                       const std::function<void()>& refined, const std::string& what) {
  const GLboolean was_enabled = gl.IsEnabled(GL_ARK);
  gl.Disable(GL_ARK);
  const std::vector<Values> unrefined = captured_values(t, coarse);
  t.require(!unrefined.empty(), what + ": the unrefined draw gives triangles");
  std::vector<CoarseTriangle> triangles(unrefined.size() / 3);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    Corners corners = {unrefined[3 * i], unrefined[3 * i + 1], unrefined[3 * i + 2]};
    std::memcpy(triangles[i].corners.data(), corners.data(), sizeof(corners));
    triangles[i].depths = depths_of_corners(corners, expected);
  }
  if (was_enabled != GL_FALSE) gl.Enable(GL_ARK);
  expect_triangles(t, triangles, refined, what);
}

}  // namespace glark::conformance
