// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The distances of approximations from a subdivision surface.
#pragma once

#include <glark/qas.h>

#include <string>
#include <vector>

#include "tests/qas/meshes.h"

namespace glark::bench {

// Positions in % of the diagonal of the bounding box, normals in degrees.
struct Deviation {
  double position_rms = 0, position_most = 0;  // distance from the point of the surface at the same parameter
  double surface_rms = 0,
         surface_most = 0;  // the part of the distance along the surface's normal: the error of the shape
  double normal_rms = 0, normal_most = 0;
};

struct QasErrors {
  std::string mesh;
  std::size_t triangles = 0;
  Deviation qas, split, quartic, pn;  // pn: from the limit positions and normals of the coarse vertices
};

// Measures against LoopSurface, at the vertices of the uniform pattern of `level`.
QasErrors qas_errors(const qas::test::ControlMesh& mesh, unsigned level = 5);

}  // namespace glark::bench
