// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/chosen_clusters.h"

#include <algorithm>
#include <cmath>

namespace glark::stream {
namespace {

// One cluster for several parts of `whole`.
PlacedCluster merged(std::span<const PlacedCluster> parts, const ClusterNode& whole) {
  PlacedCluster result{{}, parts.front().node};
  std::array<double, 3> normal{}, colour{};
  double points = 0;
  for (const PlacedCluster& part : parts) points += static_cast<double>(part.node.count);
  for (const PlacedCluster& part : parts) {
    const double share = static_cast<double>(part.node.count) / points;
    for (std::size_t k = 0; k < 3; ++k) {
      result.position[k] += share * part.position[k];
      normal[k] += share * static_cast<double>(part.node.normal[k]);
      colour[k] += share * part.node.colour[k];
    }
  }
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  for (std::size_t k = 0; k < 3; ++k) {
    result.node.normal[k] = length > 0 ? static_cast<float>(normal[k] / length) : 0;
    result.node.colour[k] = static_cast<std::uint8_t>(std::lround(colour[k]));
  }
  result.node.count = static_cast<float>(points);
  result.node.square = whole.square * result.node.count / whole.count;
  return result;
}

}  // namespace

void CellSamples::add(const PlacedCluster& sample) {
  emit_(sample.position, sample.node);
  squares_ += static_cast<double>(sample.node.square);
  points_ += static_cast<double>(sample.node.count);
  ++count_;
}

void CellSamples::add_some(std::vector<PlacedCluster>& parts, std::size_t single, const ClusterNode& whole) {
  std::stable_sort(parts.begin(), parts.end(),
                   [](const PlacedCluster& a, const PlacedCluster& b) { return a.node.error > b.node.error; });
  for (std::size_t i = 0; i < single; ++i) add(parts[i]);
  add(merged(std::span(parts).subspan(single), whole));
}

void CellSamples::finish(std::size_t first, std::size_t last) {
  for (std::size_t cell = first; cell < last; ++cell) {
    cells_[cell].first_sample = begin_;
    cells_[cell].samples = count_ - begin_;
    cells_[cell].error = points_ > 0 ? std::sqrt(squares_ / points_) : 0;
  }
  squares_ = points_ = 0;
  begin_ = count_;
}

}  // namespace glark::stream
