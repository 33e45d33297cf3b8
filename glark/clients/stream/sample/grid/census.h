// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The first pass: the number of points in each cube of the lattice, and the range of the stream that has them.
#pragma once

#include <vector>

#include "glark/clients/common/resume/checkpoints.h"
#include "glark/clients/stream/sample/grid/block_source.h"
#include "glark/clients/stream/sample/grid/cube_table.h"
#include "glark/clients/stream/sample/grid/lattice.h"

namespace glark::stream {

struct Census {
  Lattice lattice;
  unsigned level = 0;       // a cube has 2^level cubes of the lattice along an edge
  std::vector<Cube> cubes;  // sorted by key
  std::uint64_t points = 0;
  std::uint64_t left_out = 0;  // with coordinates that are not finite
  std::array<double, 3> low{}, high{};

  // The logarithm of the number of smaller cubes, half as long, that an occupied cube has: 2 for surfaces, up to 3 for
  // points that fill a volume.
  double dimension() const;
  double diagonal() const { return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]); }
};

// Chooses the lattice by some points of the source: their box, without outliers, has 2^levels cubes along an edge.
Lattice choose_lattice(const Source& source, const ReadOptions& options, unsigned levels);

using Advance = std::function<void(std::uint64_t points)>;  // gets the number of points that are done

struct CensusOptions {
  Lattice lattice;
  std::size_t most_cubes = std::size_t{1} << 16;  // a power of two; more occupied ones are merged, eight into one
  std::size_t threads = 1;
  std::uint64_t begin = 0, end = Cube::no_key;  // the points to count; without seeking, all of them
};

// Points whose coordinates are not finite are left out; the reader may throw Error for them. Continues from a saved state.
Census take_census(BlockSource& source, const CensusOptions& options, const Advance& advance,
                   common::Checkpoints& checkpoints);

}  // namespace glark::stream
