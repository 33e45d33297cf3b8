// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The last step: one threshold for all cells, and the samples that it leaves.
#pragma once

#include "glark/clients/stream/sample/divisions.h"
#include "glark/clients/stream/sample/pass/cell_pass.h"

namespace glark::stream {

// Adds the samples of a cell in the order of its tree.
using SelectCell = std::function<void(std::size_t cell, Chooser& chooser, CellSamples& samples)>;

// The parts of an assembly that need the tree of one cell only.
void add_divisions(const TreeStore& trees, std::size_t cell, Divisions& divisions);
void select_in_cell(const Plan& plan, const TreeStore& trees, std::size_t cell, Chooser& chooser, CellSamples& samples);

class Assembly {
 public:
  // trees: of all cells; their first nodes suffice. of_cells: the divisions of all nodes of the trees.
  Assembly(const Plan& plan, const TreeStore& trees, const Divisions& of_cells);

  Cut cut_for(std::uint64_t target) const { return divisions_.cut_for(target); }
  // Calls `emit` for each sample, cell by cell; select_cell has those of a cell. Sets the samples and the errors of the
  // cells.
  void select(const Cut& cut, const SelectCell& select_cell, const EmitSample& emit,
              std::vector<SampledCell>& cells) const;

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
  std::vector<PlacedCluster> parts_of(std::size_t volume) const;

  const Plan& plan_;
  const TreeStore& trees_;
  std::vector<Volume> volumes_;  // in preorder
  Divisions divisions_;
};

}  // namespace glark::stream
