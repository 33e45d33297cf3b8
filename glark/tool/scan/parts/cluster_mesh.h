// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A coarse mesh between samples of a large mesh. Each vertex becomes the sample that is nearest to it. A triangle stays
// if its corners become three samples. Two triangles with the same corners and opposite sides are a fold; both go. So the
// triangles of a closed mesh are closed.
// Based on: P. Lindstrom, Out-of-Core Simplification of Large Polygonal Models, 2000, whose clusters are cells of a grid.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/geometry/geometry.h"
#include "glark/tool/scan/parts/sample_search.h"
#include "glark/tool/scan/parts/sheets.h"
#include "glark/tool/scan/parts/vertex_map.h"

namespace glark::tool {

class ClusterMesh final : public geometry::Visitor {
 public:
  // samples: positions, and normals if the vertices have some. They must stay where they are. folder: for a temporary
  // file with 4 bytes for each vertex. cache_bytes: of the part of this file that is kept in memory.
  ClusterMesh(const geometry::Geometry& samples, const std::filesystem::path& folder, std::size_t cache_bytes,
              const common::Workers& workers);

  void add_point(const std::array<double, 3>& position, const std::array<float, 3>& normal) override;
  // Throws geometry::Error for a corner that has not been added yet.
  void add_triangle(const std::array<std::uint32_t, 3>& corners) override;
  // Returns the triangles as indices of samples, three each, in an order that does not depend on the threads.
  std::vector<std::uint32_t> take_triangles();

 private:
  void find_samples();

  const common::Workers& workers_;
  SampleSearch search_;
  VertexMap map_;
  std::vector<MeshVertex> pending_;  // vertices whose samples are not known yet
  Sheets sheets_;
};

}  // namespace glark::tool
