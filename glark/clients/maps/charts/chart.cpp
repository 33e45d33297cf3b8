// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/charts/chart.h"

#include <algorithm>
#include <cmath>

#include "glark/clients/maps/charts/wedges.h"

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
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Point2 p = chart.point(surface, t, corner);
      for (std::size_t k = 0; k < 2; ++k) {
        chart.low[k] = is_first ? p[k] : std::min(chart.low[k], p[k]);
        high[k] = is_first ? p[k] : std::max(high[k], p[k]);
      }
      is_first = false;
    }
  }
  chart.size = {high[0] - chart.low[0], high[1] - chart.low[1]};
}

// Guests are connected with the chart by edges that are not hard.
void leave_out_guests_beyond_hard_edges(Chart& chart, const Surface& surface) {
  std::vector<std::uint32_t> front = chart.triangles;
  std::vector<bool> is_met(chart.guests.size());
  for (std::size_t i = 0; i < front.size(); ++i) {
    const std::uint32_t t = front[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto guest = std::lower_bound(chart.guests.begin(), chart.guests.end(), surface.neighbours[t][k]);
      if (guest == chart.guests.end() || *guest != surface.neighbours[t][k] || is_hard(surface, t, k)) continue;
      const auto at = static_cast<std::size_t>(guest - chart.guests.begin());
      if (is_met[at]) continue;
      is_met[at] = true;
      front.push_back(*guest);
    }
  }
  chart.guests.assign(front.begin() + static_cast<std::ptrdiff_t>(chart.triangles.size()), front.end());
  std::sort(chart.guests.begin(), chart.guests.end());
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
  if (!surface.hard.empty()) leave_out_guests_beyond_hard_edges(chart, surface);
}

}  // namespace

void lay_out(Chart& chart, const Surface& surface) {
  std::sort(chart.triangles.begin(), chart.triangles.end());
  set_normal(chart, surface);
  if (!chart.is_own) align(chart, surface);
  set_rectangle(chart, surface);
  if (!chart.is_own) find_guests(chart, surface);
  set_wedges(chart, surface);
}

}  // namespace glark::maps
