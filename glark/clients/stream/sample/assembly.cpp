// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/assembly.h"

#include <algorithm>

namespace glark::stream {
namespace {

std::array<double, 3> sum(const std::array<double, 3>& a, const std::array<float, 3>& b) {
  return {a[0] + static_cast<double>(b[0]), a[1] + static_cast<double>(b[1]), a[2] + static_cast<double>(b[2])};
}

}  // namespace

Assembly::Assembly(const Plan& plan, const TreeStore& trees, const Divisions& of_cells)
    : plan_(plan), trees_(trees), divisions_(of_cells) {
  if (!plan.cells.empty()) build(0, plan.cells.size(), Lattice::levels);
  for (const Volume& volume : volumes_) divisions_.add(volume.node.error, volume.node.children - 1);
}

void add_divisions(const TreeStore& trees, std::size_t cell, Divisions& divisions) {
  std::vector<ClusterNode> nodes;
  trees.read(cell, nodes);
  for (const ClusterNode& node : nodes)
    if (node.children > 1) divisions.add(node.error, node.children - 1);
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

// Returns the clusters one level below a volume.
std::vector<PlacedCluster> Assembly::parts_of(std::size_t volume) const {
  std::vector<PlacedCluster> parts;
  std::vector<ClusterNode> nodes;
  std::size_t next = volume + 1;
  for (std::size_t cell = volumes_[volume].first; cell < volumes_[volume].last;) {
    if (next < volumes_.size() && volumes_[next].first == cell) {
      const Volume& part = volumes_[next];
      parts.push_back({sum(part.centre, part.node.position), part.node});
      cell = part.last;
      next = part.after;
      continue;
    }
    trees_.read(cell, nodes);
    parts.push_back({sum(plan_.centre(cell), nodes[0].position), nodes[0]});
    ++cell;
  }
  return parts;
}

void Assembly::select(const Cut& cut, const SelectCell& select_cell, const EmitSample& emit,
                      std::vector<SampledCell>& cells) const {
  CellSamples samples(emit, cells);
  Chooser chooser(cut);
  std::size_t volume = 0;
  for (std::size_t cell = 0; cell < plan_.cells.size();) {
    Chooser::Choice choice = Chooser::Choice::divide;
    // Volumes that begin at this cell, the largest first.
    for (; volume < volumes_.size() && volumes_[volume].first == cell; ++volume)
      if (choice = chooser.choose(volumes_[volume].node); choice != Chooser::Choice::divide) break;
    if (choice == Chooser::Choice::divide) {
      select_cell(cell, chooser, samples);
      samples.finish(cell, cell + 1);
      ++cell;
      continue;
    }
    const Volume& whole = volumes_[volume];
    if (choice == Chooser::Choice::sample) {
      samples.add({sum(whole.centre, whole.node.position), whole.node});
    } else {
      std::vector<PlacedCluster> parts = parts_of(volume);
      samples.add_some(parts, chooser.take_spare(), whole.node);
    }
    samples.finish(cell, whole.last);
    cell = whole.last;
    volume = whole.after;
  }
}

void select_in_cell(const Plan& plan, const TreeStore& trees, std::size_t cell, Chooser& chooser,
                    CellSamples& samples) {
  std::vector<ClusterNode> nodes;
  trees.read(cell, nodes);
  const auto placed = [&](const ClusterNode& node) {
    return PlacedCluster{sum(plan.centre(cell), node.position), node};
  };
  for (std::size_t i = 0; i < nodes.size();) {
    const ClusterNode& node = nodes[i];
    const Chooser::Choice choice = chooser.choose(node);
    if (choice == Chooser::Choice::sample) samples.add(placed(node));
    if (choice == Chooser::Choice::divide_partly) {
      std::vector<PlacedCluster> parts;
      for (std::size_t part = i + 1; part < i + node.size; part += nodes[part].size)
        parts.push_back(placed(nodes[part]));
      samples.add_some(parts, chooser.take_spare(), node);
    }
    i += choice == Chooser::Choice::divide ? 1 : node.size;
  }
}

}  // namespace glark::stream
