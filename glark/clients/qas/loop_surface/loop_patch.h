// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Loop's limit surface over one triangle, from the vertices about it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "glark/clients/qas/topology.h"

namespace glark::qas {

using Point = std::array<double, 3>;

struct Jet {
  Point position{};
  std::array<Point, 2> tangents{};  // not of any length
};

// Triangles anywhere in a mesh, three vertices each, and the creases between them.
struct Neighbourhood {
  std::vector<std::uint32_t> triangles, creases;
};

// A triangle with all triangles that touch it. Those at its rim are there as control points; nothing is evaluated there.
class LoopPatch {
 public:
  // around: the triangle itself first, and all that touch it. positions: of all vertices of the mesh.
  LoopPatch(const Neighbourhood& around, const std::vector<Point>& positions);

  // All vertices have valence 6 and no crease: the surface is a quartic box spline here.
  bool regular() const { return regular_; }
  // Of a regular one.
  Jet box_spline(const std::array<double, 3>& barycentric) const;
  // At corner 0, 1 or 2, of any.
  Jet limit(std::uint32_t corner) const;
  // After one step: 0, 1, 2 at the corners, 3 in the middle, with its corners on the edges 01, 12, 20.
  LoopPatch child(std::uint32_t which) const;

 private:
  void find_control_points();
  std::vector<Point> subdivided() const;

  Topology topology_;  // the triangle is its first
  std::vector<Point> positions_;
  bool regular_ = false;
  std::array<std::uint32_t, 12>
      control_{};  // per corner: itself, beyond the edge to the next, two others as the ring has them
};

}  // namespace glark::qas
