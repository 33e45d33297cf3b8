// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/project/coverage.h"

#include "glark/clients/maps/project/chart_map.h"

namespace glark::maps {

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
      for (std::size_t k = 0; k < 3; ++k)
        normal += surface.normals[surface.triangles[t][k]] * coverage.weights[at][k];
    else
      normal = chart.vertex_normal;
    for (std::size_t k = 0; k < 3; ++k) values[at * channels + normal_channel + k] = normal[k];
  }
}

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
        const Vector found = common::unit(common::cross(along_x, along_y));
        normal = common::is_zero(found) ? surface.triangle_normals[coverage.triangles[at]] : found;
      }
      for (std::size_t k = 0; k < 3; ++k) values[at * channels + normal_channel + k] = normal[k];
    }
  }
}

}  // namespace glark::maps
