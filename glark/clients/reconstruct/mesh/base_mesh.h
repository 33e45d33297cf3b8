// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The coarse mesh: the contour with one vertex for each sheet in each transition node.
#pragma once

#include "glark/clients/reconstruct/contour/contour.h"
#include "glark/clients/reconstruct/samples/local_surface.h"

namespace glark::reconstruct {

struct BaseMesh {
  std::vector<Float4> points;
  std::vector<Float4> normals;           // the fourth is 1 where samples were near
  std::vector<std::uint32_t> triangles;  // a manifold with boundary, consistently oriented
  std::vector<std::uint32_t> opposite;   // [triangles * 3], of half-edges; no_half_edge at the boundary
  std::uint32_t left_out = 0;            // the number of parts that were removed
  float area_left_out = 0;               // their share of the area
};

// Makes the coarse mesh, with its vertices at the samples.
BaseMesh base_mesh(const Contour& contour, const TransitionLayer& layer, const Octree& octree,
                   const ReconstructOptions& options, const Workers& workers);

}  // namespace glark::reconstruct
