// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "glark/clients/vstree/tree/construction.h"

namespace glark::vstree {

// What a node is worth dividing: its error, and no less than that of any node below it.
std::vector<float> monotone_errors(std::span<const Node> nodes);

// How many leaves are left when the nodes with no greater error than a threshold become leaves.
class LeafCounts {
 public:
  struct Division {
    float error;
    std::uint32_t leaves;  // how many more there are by this one
  };
  explicit LeafCounts(std::vector<Division> divisions);
  static LeafCounts of(std::span<const Node> nodes, std::span<const float> errors);
  // The least threshold that leaves no more than so many, but one.
  float threshold_for(std::size_t leaves) const;

 private:
  std::vector<Division> divisions_;
  std::vector<std::uint32_t> more_leaves_;  // by all divisions of a class of errors, the least errors first
};

// Turns those nodes into leaves and removes what lies below.
void prune(Nodes& tree, std::span<const float> errors, float threshold);

}  // namespace glark::vstree
