// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/prune.h"

#include <algorithm>

namespace glark::vstree {
std::vector<float> monotone_errors(std::span<const Node> nodes) {
  std::vector<float> errors(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {  // children come after their parents
    errors[i] = nodes[i].error;
    if (nodes[i].is_leaf()) continue;
    for (std::uint32_t k = 0; k < nodes[i].child_count(); ++k)
      errors[i] = std::max(errors[i], errors[nodes[i].first_child + k]);
  }
  return errors;
}

LeafCounts::LeafCounts(std::span<const Node> nodes, std::span<const float> errors) {
  divisions_.reserve(nodes.size() / 2);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].is_leaf()) divisions_.push_back({errors[i], nodes[i].child_count() - 1});
  }
  std::sort(divisions_.begin(), divisions_.end(),
            [](const Division& a, const Division& b) { return a.error > b.error; });
  std::uint32_t leaves = 1;
  for (std::size_t i = 0; i < divisions_.size();) {
    const std::size_t begin = i;  // what has one error is divided together
    for (; i < divisions_.size() && divisions_[i].error == divisions_[begin].error; ++i) leaves += divisions_[i].leaves;
    for (std::size_t k = begin; k < i; ++k) divisions_[k].leaves = leaves;
  }
}

float LeafCounts::threshold_for(std::size_t leaves) const {
  const auto first_too_many = std::partition_point(divisions_.begin(), divisions_.end(),
                                                   [&](const Division& division) { return division.leaves <= leaves; });
  return first_too_many == divisions_.end() ? -1 : first_too_many->error;
}

void prune(Nodes& tree, std::span<const float> errors, float threshold) {
  std::vector<std::uint32_t> moved(tree.nodes.size(), none);
  std::uint32_t kept = 0;
  if (!tree.nodes.empty()) moved[0] = kept++;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    Node& node = tree.nodes[i];
    if (moved[i] == none || node.is_leaf()) continue;
    if (errors[i] <= threshold) {
      node.first_child = 0;
      node.children = node.joined = 0;
      continue;
    }
    for (std::uint32_t k = 0; k < node.child_count(); ++k) moved[node.first_child + k] = kept++;
  }
  std::vector<Node> nodes(kept);
  std::vector<std::uint32_t> frame_moved(tree.frames.size(), none);
  Nodes result;
  for (std::size_t i = 0; i < tree.frames.size(); ++i) {
    if (moved[tree.frame_nodes[i]] == none) continue;
    frame_moved[i] = static_cast<std::uint32_t>(result.frames.size());
    result.frames.push_back(tree.frames[i]);
    result.frame_nodes.push_back(moved[tree.frame_nodes[i]]);
  }
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (moved[i] == none) continue;
    Node& node = nodes[moved[i]] = tree.nodes[i];
    if (!node.is_leaf()) node.first_child = moved[node.first_child];
    if (node.frame != none) node.frame = frame_moved[node.frame];
  }
  result.nodes = std::move(nodes);
  tree = std::move(result);
}

}  // namespace glark::vstree
