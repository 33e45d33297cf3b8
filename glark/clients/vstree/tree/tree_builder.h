// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Builds a volume-surface tree. A task sorts the samples of one node by several levels of cells. A NodeWriter turns the
// cells into nodes.
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <span>
#include <vector>

#include "glark/clients/vstree/tree/cells.h"
#include "glark/clients/vstree/tree/construction.h"

namespace glark::vstree {

// A node whose samples are to be divided.
struct Task {
  std::uint32_t slot = 0;            // the slot of the node
  std::span<Record> records, other;  // the samples, and a buffer of the same size
  bool is_alone = false;             // a single thread does the whole task, and owns the buffer
  bool enters_surface = false;       // the node becomes a transition node
  Moments moments = {};              // the moments of a future transition node
  unsigned depth = 0;                // the depth below the root of the octree or the quadtree
  LocalFrame frame = {};             // the frame of the quadtree

  std::size_t size() const { return records.size(); }
};

class TreeBuilder {
 public:
  struct Input {
    const PointSet& points;
    const Cube& cube;
    const Options& options;
    const Workers& workers;
    bool keeps_records = false;  // sorted() is wanted
    bool ends_at_layer = false;  // transition nodes are leaves
  };
  TreeBuilder(const Input& input, std::vector<std::uint32_t>& order);

  Nodes run();
  Records sorted() { return std::move(buffers_[0]); }

  // For NodeWriter:
  const Options& options() const { return input_.options; }
  bool ends_at_layer() const { return input_.ends_at_layer; }
  // Moments may be null where the metric counts samples.
  float error_of(const Moments* moments, std::span<const Record> records) const;
  bool is_leaf(const Node& node, std::span<const Record> records) const;
  // Fixes the order of the samples of a leaf.
  void close(std::uint32_t begin, std::span<const Record> records);
  void divide(Nodes& out, Task& task);
  void divide_all(Nodes& out, std::vector<Task>& tasks);

 private:
  std::vector<std::uint32_t> fill(unsigned levels);
  Cells sort_cubes(const Task& task);
  Cells sort_rectangles(const Task& task);
  Cells cells_of(std::span<const Record> sorted, std::span<const std::uint32_t> begins, unsigned levels, Kind kind);
  static void enter_surface(Nodes& out, Task& task);
  static void append(Nodes& out, const Nodes& part, std::span<const Task> tasks);

  const Input input_;
  std::vector<std::uint32_t>& order_;
  Records buffers_[2];
  tbb::enumerable_thread_specific<Records> rooms_;  // buffers for tasks of one thread, small enough for its cache
};

}  // namespace glark::vstree
