// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A chart: triangles of the coarse mesh that do not cover each other in the maps. Either they are a height field over a
// plane, and their texture coordinates are those of the projection onto it. Or they are an island of the mesh's own texture
// coordinates.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "glark/clients/maps/charts/surface.h"

namespace glark::maps {

struct Chart {
  Vector origin, u, v, normal;           // the frame; u, v and normal are orthonormal and right-handed
  Vector vertex_normal;                  // the mean of the normals at the vertices, of unit length
  std::vector<std::uint32_t> triangles;  // in ascending order
  std::vector<std::uint32_t> guests;     // triangles of other charts around it, which its maps cover as well
  Point2 low{}, size{};                  // the rectangle of the triangles in the plane
  bool is_own = false;                   // the plane is that of the mesh's own texture coordinates
  bool is_mirrored = false;              // its triangles turn the other way in this plane than on the surface
  // The corners of the triangles. Those at one vertex and one place of the plane are one wedge.
  std::vector<std::array<std::uint32_t, 3>> wedges;  // [triangles]
  std::vector<Vector> tangents;                      // of the wedges

  Point2 project(Vector p) const {
    const Vector d = p - origin;
    return {common::dot(d, u), common::dot(d, v)};
  }
  // Where a corner of a triangle lies in the plane.
  Point2 point(const Surface& surface, std::uint32_t triangle, std::size_t corner) const {
    return is_own ? surface.texcoords[triangle][corner]
                  : project(surface.positions[surface.triangles[triangle][corner]]);
  }
};

// Sets the frame, the guests, the rectangle, the wedges and the tangents of a chart from its triangles. An own chart has no
// guests.
void lay_out(Chart& chart, const Surface& surface);

// The wedge at a corner of one of the chart's triangles.
std::uint32_t wedge_at(const Chart& chart, std::uint32_t triangle, std::size_t corner);
// The direction in which the first texture coordinate grows there: the mean of the directions of the wedge's triangles,
// weighted by their angles, as programs compute it again from the texture coordinates.
// Source: Mikkelsen, Simulation of Wrinkled Surfaces Revisited, 2008 (MikkTSpace).
Vector tangent_at(const Chart& chart, std::uint32_t triangle, std::size_t corner);

}  // namespace glark::maps
