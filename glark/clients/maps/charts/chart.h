// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A chart: triangles of the coarse mesh that are a height field over a plane. Its texture coordinates are those of the
// projection onto the plane.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "glark/clients/maps/charts/surface.h"

namespace glark::maps {

using Point2 = std::array<float, 2>;

struct Chart {
  Vector origin, u, v, normal;           // the frame; u, v and normal are orthonormal and right-handed
  Vector vertex_normal;                  // the mean of the normals at the vertices, of unit length
  std::vector<std::uint32_t> triangles;  // in ascending order
  std::vector<std::uint32_t> guests;     // triangles of other charts around it, which its maps cover as well
  Point2 low{}, size{};                  // the rectangle of the triangles in the plane
  std::vector<std::uint32_t> vertices;   // of the triangles, in ascending order
  std::vector<Vector> tangents;          // at these vertices

  Point2 project(Vector p) const {
    const Vector d = p - origin;
    return {common::dot(d, u), common::dot(d, v)};
  }
};

// Sets the frame, the guests, the rectangle and the tangents of a chart from its triangles.
void lay_out(Chart& chart, const Surface& surface);

// The direction in which the first texture coordinate grows, at a vertex of a chart's triangles: the mean of their directions,
// weighted by their angles, as programs compute it again from the texture coordinates.
// Source: Mikkelsen, Simulation of Wrinkled Surfaces Revisited, 2008 (MikkTSpace).
Vector tangent_at(const Chart& chart, std::uint32_t vertex);

}  // namespace glark::maps
