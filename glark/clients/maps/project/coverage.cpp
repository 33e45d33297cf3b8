// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/project/coverage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "glark/clients/maps/charts/tangent_frame.h"
#include "glark/clients/maps/fill/diffusion.h"
#include "glark/clients/maps/project/chart_map.h"

namespace glark::maps {
namespace {

constexpr int margin = 8;  // texels

// Calls visit(index, centre) for the texels in the box around a triangle, and in the margin around the box.
template <class Visit>
void for_each_texel_near(const Triangle2& triangle, const Place& place, const Visit& visit) {
  const auto& c = triangle.corners;
  const auto range = [&](std::size_t axis, unsigned size) {
    const auto [low, high] = std::minmax({c[0][axis], c[1][axis], c[2][axis]});
    return std::pair(std::max(static_cast<int>(std::floor(low)) - margin, 0),
                     std::min(static_cast<int>(std::ceil(high)) + margin, static_cast<int>(size)));
  };
  const auto [first_x, end_x] = range(0, place.width);
  const auto [first_y, end_y] = range(1, place.height);
  for (int y = first_y; y < end_y; ++y)
    for (int x = first_x; x < end_x; ++x)
      visit(static_cast<std::size_t>(y) * place.width + static_cast<std::size_t>(x),
            Point2{static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F});
}

}  // namespace

Coverage nearest_places(const Chart& chart, const Place& place, const Surface& surface) {
  Chart alone = chart;
  alone.guests.clear();
  Coverage coverage = cover(alone, place, surface);
  std::vector<float> distances(coverage.triangles.size(), static_cast<float>(margin * margin));
  for (std::size_t at = 0; at < distances.size(); ++at)
    if (coverage.triangles[at] != none) distances[at] = -1;
  for (const std::uint32_t t : chart.triangles) {
    const Triangle2 triangle = triangle_in(chart, place, surface, t);
    for_each_texel_near(triangle, place, [&](std::size_t at, Point2 centre) {
      if (distances[at] < 0) return;
      const auto [weights, squared] = nearest_on_boundary(triangle, centre);
      if (squared >= distances[at]) return;
      distances[at] = squared;
      coverage.triangles[at] = t;
      coverage.weights[at] = weights;
    });
  }
  return coverage;
}

Coverage cover(const Chart& chart, const Place& place, const Surface& surface) {
  const std::size_t texels = std::size_t{place.width} * place.height;
  Coverage coverage{std::vector<std::uint32_t>(texels, none), std::vector<Weights>(texels)};
  constexpr float rounding = -1e-4F;
  const auto add = [&](std::uint32_t t) {
    for_each_centre(triangle_in(chart, place, surface, t), rounding, [&](int x, int y, const Weights& weights) {
      if (x < 0 || y < 0 || x >= static_cast<int>(place.width) || y >= static_cast<int>(place.height)) return;
      const std::size_t at = static_cast<std::size_t>(y) * place.width + static_cast<std::size_t>(x);
      if (coverage.triangles[at] != none) return;
      coverage.triangles[at] = t;
      coverage.weights[at] = weights;
    });
  };
  for (const std::uint32_t t : chart.triangles) add(t);
  for (const std::uint32_t t : chart.guests) add(t);
  return coverage;
}

void set_coarse_normals(const Chart& chart, const Surface& surface, const Coverage& coverage, unsigned channels,
                        std::vector<float>& values) {
  for (std::size_t at = 0; at < coverage.triangles.size(); ++at) {
    Vector normal;
    if (const std::uint32_t t = coverage.triangles[at]; t != none)
      for (std::size_t k = 0; k < 3; ++k) normal += surface.normals[surface.triangles[t][k]] * coverage.weights[at][k];
    else
      normal = chart.vertex_normal;
    for (std::size_t k = 0; k < 3; ++k) values[at * channels + normal_channel + k] = normal[k];
  }
}

namespace {

// Beyond the triangles of an island, normals are those at its border.
void spread_normals(const Place& place, const Coverage& coverage, unsigned channels, std::vector<float>& values) {
  std::vector<float> normals, weights;
  for (std::size_t at = 0; at < coverage.triangles.size(); ++at) {
    const float* const n = values.data() + at * channels + normal_channel;
    normals.insert(normals.end(), {n[0], n[1], n[2]});
    weights.push_back(coverage.triangles[at] == none ? 0.0F : 1.0F);
  }
  if (diffuse({place.width, place.height, 3, normals, weights}).filled == weights.size()) return;  // no triangle
  for (std::size_t at = 0; at < weights.size(); ++at)
    std::copy_n(&normals[3 * at], 3, values.data() + at * channels + normal_channel);
}

}  // namespace

void set_normals_from_heights(const Chart& chart, const Place& place, const Surface& surface, const Coverage& coverage,
                              unsigned channels, std::vector<float>& values) {
  const auto displaced = [&](std::size_t at) {
    const auto& corners = surface.triangles[coverage.triangles[at]];
    const Weights& w = coverage.weights[at];
    Vector position, normal;
    for (std::size_t k = 0; k < 3; ++k) {
      position += surface.positions[corners[k]] * w[k];
      normal += surface.normals[corners[k]] * w[k];
    }
    return position + common::unit(normal) * values[at * channels + height_channel];
  };
  // The difference of the neighbours on both sides, or of one neighbour and the texel itself.
  const auto difference = [&](std::size_t at, std::size_t step, bool has_before, bool has_after) {
    const bool before = has_before && coverage.triangles[at - step] != none;
    const bool after = has_after && coverage.triangles[at + step] != none;
    if (!before && !after) return Vector{};
    return displaced(after ? at + step : at) - displaced(before ? at - step : at);
  };
  for (std::size_t y = 0; y < place.height; ++y) {
    for (std::size_t x = 0; x < place.width; ++x) {
      const std::size_t at = y * place.width + x;
      Vector normal = chart.vertex_normal;
      if (coverage.triangles[at] != none) {
        const Vector along_x = difference(at, 1, x > 0, x + 1 < place.width);
        const Vector along_y = difference(at, place.width, y > 0, y + 1 < place.height);
        const Vector found = common::unit(common::cross(along_x, along_y) * (chart.is_mirrored ? -1.0F : 1.0F));
        normal = common::is_zero(found) ? surface.triangle_normals[coverage.triangles[at]] : found;
      }
      for (std::size_t k = 0; k < 3; ++k) values[at * channels + normal_channel + k] = normal[k];
    }
  }
  if (chart.is_own) spread_normals(place, coverage, channels, values);
}

void to_tangent_space(const Chart& chart, const Place& place, const Surface& surface, unsigned channels,
                      std::vector<float>& values) {
  const Coverage coverage = nearest_places(chart, place, surface);
  const Vector chart_tangent = common::unit(chart.u - chart.vertex_normal * common::dot(chart.u, chart.vertex_normal));
  std::uint32_t last = none;  // triangle, whose tangents are known
  std::array<Vector, 3> tangents{};
  for (std::size_t at = 0; at < coverage.triangles.size(); ++at) {
    Vector normal = chart.vertex_normal, tangent = common::is_zero(chart_tangent) ? chart.v : chart_tangent;
    if (const std::uint32_t t = coverage.triangles[at]; t != none) {
      if (t != last)
        for (std::size_t k = 0; k < 3; ++k) tangents[k] = tangent_at(chart, t, k);
      last = t;
      normal = tangent = {};
      for (std::size_t k = 0; k < 3; ++k) {
        normal += surface.normals[surface.triangles[t][k]] * coverage.weights[at][k];
        tangent += tangents[k] * coverage.weights[at][k];
      }
    }
    float* n = values.data() + at * channels + normal_channel;
    const Vector local = TangentFrame::of(normal, tangent).to_local({n[0], n[1], n[2]});
    for (std::size_t k = 0; k < 3; ++k) n[k] = local[k];
  }
}

}  // namespace glark::maps
