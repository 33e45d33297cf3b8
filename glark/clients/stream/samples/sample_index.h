// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A k-d tree of positions.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "glark/clients/common/vector.h"
#include "glark/clients/stream/samples/nearest_set.h"

namespace glark::stream {

// A sample of one of several trees, the cells.
struct CellSample {
  float square = 0;
  std::uint32_t index = 0;  // in the sampling
  std::uint32_t cell = 0;
  std::uint32_t place = 0;  // in the cell
};

// The samples of a cell: those at the places 0, 1, 2 ... have these indices in the sampling.
struct CellIndices {
  std::uint32_t cell = 0;
  std::span<const std::uint32_t> indices;
};

class SampleIndex {
 public:
  // The positions must stay where they are.
  explicit SampleIndex(const std::vector<common::Vector3f>& positions);
  ~SampleIndex();

  std::size_t size() const;
  // Finds the `count` nearest positions, or all if there are fewer. Several threads may call it.
  void nearest(const common::Vector3f& point, std::size_t count, std::vector<NearSample>& found) const;
  // Adds the positions that are nearer than others in the set.
  void add_nearest(const common::Vector3f& point, const CellIndices& samples, NearestSet<CellSample>& set) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

// A place so far away that the squares of its distances would be infinite, moved to where they are not.
common::Vector3f within_floats(const common::Vector3f& point);

}  // namespace glark::stream
