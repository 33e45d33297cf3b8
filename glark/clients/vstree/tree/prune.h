// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "glark/clients/vstree/tree/construction.h"

namespace glark::vstree {

// The error of each node, but no less than that of a node below it.
std::vector<float> monotone_errors(std::span<const Node> nodes);

// Counts the leaves that remain when nodes with at most a threshold's error become leaves.
class LeafCounts {
 public:
  struct Division {
    float error;
    std::uint32_t leaves;  // how many more leaves this division makes
  };
  explicit LeafCounts(std::vector<Division> divisions);
  static LeafCounts of(std::span<const Node> nodes, std::span<const float> errors);
  // The least threshold that leaves at most so many leaves, but at least one.
  float threshold_for(std::size_t leaves) const;

 private:
  std::vector<Division> divisions_;
  std::vector<std::uint32_t> more_leaves_;  // of all divisions of each class of errors, the least errors first
};

// Turns nodes with at most the threshold's error into leaves and removes what lies below them.
void prune(Nodes& tree, std::span<const float> errors, float threshold);

}  // namespace glark::vstree
