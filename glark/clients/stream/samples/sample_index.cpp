// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/transfer/sample_index.h"

#include <algorithm>
#include <array>
#include <nanoflann.hpp>

namespace glark::stream {

struct SampleIndex::Tree {
  // The positions in the form that nanoflann reads.
  struct Cloud {
    const std::vector<common::Vector3f>& points;
    std::size_t kdtree_get_point_count() const { return points.size(); }
    float kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][axis]; }
    template <class Box>
    bool kdtree_get_bbox(Box& /*box*/) const {
      return false;
    }
  };
  explicit Tree(const std::vector<common::Vector3f>& positions)
      : cloud{positions}, index(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(16)) {}

  Cloud cloud;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud, 3, std::uint32_t> index;
};

SampleIndex::SampleIndex(const std::vector<common::Vector3f>& positions) : tree_(std::make_unique<Tree>(positions)) {}
SampleIndex::~SampleIndex() = default;

std::size_t SampleIndex::size() const { return tree_->cloud.points.size(); }

void SampleIndex::nearest(const common::Vector3f& point, std::size_t count, std::vector<std::uint32_t>& indices,
                          std::vector<float>& squares) const {
  count = std::min(count, size());
  indices.resize(count);
  squares.resize(count);
  const std::array<float, 3> query = common::to_array(point);
  tree_->index.knnSearch(query.data(), count, indices.data(), squares.data());
}

}  // namespace glark::stream
