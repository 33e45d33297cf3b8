// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "glark/clients/vstree/tree/construction.h"

namespace glark::vstree {

// Returns the error of each node, but no less than the error of a node below it.
std::vector<float> monotone_errors(std::span<const Node> nodes);

// Counts the leaves that remain when nodes with at most a threshold's error become leaves.
class LeafCounts {
 public:
  struct Division {
    float error;
    std::uint32_t leaves;  // the number of leaves that this division adds
  };
  explicit LeafCounts(std::vector<Division> divisions);
  static LeafCounts of(std::span<const Node> nodes, std::span<const float> errors);
  // Returns the least threshold that leaves at most `leaves` leaves, but at least one.
  float threshold_for(std::size_t leaves) const;

 private:
  std::vector<Division> divisions_;
  // The leaves that all divisions of each class of errors add; the least errors first.
  std::vector<std::uint32_t> more_leaves_;
};

// Turns nodes whose error is within the threshold into leaves, and removes the nodes below them.
void prune(Nodes& tree, std::span<const float> errors, float threshold);

}  // namespace glark::vstree
