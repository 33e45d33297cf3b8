// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/parts/cluster_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nanoflann.hpp>
#include <utility>

namespace glark::tool {
namespace {

constexpr std::size_t batch_size = std::size_t{1} << 15;  // vertices
constexpr std::uint32_t no_sample = 0xFFFFFFFF;
constexpr std::size_t nearest_count = 4;  // two sheets that are close have samples on both

}  // namespace

struct ClusterMesh::Tree {
  // The samples, as nanoflann reads them.
  struct Cloud {
    const std::vector<float>& positions;
    std::size_t kdtree_get_point_count() const { return positions.size() / 3; }
    float kdtree_get_pt(std::size_t point, std::size_t axis) const { return positions[3 * point + axis]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
      return false;
    }
  };

  explicit Tree(const std::vector<float>& positions)
      : cloud{positions}, index(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(16)) {}

  Cloud cloud;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud, 3, std::uint32_t> index;
};

ClusterMesh::ClusterMesh(const geometry::Geometry& samples, const std::filesystem::path& folder,
                         std::size_t cache_bytes, const common::Workers& workers)
    : samples_(samples),
      workers_(workers),
      tree_(std::make_unique<Tree>(samples.positions)),
      map_(folder, cache_bytes),
      next_cleaning_(4 * samples.point_count() + batch_size) {
  pending_.reserve(batch_size);
}

ClusterMesh::~ClusterMesh() = default;

void ClusterMesh::add_point(const std::array<double, 3>& position, const std::array<float, 3>& normal) {
  Vertex vertex{{}, normal};
  for (std::size_t axis = 0; axis < 3; ++axis)
    vertex.position[axis] = static_cast<float>(position[axis] - samples_.origin[axis]);
  pending_.push_back(vertex);
  if (pending_.size() == batch_size) find_samples();
}

// The nearest sample on the same side of the surface, if the normals tell the side; else the nearest one.
std::uint32_t ClusterMesh::sample_of(const Vertex& vertex) const {
  const std::array<float, 3>& p = vertex.position;
  if (!std::isfinite(p[0] + p[1] + p[2])) return no_sample;
  std::array<std::uint32_t, nearest_count> found{};
  std::array<float, nearest_count> squares{};
  const std::size_t wanted = samples_.normals.empty() ? 1 : nearest_count;
  const std::size_t count = tree_->index.knnSearch(p.data(), wanted, found.data(), squares.data());
  for (std::size_t i = 0; i < count && !samples_.normals.empty(); ++i) {
    float cosine = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) cosine += vertex.normal[axis] * samples_.normals[3 * found[i] + axis];
    if (cosine > 0) return found[i];
  }
  return found[0];
}

void ClusterMesh::find_samples() {
  std::vector<std::uint32_t> found(pending_.size());
  workers_.each(pending_.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) found[i] = sample_of(pending_[i]);
  });
  map_.append(found);
  pending_.clear();
}

void ClusterMesh::add_triangle(const std::array<std::uint32_t, 3>& corners) {
  if (!pending_.empty()) find_samples();
  Triangle triangle{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (corners[i] >= map_.size())
      throw geometry::Error(
          fmt::format("a triangle has the corner {}, which follows later in the file or not at all; give more "
                      "--memory, so that the file is read as a whole",
                      corners[i]));
    triangle[i] = map_.at(corners[i]);
    if (triangle[i] == no_sample) return;
  }
  if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) return;
  std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  const bool is_turned = triangle[1] > triangle[2];
  if (is_turned) std::swap(triangle[1], triangle[2]);
  sheets_.push_back({triangle, is_turned ? -1 : 1});
  if (sheets_.size() >= next_cleaning_) merge_sheets();
}

void ClusterMesh::merge_sheets() {
  std::sort(sheets_.begin(), sheets_.end(), [](const Sheet& a, const Sheet& b) { return a.corners < b.corners; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < sheets_.size();) {
    Sheet sheet{sheets_[i].corners, 0};
    for (; i < sheets_.size() && sheets_[i].corners == sheet.corners; ++i) sheet.count += sheets_[i].count;
    if (sheet.count != 0) sheets_[kept++] = sheet;
  }
  sheets_.resize(kept);
  next_cleaning_ = 2 * kept + batch_size;
}

std::vector<std::uint32_t> ClusterMesh::take_triangles() {
  merge_sheets();
  std::vector<std::uint32_t> indices;
  indices.reserve(3 * sheets_.size());
  for (const Sheet& sheet : sheets_) {
    const auto [a, b, c] = sheet.corners;
    for (std::int32_t k = 0; k < std::abs(sheet.count); ++k)
      indices.insert(indices.end(), {a, sheet.count > 0 ? b : c, sheet.count > 0 ? c : b});
  }
  sheets_ = {};
  return indices;
}

}  // namespace glark::tool
