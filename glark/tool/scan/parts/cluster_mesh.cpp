// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/parts/cluster_mesh.h"

#include <fmt/format.h>

namespace glark::tool {
namespace {

constexpr std::size_t batch_size = std::size_t{1} << 15;  // vertices

}  // namespace

ClusterMesh::ClusterMesh(const geometry::Geometry& samples, const std::filesystem::path& folder,
                         std::size_t cache_bytes, const common::Workers& workers)
    : workers_(workers), search_(samples), map_(folder, cache_bytes), sheets_(samples.point_count()) {
  pending_.reserve(batch_size);
}

void ClusterMesh::add_point(const std::array<double, 3>& position, const std::array<float, 3>& normal) {
  pending_.push_back(search_.vertex_of(position, normal));
  if (pending_.size() == batch_size) find_samples();
}

void ClusterMesh::find_samples() {
  std::vector<std::uint32_t> found(pending_.size());
  workers_.each(pending_.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) found[i] = search_.sample_of(pending_[i]);
  });
  map_.append(found);
  pending_.clear();
}

void ClusterMesh::add_triangle(const std::array<std::uint32_t, 3>& corners) {
  if (!pending_.empty()) find_samples();
  std::array<std::uint32_t, 3> triangle{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (corners[i] >= map_.size())
      throw geometry::Error(
          fmt::format("a triangle has the corner {}, which follows later in the file or not at all; give more "
                      "--memory, so that the file is read as a whole",
                      corners[i]));
    triangle[i] = map_.at(corners[i]);
  }
  sheets_.add(triangle);
}

std::vector<std::uint32_t> ClusterMesh::take_triangles() { return sheets_.take_triangles(); }

}  // namespace glark::tool
