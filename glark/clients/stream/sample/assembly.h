// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The last step: one threshold for all cells, and the samples that it leaves.
#pragma once

#include "glark/clients/stream/sample/chosen_clusters.h"
#include "glark/clients/stream/sample/pass/cell_pass.h"

namespace glark::stream {

class Assembly {
 public:
  Assembly(const Plan& plan, const TreeStore& trees);

  // Leaves `target` samples, but at least one, and no more than there are leaves.
  Cut cut_for(std::uint64_t target) const;
  // Calls `emit` for each sample, cell by cell. Sets the samples and the errors of the cells.
  void select(const Cut& cut, const EmitSample& emit, std::vector<SampledCell>& cells) const;

 private:
  // A cube of the octree that has several cells.
  struct Volume {
    ClusterNode node{};
    std::array<double, 3> centre{};   // that node.position is relative to
    std::size_t first = 0, last = 0;  // its cells
    std::size_t after = 0;            // the next volume in preorder that is not below
  };
  struct Part {
    Shape shape;  // relative to `centre`
    std::array<double, 3> centre{};
    float error = 0;
  };

  Part build(std::size_t first, std::size_t last, unsigned level);
  void count_divisions();
  std::vector<PlacedCluster> parts_of(std::size_t volume) const;
  void select_in_cell(std::size_t cell, Chooser& chooser, CellSamples& samples) const;
  void add_division(float error, std::uint32_t leaves);

  const Plan& plan_;
  const TreeStore& trees_;
  std::vector<Volume> volumes_;             // in preorder
  std::vector<std::uint64_t> more_leaves_;  // that the divisions of a class of errors add; the least errors first
};

}  // namespace glark::stream
