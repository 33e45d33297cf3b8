// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The sheets of the surface in a cell whose edges may be crossed several times.
//
// On each face, the surface is a set of lines between crossings. Lines do not cross each other. Of all possible sets of
// lines, the one is taken whose ends have the most similar normals, so that the two sides of a thin sheet stay apart.
// Both cells of a face take the same lines. The lines form circles around the cell: each circle is a sheet.
#pragma once

#include <array>
#include <vector>

#include "glark/clients/common/disjoint_sets.h"
#include "glark/clients/reconstruct/contour/thin_edges.h"

namespace glark::reconstruct {

// A crossing on the boundary of a face.
struct FaceCrossing {
  std::uint32_t number = 0;
  Float4 point{}, normal{};
};

// Returns for each crossing the other end of its line. The crossings follow one another around the face. Their number
// is even.
std::vector<std::uint32_t> lines_of_face(const std::vector<FaceCrossing>& around);

class ThinCell {
 public:
  // values: of the eight corners. edges: the crossings of those edges that were looked at.
  ThinCell(const CellIndex& cell, const std::array<float, 8>& values, const ThinEdges& edges);

  const CellIndex& cell() const { return cell_; }
  bool is_inside(unsigned corner) const { return ((inside_ >> corner) & 1U) != 0; }
  // The points of the sheets, relative to the low corner, in cells.
  const std::vector<Float4>& sheets() const { return sheets_; }
  std::uint32_t crossings_of(unsigned edge) const { return begins_[edge + 1] - begins_[edge]; }
  std::uint32_t sheet_of(unsigned edge, std::uint32_t which) const { return sheet_[begins_[edge] + which]; }

 private:
  void gather_crossings(const std::array<float, 8>& values, const ThinEdges& edges);
  void join_face(const std::array<unsigned, 4>& corners, DisjointSets& joined) const;
  void number_sheets(DisjointSets& joined);

  CellIndex cell_;
  unsigned inside_ = 0;                     // a bit for each corner
  std::array<std::uint32_t, 13> begins_{};  // of the crossings of each edge
  std::vector<Float4> points_, normals_;    // of the crossings
  std::vector<std::uint32_t> sheet_;        // of each crossing
  std::vector<Float4> sheets_;
};

// The cells around the edges that are crossed more than once, and beside the faces whose four edges are crossed.
std::vector<ThinCell> thin_cells(const ThinEdges& edges, const Blocks& blocks);

}  // namespace glark::reconstruct
