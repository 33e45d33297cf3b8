// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which clusters become samples, so that the target is met exactly.
#pragma once

#include <glark/stream.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "glark/clients/stream/sample/tree/cluster_tree.h"

namespace glark::stream {

// A sample, and its position in the unit of the source.
using EmitSample = std::function<void(const std::array<double, 3>& position, const ClusterNode& node)>;

// Clusters with a greater error than `threshold` are divided. So are some of those above `least`, for `spare` more
// samples: all of them would be too many.
struct Cut {
  float threshold = 0;
  float least = 0;
  std::uint64_t spare = 0;
};

// A cluster, and its position in the unit of the source.
struct PlacedCluster {
  std::array<double, 3> position;
  ClusterNode node;
};

// Decides about the clusters one after the other.
class Chooser {
 public:
  enum class Choice { sample, divide, divide_partly };
  explicit Chooser(const Cut& cut) : cut_(cut) {}

  Choice choose(const ClusterNode& node) {
    if (node.children == 0) return Choice::sample;
    if (!(node.error <= cut_.threshold)) return Choice::divide;
    if (cut_.spare == 0 || node.error <= cut_.least) return Choice::sample;
    if (node.children - 1 > cut_.spare) return Choice::divide_partly;
    cut_.spare -= node.children - 1;
    return Choice::divide;
  }
  // After divide_partly: how many parts become samples of their own. Nothing is left to share out then.
  std::size_t take_spare() { return static_cast<std::size_t>(std::exchange(cut_.spare, 0)); }
  // The samples that may still be added. What they are spent on may be decided elsewhere.
  std::uint64_t spare() const { return cut_.spare; }
  void spend(std::uint64_t samples) { cut_.spare -= std::min(cut_.spare, samples); }

 private:
  Cut cut_;
};

// Hands samples on, and tells their cells how many there are.
class CellSamples {
 public:
  CellSamples(const EmitSample& emit, std::vector<SampledCell>& cells) : emit_(emit), cells_(cells) {}

  void add(const PlacedCluster& sample);
  // Adds the `single` parts with the greatest errors, and one sample for all others.
  void add_some(std::vector<PlacedCluster>& parts, std::size_t single, const ClusterNode& whole);
  // The samples since the last call belong to these cells.
  void finish(std::size_t first, std::size_t last);

 private:
  const EmitSample& emit_;
  std::vector<SampledCell>& cells_;
  std::uint64_t begin_ = 0;
  std::uint64_t count_ = 0;
  double squares_ = 0;
  double points_ = 0;
};

}  // namespace glark::stream
