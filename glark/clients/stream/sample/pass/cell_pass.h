// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The second pass: from the points of a source to the tree of each cell.
#pragma once

#include <optional>

#include "glark/clients/stream/sample/pass/plan.h"
#include "glark/clients/stream/sample/pass/tree_store.h"

namespace glark::stream {

// What points have, and where their numbers lie.
struct PointKind {
  bool has_normals = false;
  std::array<std::size_t, 3> colour{none, none, none};  // channels
  double colour_scale = 1;                              // to bytes
  std::size_t channels = 0;

  explicit PointKind(const Schema& schema);
  bool has_colours() const { return colour[0] != none; }
  std::array<std::uint8_t, 4> colour_of(const Points& points, std::size_t i) const;
};

struct PassInput {
  BlockSource& source;
  const Census& census;
  const Plan& plan;
  const common::Workers& workers;
  Advance advance;
  common::Checkpoints& checkpoints;
};

// Both passes continue from a saved state.

// Reads the points in order. Returns false if the unfinished cells take more memory than the plan allows.
// Throws Error if the source is not the one that was counted.
bool stream_cells(const PassInput& input, TreeStore& trees);
// Sorts the points into a file of cells, then reads cell by cell.
void sort_into_cells(const PassInput& input, const std::filesystem::path& folder, TreeStore& trees);

}  // namespace glark::stream
