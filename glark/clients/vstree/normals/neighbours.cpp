// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/normals/neighbours.h"

#include <nanoflann.hpp>

namespace glark::vstree {
namespace {

// The points in the form that nanoflann reads.
struct Cloud {
  std::span<const Float4> points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  float kdtree_get_pt(std::size_t index, std::size_t axis) const { return points[index][static_cast<int>(axis)]; }
  template <typename Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
};

}  // namespace

std::vector<std::uint32_t> nearest(std::span<const Float4> points, std::size_t each, const Workers& workers) {
  const Cloud cloud{points};
  using Index =
      nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud, 3, std::uint32_t>;
  Index index(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(16));
  index.buildIndex();
  std::vector<std::uint32_t> result(points.size() * each);
  workers.each(points.size(), 1024, [&](std::size_t begin, std::size_t end) {
    std::vector<float> distances(each);
    for (std::size_t i = begin; i < end; ++i) {
      const std::array<float, 3> point = triple(points[i]);
      index.knnSearch(point.data(), each, result.data() + i * each, distances.data());
    }
  });
  return result;
}

}  // namespace glark::vstree
