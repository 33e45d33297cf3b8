// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/reference/pattern.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace glark::conformance::reference {
namespace {

using Edge = std::pair<Weights, Weights>;

// The weight of the corner that edge `edge` does not touch: 0 on the edge.
std::int64_t opposite(const Weights& at, int edge) { return edge == 0 ? at.v : edge == 1 ? at.w : at.u; }

// The distance along edge `edge`, from its first end.
std::int64_t along(const Weights& at, int edge) { return edge == 0 ? at.u : edge == 1 ? at.v : at.w; }

std::string text_of(const Weights& at) {
  const double scale = 1.0 / static_cast<double>(unit);
  return fmt::format("({:f}, {:f}, {:f})", static_cast<double>(at.w) * scale, static_cast<double>(at.u) * scale,
                     static_cast<double>(at.v) * scale);
}

// Twice the area, in units of the coarse triangle's area.
std::int64_t area_of(const Weights& a, const Weights& b, const Weights& c) {
  return (b.u - a.u) * (c.v - a.v) - (c.u - a.u) * (b.v - a.v);
}

std::string fault_of_areas(const std::vector<Weights>& triangles) {
  std::int64_t whole = 0;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const std::int64_t area = area_of(triangles[i], triangles[i + 1], triangles[i + 2]);
    if (area == 0) return "a triangle at " + text_of(triangles[i]) + " has no area";
    if (area < 0) return "a triangle at " + text_of(triangles[i]) + " has the other orientation";
    whole += area;
  }
  // The sum cannot overflow unless triangles overlap, and then it does not equal this value by chance.
  if (whole != unit * unit) return "the areas do not add up to the coarse triangle's";
  return {};
}

// An edge with a triangle on only one side has to be a segment of a coarse edge.
std::string fault_of_outline(const Edge& edge, const Depths& depths) {
  for (int i = 0; i < 3; ++i) {
    if (opposite(edge.first, i) != 0 || opposite(edge.second, i) != 0) continue;
    const std::int64_t segment = unit >> depths[static_cast<std::size_t>(i)];
    if (along(edge.second, i) - along(edge.first, i) == segment && along(edge.first, i) % segment == 0) return {};
    return fmt::format("edge {} has a segment from {} to {}", i, text_of(edge.first), text_of(edge.second));
  }
  return "nothing lies beyond the inner edge from " + text_of(edge.first) + " to " + text_of(edge.second);
}

std::string fault_of_edges(const std::vector<Weights>& triangles, const Depths& depths) {
  std::set<Edge> edges;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    if (!edges.insert({triangles[i], triangles[next]}).second)
      return "two triangles overlap at the edge from " + text_of(triangles[i]) + " to " + text_of(triangles[next]);
  }
  std::int64_t outline = 0;
  for (const Edge& edge : edges) {
    if (edges.count({edge.second, edge.first}) != 0) continue;
    ++outline;
    if (std::string fault = fault_of_outline(edge, depths); !fault.empty()) return fault;
  }
  std::int64_t expected = 0;
  for (const int depth : depths) expected += std::int64_t{1} << depth;
  if (outline != expected) return fmt::format("the three edges have {} segments together", outline);
  return {};
}

bool is_equal(const Depths& depths) { return depths[0] == depths[1] && depths[1] == depths[2]; }

// Checks that the triangles are congruent in every coarse triangle: each edge has a segment's length and is parallel to
// a coarse edge.
std::string fault_of_congruence(const std::vector<Weights>& triangles, int depth) {
  if (triangles.size() != std::size_t{3} << (2 * depth)) return "there are not 4^d triangles";
  const std::int64_t segment = unit >> depth;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Weights& a = triangles[i];
    const Weights& b = triangles[i % 3 == 2 ? i - 2 : i + 1];
    std::array<std::int64_t, 3> steps = {std::abs(b.w - a.w), std::abs(b.u - a.u), std::abs(b.v - a.v)};
    std::sort(steps.begin(), steps.end());
    if (steps != std::array<std::int64_t, 3>{0, segment, segment})
      return "triangles are not congruent at " + text_of(a);
  }
  return {};
}

std::vector<Weights> vertices_of(const std::vector<Weights>& triangles) {
  const std::set<Weights> vertices(triangles.begin(), triangles.end());
  return {vertices.begin(), vertices.end()};
}

}  // namespace

int depth_tag(float value, int pool_level) {
  if (std::isnan(value)) return 0;
  const double nearest = std::floor(static_cast<double>(value) + 0.5);  // exact: a double holds the sum
  return static_cast<int>(std::clamp(nearest, 0.0, static_cast<double>(std::max(pool_level, 0))));
}

int edge_depth(int a, int b) { return (a + b) / 2; }

Depths edge_depths(const std::array<int, 3>& tags) {
  return {edge_depth(tags[0], tags[1]), edge_depth(tags[1], tags[2]), edge_depth(tags[2], tags[0])};
}

std::array<Weights, 3> corners() { return {{{unit, 0, 0}, {0, unit, 0}, {0, 0, unit}}}; }

std::vector<Weights> edge_vertices(int edge, int depth) {
  std::vector<Weights> vertices;
  const std::int64_t segment = unit >> depth;
  for (std::int64_t at = 0; at <= unit; at += segment) {
    if (edge == 0) vertices.push_back({unit - at, at, 0});
    if (edge == 1) vertices.push_back({0, unit - at, at});
    if (edge == 2) vertices.push_back({at, 0, unit - at});
  }
  return vertices;
}

std::vector<Weights> inside_vertices(int depth) {
  std::vector<Weights> vertices;
  const std::int64_t segment = unit >> depth;
  for (std::int64_t u = segment; u < unit; u += segment)
    for (std::int64_t v = segment; u + v < unit; v += segment) vertices.push_back({unit - u - v, u, v});
  return vertices;
}

std::vector<Weights> minimum_vertices(const Depths& depths) {
  std::vector<Weights> all = inside_vertices(std::min({depths[0], depths[1], depths[2]}));
  for (int edge = 0; edge < 3; ++edge) {
    const auto line = edge_vertices(edge, depths[static_cast<std::size_t>(edge)]);
    all.insert(all.end(), line.begin(), line.end() - 1);
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::int64_t minimum_triangles(const Depths& depths) {
  const std::int64_t side = std::int64_t{1} << std::min({depths[0], depths[1], depths[2]});
  std::int64_t count = (side - 1) * (side - 2) - 2;
  for (const int depth : depths) count += std::int64_t{1} << depth;
  return count;
}

std::optional<Weights> exact_weights(float w, float u, float v) {
  std::array<std::int64_t, 3> units{};
  const std::array<float, 3> values = {w, u, v};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(values[i] >= 0 && values[i] <= 1)) return std::nullopt;
    const double scaled = static_cast<double>(values[i]) * static_cast<double>(unit);
    if (scaled != std::floor(scaled)) return std::nullopt;
    units[i] = static_cast<std::int64_t>(scaled);
  }
  if (units[0] + units[1] + units[2] != unit) return std::nullopt;
  return Weights{units[0], units[1], units[2]};
}

std::string fault_of_pattern(const std::vector<Weights>& triangles, const Depths& depths) {
  if (triangles.size() % 3 != 0 || triangles.empty()) return "there are no triangles";
  if (std::string fault = fault_of_areas(triangles); !fault.empty()) return fault;
  if (std::string fault = fault_of_edges(triangles, depths); !fault.empty()) return fault;
  return is_equal(depths) ? fault_of_congruence(triangles, depths[0]) : std::string();
}

std::string fault_of_minimum(const std::vector<Weights>& triangles, const Depths& depths) {
  if (std::string fault = fault_of_pattern(triangles, depths); !fault.empty()) return fault;
  const auto count = static_cast<std::int64_t>(triangles.size() / 3);
  if (count != minimum_triangles(depths))
    return fmt::format("{} triangles instead of {}", count, minimum_triangles(depths));
  if (vertices_of(triangles) != minimum_vertices(depths))
    return "the vertices inside are not those of the least of the three depths";
  return {};
}

Depths depths_found(const std::vector<Weights>& triangles) {
  Depths depths = {-1, -1, -1};
  const auto vertices = vertices_of(triangles);
  for (int edge = 0; edge < 3; ++edge) {
    const auto on_edge = std::count_if(vertices.begin(), vertices.end(),
                                       [edge](const Weights& vertex) { return opposite(vertex, edge) == 0; });
    for (int depth = 0; depth <= 30; ++depth)
      if (on_edge == (std::int64_t{1} << depth) + 1) depths[static_cast<std::size_t>(edge)] = depth;
  }
  return depths;
}

float refined(float a0, float a1, float a2, const Weights& weights) {
  // A double has enough bits for the product or the sum of two floats: the cast is the only rounding. The casts prevent
  // contraction.
  const auto times = [](std::int64_t weight, float a) {
    return static_cast<float>(static_cast<double>(weight) / static_cast<double>(unit) * static_cast<double>(a));
  };
  const auto plus = [](float a, float b) {
    return static_cast<float>(static_cast<double>(a) + static_cast<double>(b));
  };
  return plus(plus(times(weights.w, a0), times(weights.u, a1)), times(weights.v, a2));
}

}  // namespace glark::conformance::reference
