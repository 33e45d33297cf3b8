// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Divides the coarse mesh and moves its vertices to the samples.
#pragma once

#include "glark/clients/reconstruct/mesh/base_mesh.h"
#include "glark/clients/reconstruct/samples/local_surface.h"

namespace glark::reconstruct {

struct RefinedMesh {
  std::vector<Float4> points;
  std::vector<Float4> normals;  // the fourth is 1 where samples were near
  std::vector<Float4> colours;  // as in LocalEstimate; empty if the samples have none
  std::vector<std::uint32_t> triangles;
  unsigned levels = 0;
};

RefinedMesh refine(BaseMesh base, const Octree& octree, const ReconstructOptions& options, const Workers& workers);

}  // namespace glark::reconstruct
