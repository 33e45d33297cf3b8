// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/samples/sample_index.h"

#include <algorithm>
#include <array>
#include <nanoflann.hpp>

namespace glark::stream {
namespace {

constexpr float farthest = 4e18F;

// A set of the nearest samples, as nanoflann fills it. entry(square, place) makes the entry of a position.
template <class Entry, class Make>
struct Result {
  using DistanceType = float;
  NearestSet<Entry>& set;
  Make entry;

  bool full() const { return set.full(); }
  std::size_t size() const { return 0; }
  // NOLINTBEGIN(readability-identifier-naming): nanoflann calls these
  float worstDist() const { return set.worst(); }
  bool addPoint(float square, std::uint32_t place) {
    set.add(entry(square, place));
    return true;
  }
  // NOLINTEND(readability-identifier-naming)
  void sort() {}  // newer versions of nanoflann ask for it; the set is sorted
};

template <class Entry, class Make>
Result<Entry, Make> result_of(NearestSet<Entry>& set, const Make& entry) {
  return {set, entry};
}

}  // namespace

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

  template <class Set>
  void search(const common::Vector3f& point, Set set) const {
    const std::array<float, 3> query = common::to_array(point);
    index.findNeighbors(set, query.data(), {});
  }

  Cloud cloud;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud, 3, std::uint32_t> index;
};

SampleIndex::SampleIndex(const std::vector<common::Vector3f>& positions) : tree_(std::make_unique<Tree>(positions)) {}
SampleIndex::~SampleIndex() = default;

std::size_t SampleIndex::size() const { return tree_->cloud.points.size(); }

void SampleIndex::nearest(const common::Vector3f& point, std::size_t count, std::vector<NearSample>& found) const {
  NearestSet<NearSample> set(found, std::min(count, size()));
  tree_->search(within_floats(point), result_of(set, [](float square, std::uint32_t place) {
                  return NearSample{square, place};
                }));
}

void SampleIndex::add_nearest(const common::Vector3f& point, const CellIndices& samples,
                              NearestSet<CellSample>& set) const {
  tree_->search(point, result_of(set, [&](float square, std::uint32_t place) {
                  return CellSample{square, samples.indices[place], samples.cell, place};
                }));
}

common::Vector3f within_floats(const common::Vector3f& point) {
  const auto within = [](float x) { return std::clamp(x, -farthest, farthest); };
  return {within(point.x), within(point.y), within(point.z)};
}

}  // namespace glark::stream
