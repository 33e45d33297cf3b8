// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/charts/wedges.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace glark::maps {
namespace {

// A vertex and its place in the plane. In a plane of projection, the vertex tells the place.
using Key = std::pair<std::uint32_t, Point2>;

Key key_of(const Chart& chart, const Surface& surface, std::uint32_t t, std::size_t corner) {
  return {surface.triangles[t][corner], chart.is_own ? surface.texcoords[t][corner] : Point2{}};
}

Vector within_plane(Vector v, Vector normal) { return common::unit(v - normal * common::dot(v, normal)); }

// The direction in which the first coordinate of the plane grows on a triangle, of any length; zero where it has none.
Vector along_first(const Chart& chart, const Surface& surface, std::uint32_t t) {
  constexpr float least_cosine = 1e-4F;  // of a triangle and the plane
  if (!chart.is_own) {
    const Vector normal = surface.triangle_normals[t];
    const float cosine = common::dot(normal, chart.normal);
    if (!(cosine > least_cosine)) return {};
    return chart.u - chart.normal * (common::dot(chart.u, normal) / cosine);
  }
  const auto& corners = surface.triangles[t];
  const auto& [a, b, c] = surface.texcoords[t];
  const Vector first = surface.positions[corners[1]] - surface.positions[corners[0]];
  const Vector second = surface.positions[corners[2]] - surface.positions[corners[0]];
  const float area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
  const Vector along = common::unit(first * (c[1] - a[1]) - second * (b[1] - a[1]));
  return area < 0 ? along * -1.0F : area > 0 ? along : Vector{};
}

void number_wedges(Chart& chart, const Surface& surface, std::vector<Key>& keys) {
  for (const std::uint32_t t : chart.triangles)
    for (std::size_t k = 0; k < 3; ++k) keys.push_back(key_of(chart, surface, t, k));
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  chart.wedges.clear();
  for (const std::uint32_t t : chart.triangles) {
    auto& wedges = chart.wedges.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      wedges[k] = static_cast<std::uint32_t>(std::lower_bound(keys.begin(), keys.end(), key_of(chart, surface, t, k)) -
                                             keys.begin());
  }
}

void add_tangents(Chart& chart, const Surface& surface) {
  for (std::size_t i = 0; i < chart.triangles.size(); ++i) {
    const Vector along = along_first(chart, surface, chart.triangles[i]);
    if (common::is_zero(along)) continue;
    const auto& corners = surface.triangles[chart.triangles[i]];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector n = surface.normals[corners[k]], p = surface.positions[corners[k]];
      const Vector a = within_plane(surface.positions[corners[(k + 1) % 3]] - p, n);
      const Vector b = within_plane(surface.positions[corners[(k + 2) % 3]] - p, n);
      const float angle = std::acos(std::clamp(common::dot(a, b), -1.0F, 1.0F));
      chart.tangents[chart.wedges[i][k]] += within_plane(along, n) * angle;
    }
  }
}

}  // namespace

void set_wedges(Chart& chart, const Surface& surface) {
  std::vector<Key> keys;
  number_wedges(chart, surface, keys);
  chart.tangents.assign(keys.size(), {});
  add_tangents(chart, surface);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Vector n = surface.normals[keys[i].first];
    Vector& tangent = chart.tangents[i];
    tangent = common::unit(tangent);
    if (common::is_zero(tangent)) tangent = within_plane(chart.u, n);
    if (common::is_zero(tangent)) tangent = chart.v;
  }
}

std::uint32_t wedge_at(const Chart& chart, std::uint32_t triangle, std::size_t corner) {
  const auto found = std::lower_bound(chart.triangles.begin(), chart.triangles.end(), triangle);
  return chart.wedges[static_cast<std::size_t>(found - chart.triangles.begin())][corner];
}

Vector tangent_at(const Chart& chart, std::uint32_t triangle, std::size_t corner) {
  return chart.tangents[wedge_at(chart, triangle, corner)];
}

}  // namespace glark::maps
