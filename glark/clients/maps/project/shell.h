// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The space around the coarse mesh: each point of it lies on the normal of one place of the mesh, which is its foot. The
// normals of a triangle are those of its vertices, interpolated. So a point is foot + height * normal / |normal|, as
// displacement mapping draws it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "glark/clients/maps/charts/surface.h"
#include "glark/clients/maps/charts/triangle2.h"

namespace glark::maps {

struct Foot {
  std::uint32_t triangle = none;
  Weights weights{};
  float height = 0;
};

class Shell {
 public:
  // reach: the greatest height, in the unit of the positions. The surface must outlive the shell.
  Shell(const Surface& surface, double reach);

  // Returns the lowest foot among those of triangles that face the same side as `normal`; zero: of all triangles. Of two that
  // are equally low, at a crease, it is that of the triangle whose normal is nearer.
  // Nothing if no foot is within reach.
  std::optional<Foot> foot_of(Vector position, Vector normal) const;

  const Surface& surface() const { return surface_; }

 private:
  // In the coordinates of a triangle, which are the barycentric weights of the corners 1 and 2 and the height over the
  // plane, corner i has the normal n[i].
  struct Prism {
    Vector corner, to_first, to_second, plane;
    std::array<Vector, 3> n;
    float slope;  // a foot's weights differ by at most this, for each unit of height, from those in the plane
  };

  // Where a point lies over a triangle's plane.
  struct OverPlane {
    float height, first, second;  // the weights of the corners 1 and 2
  };
  static bool find(const Prism& prism, const OverPlane& over, Foot& foot);
  void add_prism(std::uint32_t triangle);
  void fill_cells();
  std::size_t cell_of(Vector position) const;  // beyond the last cell outside the grid

  const Surface& surface_;
  float reach_;
  std::vector<Prism> prisms_;
  Vector low_;
  float cells_for_unit_ = 0;
  std::array<std::uint32_t, 3> cells_{};
  std::vector<std::uint32_t> first_;      // of each cell, in triangles_
  std::vector<std::uint32_t> triangles_;  // whose prism's box touches the cell
};

}  // namespace glark::maps
