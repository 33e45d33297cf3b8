// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/assembly.h"

#include <algorithm>
#include <bit>

namespace glark::stream {
namespace {

// Errors of one class begin with the same bits. For positive floats, the order of the bits is the order of the numbers.
constexpr unsigned class_shift = 13;  // steps of 2^-10
constexpr std::size_t classes = std::size_t{1} << (31 - class_shift);
std::size_t class_of(float error) { return (std::bit_cast<std::uint32_t>(error) & 0x7FFFFFFFU) >> class_shift; }

std::array<double, 3> sum(const std::array<double, 3>& a, const std::array<float, 3>& b) {
  return {a[0] + static_cast<double>(b[0]), a[1] + static_cast<double>(b[1]), a[2] + static_cast<double>(b[2])};
}

// Hands samples on, and tells their cells how many there are.
class CellSamples {
 public:
  CellSamples(const EmitSample& emit, std::vector<SampledCell>& cells) : emit_(emit), cells_(cells) {}

  void add(const std::array<double, 3>& centre, const ClusterNode& node) {
    emit_(sum(centre, node.position), node);
    squares_ += static_cast<double>(node.square);
    points_ += static_cast<double>(node.count);
    ++count_;
  }
  // The samples since the last call belong to these cells.
  void finish(std::size_t first, std::size_t last) {
    for (std::size_t cell = first; cell < last; ++cell) {
      cells_[cell].first_sample = begin_;
      cells_[cell].samples = count_ - begin_;
      cells_[cell].error = points_ > 0 ? std::sqrt(squares_ / points_) : 0;
    }
    squares_ = points_ = 0;
    begin_ = count_;
  }

 private:
  const EmitSample& emit_;
  std::vector<SampledCell>& cells_;
  std::uint64_t begin_ = 0;
  std::uint64_t count_ = 0;
  double squares_ = 0;
  double points_ = 0;
};

}  // namespace

Assembly::Assembly(const Plan& plan, const TreeStore& trees) : plan_(plan), trees_(trees), more_leaves_(classes) {
  if (!plan.cells.empty()) build(0, plan.cells.size(), Lattice::levels);
  count_divisions();
}

// The shape and the error of the cells of one cube of the octree. Cubes with one child are no nodes.
Assembly::Part Assembly::build(std::size_t first, std::size_t last, unsigned level) {
  if (last - first == 1) {
    const TreeStore::Root root = trees_.root(first);
    return {root.shape, plan_.centre(first), root.error};
  }
  const auto child_at = [&](std::size_t cell, unsigned at) { return plan_.cells[cell].key >> (3 * (at - 1)); };
  while (child_at(first, level) == child_at(last - 1, level)) --level;
  const std::size_t slot = volumes_.size();
  volumes_.push_back({.first = first, .last = last});
  Part whole;
  whole.centre = plan_.centre(first);
  std::uint32_t children = 0;
  for (std::size_t begin = first; begin < last; ++children) {
    std::size_t end = begin + 1;
    while (end < last && child_at(end, level) == child_at(begin, level)) ++end;
    const Part part = build(begin, end, level - 1);
    std::array<double, 3> by{};
    for (std::size_t k = 0; k < 3; ++k) by[k] = part.centre[k] - whole.centre[k];
    whole.shape.add(part.shape.moved(by));
    whole.error = std::max(whole.error, part.error);
    begin = end;
  }
  whole.error = std::max(whole.error, cluster_error(whole.shape, plan_.by_error, first));
  Volume& volume = volumes_[slot];
  volume.node = node_of(whole.shape, whole.error);
  volume.node.children = children;
  volume.centre = whole.centre;
  volume.after = volumes_.size();
  return whole;
}

void Assembly::add_division(float error, std::uint32_t leaves) { more_leaves_[class_of(error)] += leaves; }

void Assembly::count_divisions() {
  for (const Volume& volume : volumes_) add_division(volume.node.error, volume.node.children - 1);
  std::vector<ClusterNode> nodes;
  for (std::size_t cell = 0; cell < plan_.cells.size(); ++cell) {
    trees_.read(cell, nodes);
    for (const ClusterNode& node : nodes)
      if (node.children > 1) add_division(node.error, node.children - 1);
  }
}

float Assembly::threshold_for(std::uint64_t target) const {
  std::uint64_t count = 1;
  std::size_t last = classes;
  while (last > 0 && count + more_leaves_[last - 1] <= target) count += more_leaves_[--last];
  if (last == 0) return -1;
  // The greatest number of the class.
  return std::bit_cast<float>(static_cast<std::uint32_t>((last << class_shift) - 1));
}

void Assembly::select(float threshold, const EmitSample& emit, std::vector<SampledCell>& cells) const {
  std::vector<ClusterNode> nodes;
  CellSamples samples(emit, cells);
  std::size_t volume = 0;
  for (std::size_t cell = 0; cell < plan_.cells.size();) {
    // Volumes that begin at this cell, the largest first.
    while (volume < volumes_.size() && volumes_[volume].first == cell && !(volumes_[volume].node.error <= threshold))
      ++volume;
    if (volume < volumes_.size() && volumes_[volume].first == cell) {
      const Volume& whole = volumes_[volume];
      samples.add(whole.centre, whole.node);
      samples.finish(cell, whole.last);
      cell = whole.last;
      volume = whole.after;
      continue;
    }
    trees_.read(cell, nodes);
    for (std::size_t i = 0; i < nodes.size();) {
      const ClusterNode& node = nodes[i];
      const bool is_sample = node.children == 0 || node.error <= threshold;
      if (is_sample) samples.add(plan_.centre(cell), node);
      i += is_sample ? node.size : 1;
    }
    samples.finish(cell, cell + 1);
    ++cell;
  }
}

}  // namespace glark::stream
