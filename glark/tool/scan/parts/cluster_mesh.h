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
#include <memory>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/geometry/geometry.h"
#include "glark/tool/scan/parts/vertex_map.h"

namespace glark::tool {

class ClusterMesh final : public geometry::Visitor {
 public:
  // samples: positions, and normals if the vertices have some. They must stay where they are. folder: for a temporary
  // file with 4 bytes for each vertex. cache_bytes: of the part of this file that is kept in memory.
  ClusterMesh(const geometry::Geometry& samples, const std::filesystem::path& folder, std::size_t cache_bytes,
              const common::Workers& workers);
  ~ClusterMesh() override;

  void add_point(const std::array<double, 3>& position, const std::array<float, 3>& normal) override;
  // Throws geometry::Error for a corner that has not been added yet.
  void add_triangle(const std::array<std::uint32_t, 3>& corners) override;
  // Returns the triangles as indices of samples, three each, in an order that does not depend on the threads.
  std::vector<std::uint32_t> take_triangles();

 private:
  using Triangle = std::array<std::uint32_t, 3>;
  // Triangles with the same corners: how many more have this orientation than the other one.
  struct Sheet {
    Triangle corners;
    std::int32_t count;
  };
  struct Vertex {
    std::array<float, 3> position, normal;  // relative to the samples' origin
  };
  struct Tree;

  std::uint32_t sample_of(const Vertex& vertex) const;
  void find_samples();
  void merge_sheets();

  const geometry::Geometry& samples_;
  const common::Workers& workers_;
  std::unique_ptr<Tree> tree_;
  VertexMap map_;
  std::vector<Vertex> pending_;  // vertices whose samples are not known yet
  std::vector<Sheet> sheets_;
  std::size_t next_cleaning_;
};

}  // namespace glark::tool
