// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/tree/prune.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace glark::vstree {
namespace {

constexpr unsigned class_shift = 20;
constexpr std::size_t classes = std::size_t{1} << (31 - class_shift);

// Errors of one class begin with the same bits. For positive floats, the order of the bits is the order of the numbers.
std::size_t class_of(float error) { return (std::bit_cast<std::uint32_t>(error) & 0x7FFFFFFFU) >> class_shift; }

}  // namespace

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

LeafCounts::LeafCounts(std::vector<Division> divisions) : divisions_(std::move(divisions)), more_leaves_(classes) {
  for (const Division& division : divisions_) more_leaves_[class_of(division.error)] += division.leaves;
}

LeafCounts LeafCounts::of(std::span<const Node> nodes, std::span<const float> errors) {
  std::vector<Division> divisions;
  divisions.reserve(nodes.size() / 2);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].is_leaf()) divisions.push_back({errors[i], nodes[i].child_count() - 1});
  }
  return LeafCounts(std::move(divisions));
}

float LeafCounts::threshold_for(std::size_t leaves) const {
  std::size_t count = 1;
  std::size_t last = classes;
  while (last > 0 && count + more_leaves_[last - 1] <= leaves) count += more_leaves_[--last];
  if (last == 0) return -1;
  std::vector<Division> some;  // the class that contains the limit
  for (const Division& division : divisions_) {
    if (class_of(division.error) == last - 1) some.push_back(division);
  }
  std::sort(some.begin(), some.end(), [](const Division& a, const Division& b) { return a.error > b.error; });
  for (std::size_t i = 0; i < some.size();) {
    const float error = some[i].error;  // nodes with equal errors are divided together
    for (; i < some.size() && some[i].error == error; ++i) count += some[i].leaves;
    if (count > leaves) return error;
  }
  return some.back().error;
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
