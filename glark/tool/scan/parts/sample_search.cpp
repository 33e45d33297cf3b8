// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/parts/sample_search.h"

#include <cmath>
#include <nanoflann.hpp>

namespace glark::tool {
namespace {

constexpr std::size_t nearest_count = 4;  // two sheets that are close have samples on both

}  // namespace

struct SampleSearch::Tree {
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

SampleSearch::SampleSearch(const geometry::Geometry& samples)
    : samples_(samples), tree_(std::make_unique<Tree>(samples.positions)) {}

SampleSearch::~SampleSearch() = default;

MeshVertex SampleSearch::vertex_of(const std::array<double, 3>& position, const std::array<float, 3>& normal) const {
  MeshVertex vertex{{}, normal};
  for (std::size_t axis = 0; axis < 3; ++axis)
    vertex.position[axis] = static_cast<float>(position[axis] - samples_.origin[axis]);
  return vertex;
}

std::uint32_t SampleSearch::sample_of(const MeshVertex& vertex) const {
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

}  // namespace glark::tool
