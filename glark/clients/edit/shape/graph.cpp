// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/shape/graph.h"

#include <algorithm>
#include <nanoflann.hpp>

namespace glark::edit {
namespace {

constexpr std::size_t nearest = 8;

// The positions in the form that nanoflann reads.
struct Cloud {
  std::span<const double> positions;

  std::size_t kdtree_get_point_count() const { return positions.size() / 3; }
  double kdtree_get_pt(std::size_t index, std::size_t axis) const { return positions[3 * index + axis]; }
  template <typename Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 3, std::uint32_t>;

// For each sample the nearest ones. The sample itself is among them.
std::vector<std::uint32_t> nearest_of(std::span<const double> positions, std::size_t each,
                                      const common::Workers& workers) {
  const Cloud cloud{positions};
  const std::size_t samples = positions.size() / 3;
  Tree tree(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(16));
  tree.buildIndex();
  std::vector<std::uint32_t> found(each * samples);
  workers.each(samples, 1024, [&](std::size_t begin, std::size_t end) {
    std::vector<double> squares(each);
    for (std::size_t i = begin; i < end; ++i) tree.knnSearch(&positions[3 * i], each, &found[each * i], squares.data());
  });
  return found;
}

// Calls link(a, b) for both directions of each pair.
template <class EachPair>
Graph graph_of(std::size_t samples, const EachPair& each_pair) {
  std::vector<std::uint32_t> ends(samples + 1);
  each_pair([&](std::uint32_t a, std::uint32_t /*b*/) { ++ends[a + 1]; });
  for (std::size_t i = 0; i < samples; ++i) ends[i + 1] += ends[i];
  std::vector<std::uint32_t> all(ends.back());
  std::vector<std::uint32_t> next(ends.begin(), ends.end() - 1);
  each_pair([&](std::uint32_t a, std::uint32_t b) { all[next[a]++] = b; });
  Graph graph;
  graph.begins.reserve(samples + 1);
  graph.neighbours.reserve(all.size());
  for (std::size_t i = 0; i < samples; ++i) {
    const auto begin = all.begin() + ends[i], end = all.begin() + ends[i + 1];
    std::sort(begin, end);
    graph.neighbours.insert(graph.neighbours.end(), begin, std::unique(begin, end));
    graph.begins.push_back(static_cast<std::uint32_t>(graph.neighbours.size()));
  }
  return graph;
}

}  // namespace

Graph nearest_graph(std::span<const double> positions, const common::Workers& workers) {
  const std::size_t samples = positions.size() / 3, each = std::min(samples, nearest + 1);
  if (samples == 0) return {};
  const std::vector<std::uint32_t> found = nearest_of(positions, each, workers);
  return graph_of(samples, [&](const auto& link) {
    for (std::size_t k = 0; k < found.size(); ++k) {
      const auto sample = static_cast<std::uint32_t>(k / each);
      if (found[k] == sample) continue;
      link(sample, found[k]);
      link(found[k], sample);
    }
  });
}

Graph triangle_graph(std::size_t samples, std::span<const std::uint32_t> triangles) {
  return graph_of(samples, [&](const auto& link) {
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      const std::uint32_t a = triangles[k], b = triangles[k % 3 == 2 ? k - 2 : k + 1];
      if (a == b) continue;
      link(a, b);
      link(b, a);
    }
  });
}

}  // namespace glark::edit
