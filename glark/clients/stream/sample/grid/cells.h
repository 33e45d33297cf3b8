// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The cells of the coarse grid: cubes of the octree with at most so many points, so that a cell's points fit into
// memory. Based on: Boubekeur 2007, ch. 4.3, whose grid has cells of one size.
#pragma once

#include <vector>

#include "glark/clients/stream/sample/grid/census.h"

namespace glark::stream {

struct Cell {
  std::uint64_t key = 0;    // the Morton code of its first cube
  std::uint32_t level = 0;  // it has 2^level cubes along an edge
  std::uint64_t count = 0;
  std::uint64_t first = Cube::no_key, last = 0;  // the range of the stream that has its points
};

struct CellLimits {
  std::uint64_t points = 1;  // the most of a cell
  unsigned least_level = 0;  // that of the cubes that were counted
  unsigned most_level = Lattice::levels;
};

// Returns the cells in the order of their keys. A cube that was counted is not divided, whatever it has.
std::vector<Cell> cells_of(const std::vector<Cube>& cubes, const CellLimits& limits);

// Estimates the greatest number of points that are in unfinished cells at one time, if the stream is read in order. A
// cell is assumed to fill evenly between its first and its last point.
double most_open_points(const std::vector<Cell>& cells);

// Returns the index of the cell that has the cube, or none.
std::size_t cell_of(const std::vector<Cell>& cells, std::uint64_t key);

}  // namespace glark::stream
