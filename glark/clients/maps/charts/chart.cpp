// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/charts/chart.h"

#include <algorithm>
#include <cmath>

namespace glark::maps {
namespace {

constexpr float least_guest_cosine = 0.05F;  // of a guest's normal and the chart's

// Any direction that is orthogonal to a unit vector.
Vector orthogonal(Vector n) {
  const Vector axis = std::abs(n.x) < 0.6F ? Vector{1, 0, 0} : Vector{0, 1, 0};
  return common::unit(common::cross(n, axis));
}

void set_normal(Chart& chart, const Surface& surface) {
  Vector normal, vertex_normal, centre;
  float corners = 0;
  for (const std::uint32_t t : chart.triangles) {
    const auto& [a, b, c] = surface.triangles[t];
    normal += common::cross(surface.positions[b] - surface.positions[a], surface.positions[c] - surface.positions[a]);
    centre += surface.positions[a] + surface.positions[b] + surface.positions[c];
    vertex_normal += surface.normals[a] + surface.normals[b] + surface.normals[c];
    corners += 3;
  }
  chart.origin = centre * (1 / corners);
  chart.normal = common::unit(normal);
  if (common::is_zero(chart.normal)) chart.normal = {0, 0, 1};
  chart.vertex_normal = common::unit(vertex_normal);
  if (common::is_zero(chart.vertex_normal)) chart.vertex_normal = chart.normal;
  chart.u = orthogonal(chart.normal);
  chart.v = common::cross(chart.normal, chart.u);
}

// Turns the frame so that u is the direction in which the corners extend most. So the rectangle is small.
void align(Chart& chart, const Surface& surface) {
  float uu = 0, uv = 0, vv = 0;
  for (const std::uint32_t t : chart.triangles) {
    for (const std::uint32_t vertex : surface.triangles[t]) {
      const Point2 p = chart.project(surface.positions[vertex]);
      uu += p[0] * p[0];
      uv += p[0] * p[1];
      vv += p[1] * p[1];
    }
  }
  const float angle = std::atan2(2 * uv, uu - vv) / 2;
  const Vector u = chart.u * std::cos(angle) + chart.v * std::sin(angle);
  chart.u = common::unit(u);
  chart.v = common::cross(chart.normal, chart.u);
}

void set_rectangle(Chart& chart, const Surface& surface) {
  Point2 high{};
  bool is_first = true;
  for (const std::uint32_t t : chart.triangles) {
    for (const std::uint32_t vertex : surface.triangles[t]) {
      const Point2 p = chart.project(surface.positions[vertex]);
      for (std::size_t k = 0; k < 2; ++k) {
        chart.low[k] = is_first ? p[k] : std::min(chart.low[k], p[k]);
        high[k] = is_first ? p[k] : std::max(high[k], p[k]);
      }
      is_first = false;
    }
  }
  chart.size = {high[0] - chart.low[0], high[1] - chart.low[1]};
}

// Guests are the triangles that share a vertex with the chart and face the same side.
void find_guests(Chart& chart, const Surface& surface) {
  chart.guests.clear();
  for (const std::uint32_t t : chart.triangles)
    for (const std::uint32_t vertex : surface.triangles[t])
      for (std::uint32_t i = surface.first_of_vertex[vertex]; i < surface.first_of_vertex[vertex + 1]; ++i)
        chart.guests.push_back(surface.of_vertex[i]);
  std::sort(chart.guests.begin(), chart.guests.end());
  chart.guests.erase(std::unique(chart.guests.begin(), chart.guests.end()), chart.guests.end());
  std::erase_if(chart.guests, [&](std::uint32_t t) {
    return common::dot(surface.triangle_normals[t], chart.normal) < least_guest_cosine ||
           std::binary_search(chart.triangles.begin(), chart.triangles.end(), t);
  });
}

Vector within_plane(Vector v, Vector normal) { return common::unit(v - normal * common::dot(v, normal)); }

void set_tangents(Chart& chart, const Surface& surface) {
  constexpr float least_cosine = 1e-4F;  // of a triangle and the plane; others have no direction
  chart.vertices.clear();
  for (const std::uint32_t t : chart.triangles)
    chart.vertices.insert(chart.vertices.end(), surface.triangles[t].begin(), surface.triangles[t].end());
  std::sort(chart.vertices.begin(), chart.vertices.end());
  chart.vertices.erase(std::unique(chart.vertices.begin(), chart.vertices.end()), chart.vertices.end());
  chart.tangents.assign(chart.vertices.size(), {});
  for (const std::uint32_t t : chart.triangles) {
    const Vector normal = surface.triangle_normals[t];
    const float cosine = common::dot(normal, chart.normal);
    if (!(cosine > least_cosine)) continue;
    const Vector along = chart.u - chart.normal * (common::dot(chart.u, normal) / cosine);
    const auto& corners = surface.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector n = surface.normals[corners[k]], p = surface.positions[corners[k]];
      const Vector a = within_plane(surface.positions[corners[(k + 1) % 3]] - p, n);
      const Vector b = within_plane(surface.positions[corners[(k + 2) % 3]] - p, n);
      const float angle = std::acos(std::clamp(common::dot(a, b), -1.0F, 1.0F));
      const auto at = std::lower_bound(chart.vertices.begin(), chart.vertices.end(), corners[k]);
      chart.tangents[static_cast<std::size_t>(at - chart.vertices.begin())] += within_plane(along, n) * angle;
    }
  }
  for (std::size_t i = 0; i < chart.vertices.size(); ++i) {
    const Vector n = surface.normals[chart.vertices[i]];
    Vector& tangent = chart.tangents[i];
    tangent = common::unit(tangent);
    if (common::is_zero(tangent)) tangent = within_plane(chart.u, n);
    if (common::is_zero(tangent)) tangent = chart.v;
  }
}

}  // namespace

void lay_out(Chart& chart, const Surface& surface) {
  std::sort(chart.triangles.begin(), chart.triangles.end());
  set_normal(chart, surface);
  align(chart, surface);
  set_rectangle(chart, surface);
  find_guests(chart, surface);
  set_tangents(chart, surface);
}

Vector tangent_at(const Chart& chart, std::uint32_t vertex) {
  const auto found = std::lower_bound(chart.vertices.begin(), chart.vertices.end(), vertex);
  return chart.tangents[static_cast<std::size_t>(found - chart.vertices.begin())];
}

}  // namespace glark::maps
