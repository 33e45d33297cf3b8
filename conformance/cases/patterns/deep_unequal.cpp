// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The deepest patterns with unequal edges: every vertex on every edge, the number of triangles and the sum of their areas.
// An implementation puts such patterns together from parts.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

// `leaf` names the depths of the three edges. Each row of tags gives the edges these depths in another order.
struct DeepEdges {
  const char* leaf;
  std::vector<std::array<int, 3>> tags;
};

const std::vector<DeepEdges>& deep_edge_depths() {
  static const std::vector<DeepEdges> all = {
      {"8_8_9", {{9, 7, 9}, {7, 9, 9}, {9, 9, 7}}},
      {"8_8_11", {{11, 6, 11}, {6, 11, 11}, {11, 11, 6}}},
      {"8_9_9", {{8, 8, 10}, {10, 8, 8}, {8, 10, 8}}},
      {"8_9_10", {{9, 7, 11}, {7, 9, 11}, {11, 7, 9}, {7, 11, 9}, {11, 9, 7}, {9, 11, 7}}},
      {"9_9_11", {{11, 7, 11}, {7, 11, 11}, {11, 11, 7}}},
      {"9_10_10", {{9, 9, 11}, {11, 9, 9}, {9, 11, 9}}},
  };
  return all;
}

GLuint weights_program(Test& t) {
  return build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 2) in vec3 weights;\n"
                    "out vec3 weights_out; out vec4 colour;\n"
                    "void main() { weights_out = weights; colour = vec4(1.0); gl_Position = position; }\n",
          .captured = {"weights_out"}});
}

// Which of the places 0 to 2^d of an edge have a vertex.
struct EdgeVertices {
  int depth;
  std::vector<bool> found = std::vector<bool>((std::size_t{1} << depth) + 1);
  bool has_other = false;

  void add(std::int64_t along) {
    const std::int64_t segment = reference::unit >> depth;
    has_other = has_other || along % segment != 0;
    found[static_cast<std::size_t>(along / segment)] = true;
  }
  bool is_complete() const {
    return !has_other && std::all_of(found.begin(), found.end(), [](bool each) { return each; });
  }
};

std::int64_t area_of(const reference::Weights& a, const reference::Weights& b, const reference::Weights& c) {
  return (b.u - a.u) * (c.v - a.v) - (c.u - a.u) * (b.v - a.v);
}

std::string fault_of_deep(const std::vector<Vec3>& captured, const reference::Depths& depths, bool is_minimum) {
  const auto triangles = static_cast<std::int64_t>(captured.size() / 3);
  if (is_minimum && triangles != reference::minimum_triangles(depths))
    return fmt::format("{} triangles instead of {}", triangles, reference::minimum_triangles(depths));
  std::array<EdgeVertices, 3> edges = {EdgeVertices{depths[0]}, EdgeVertices{depths[1]}, EdgeVertices{depths[2]}};
  std::array<reference::Weights, 3> corners{};
  std::int64_t area = 0;
  for (std::size_t i = 0; i < captured.size(); ++i) {
    const auto at = reference::exact_weights(captured[i][0], captured[i][1], captured[i][2]);
    if (!at.has_value()) return "weights that are none";
    corners[i % 3] = *at;
    if (at->v == 0) edges[0].add(at->u);
    if (at->w == 0) edges[1].add(at->v);
    if (at->u == 0) edges[2].add(at->w);
    if (i % 3 != 2) continue;
    const std::int64_t each = area_of(corners[0], corners[1], corners[2]);
    if (each <= 0) return "a triangle without a positive area";
    area += each;
  }
  for (std::size_t edge = 0; edge < 3; ++edge)
    if (!edges[edge].is_complete()) return fmt::format("vertices of edge {} are missing or elsewhere", edge);
  return area == reference::unit * reference::unit ? "" : "the areas are not those of the coarse triangle together";
}

void check_deep_edges(Test& t, const DeepEdges& deep, bool is_minimum) {
  gl.UseProgram(weights_program(t));
  for (const std::array<int, 3>& tags : deep.tags) {
    const reference::Depths depths = reference::edge_depths(tags);
    refine_by_tags(static_cast<GLuint>(*std::max_element(tags.begin(), tags.end())));
    gl.ARKParameteriARK(GL_PATTERN_INTERIOR_ARK, is_minimum ? GL_MINIMUM_INTERIOR_ARK : GL_SMOOTH_INTERIOR_ARK);
    upload(one_triangle({static_cast<float>(tags[0]), static_cast<float>(tags[1]), static_cast<float>(tags[2])}));
    const auto most = static_cast<std::size_t>(2 * reference::minimum_triangles(depths));
    const auto captured = capture_as<Vec3>(t, most, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
    const std::string fault = fault_of_deep(captured, depths, is_minimum);
    t.expect(fault.empty(), "the pattern of depths " + text_of(depths) + ": " + fault);
  }
}

}  // namespace

Cases deep_unequal_cases() {
  Cases cases;
  for (const DeepEdges& deep : deep_edge_depths())
    for (const bool is_minimum : {true, false})
      cases.push_back(
          {.name = fmt::format("ark.pattern.deep.{}.{}", deep.leaf, is_minimum ? "minimum" : "smooth"),
           .clauses = {"11.R.5-5", "11.R.5-7", "11.R.5-9", "11.R.5-13"},
           .plan = "Capture the patterns of these edge depths in each order: all vertices on the three edges, "
                   "positive areas and their sum.",
           .wrong = "One edge of a deep pattern has the vertices of another, or is not joined to the inside.",
           .check = [&deep, is_minimum](Test& t) { check_deep_edges(t, deep, is_minimum); }});
  return cases;
}

}  // namespace glark::conformance
