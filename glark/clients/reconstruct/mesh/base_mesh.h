// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The coarse mesh: the contour with one vertex for each transition node and sheet.
#pragma once

#include "glark/clients/reconstruct/contour/contour.h"
#include "glark/clients/reconstruct/samples/local_surface.h"

namespace glark::reconstruct {

struct BaseMesh {
  std::vector<Float4> points;
  std::vector<Float4> normals;           // the fourth is 1 where samples were near
  std::vector<std::uint32_t> triangles;  // edges have one or two, which run against each other; vertices have one fan
  std::vector<std::uint32_t>
      opposite;                // [triangles * 3]: of the half-edge from that corner to the next; none at the border
  std::uint32_t left_out = 0;  // parts
};

// With its vertices at the samples.
BaseMesh base_mesh(const Contour& contour, const TransitionLayer& layer, const Octree& octree,
                   const ReconstructOptions& options, const Workers& workers);

}  // namespace glark::reconstruct
