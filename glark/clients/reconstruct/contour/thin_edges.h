// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The edges of the grid near thin sheets. An edge may cross such a sheet twice or more often, although both of its
// corners lie on the same side.
#pragma once

#include <span>

#include "glark/clients/reconstruct/contour/blocks.h"

namespace glark::reconstruct {

// A point of an edge where the surface crosses it.
struct Crossing {
  float at = 0;     // 0 to 1, along the edge
  Float4 normal{};  // of the surface
};

// Edges run along axis 0, 1 or 2 from their lower corner.
class ThinEdges {
 public:
  // Crossings are in order along the edge. Crossings from the inside to the outside alternate with the others.
  void add(const CellIndex& corner, unsigned axis, std::span<const Crossing> crossings);
  std::span<const Crossing> find(const CellIndex& corner, unsigned axis) const;
  struct Edge {
    CellIndex corner;
    unsigned axis;
  };
  const std::vector<Edge>& all() const { return edges_; }

 private:
  CellTable table_;
  std::vector<std::uint32_t> begins_{0};
  std::vector<Crossing> crossings_;
  std::vector<Edge> edges_;
};

// Evaluates the corners near thin sheets again, with both sides, and finds the crossings of the edges there.
ThinEdges cross_thin_edges(const TransitionLayer& layer, unsigned level, Blocks& blocks, const Workers& workers);

}  // namespace glark::reconstruct
