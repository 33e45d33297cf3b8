// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Loop's limit surface over one triangle, from the vertices around it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "glark/clients/qas/topology.h"

namespace glark::qas {

using Point = std::array<double, 3>;

struct Jet {
  Point position{};
  std::array<Point, 2> tangents{};  // their lengths have no meaning
};

// Some triangles of a mesh, three vertices each, and the creases between them.
struct Neighbourhood {
  std::vector<std::uint32_t> triangles, creases;
};

// A triangle with all triangles that touch it. The other triangles only provide control points.
class LoopPatch {
 public:
  // around: the triangle itself, then all triangles that touch it. positions: the positions of all vertices of the
  // mesh.
  LoopPatch(const Neighbourhood& around, const std::vector<Point>& positions);

  // Returns whether all vertices have valence 6 and no crease: then the surface is a quartic box spline.
  bool regular() const { return regular_; }
  // The patch must be regular.
  Jet box_spline(const std::array<double, 3>& barycentric) const;
  // The surface at corner 0, 1 or 2 of any patch.
  Jet limit(std::uint32_t corner) const;
  // Returns one of four patches after one step. Patches 0, 1 and 2 lie at the corners. Patch 3 lies in the middle, with
  // its corners on the edges 01, 12, 20.
  LoopPatch child(std::uint32_t which) const;

 private:
  void find_control_points();
  std::vector<Point> subdivided() const;

  Topology topology_;  // the triangle is the first one
  std::vector<Point> positions_;
  bool regular_ = false;
  // For each corner: itself, the vertex beyond the edge to the next corner, two outer vertices.
  std::array<std::uint32_t, 12> control_{};
};

}  // namespace glark::qas
