// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Turns the cells of one sort into nodes, from the coarsest cell to the finest ones.
#pragma once

#include <vector>

#include "glark/clients/vstree/tree/tree_builder.h"

namespace glark::vstree {

class NodeWriter {
 public:
  // sorted: the task whose samples were sorted into the cells.
  NodeWriter(TreeBuilder& builder, Nodes& out, const Cells& cells, const Task& sorted, Kind kind)
      : builder_(builder),
        out_(out),
        cells_(cells),
        sorted_(sorted),
        kind_(kind),
        begin_(out.nodes[sorted.slot].begin) {}

  // Writes all nodes below the node in the slot. This node is cell `index` of the level.
  void write_children(std::uint32_t slot, unsigned level, std::uint32_t index);
  // Decides whether the node is a leaf, a transition node, or has children.
  void write_node(std::uint32_t slot, unsigned level, std::uint32_t index);
  // Divides the nodes that need another sort.
  void finish() { builder_.divide_all(out_, tasks_); }

 private:
  struct Pairs;

  std::span<Record> records_of(unsigned level, std::uint32_t index) const;
  float error_of(unsigned level, std::uint32_t a, std::uint32_t b) const;
  bool close_in_pairs(std::uint32_t slot, unsigned level, std::uint32_t first, std::uint32_t last);
  void write_pairs(std::uint32_t slot, unsigned level, const Pairs& pairs);
  Task task_of(std::uint32_t slot, unsigned depth) const;
  void hand_over(Task& task);

  TreeBuilder& builder_;
  Nodes& out_;
  const Cells& cells_;
  const Task& sorted_;
  const Kind kind_;
  const std::uint32_t begin_;     // the first sample
  std::vector<Record> together_;  // the samples of a pair of quadrants
  std::vector<Task> tasks_;
};

}  // namespace glark::vstree
