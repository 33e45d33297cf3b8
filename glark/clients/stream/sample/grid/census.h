// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The first pass: the number of points in each cube of the lattice, and the range of the stream that has them.
#pragma once

#include <vector>

#include "glark/clients/stream/files/checkpoints.h"
#include "glark/clients/stream/sample/grid/block_source.h"
#include "glark/clients/stream/sample/grid/lattice.h"

namespace glark::stream {

// A cube of the lattice that has points.
struct Cube {
  static constexpr std::uint64_t no_key = ~std::uint64_t{0};
  std::uint64_t key = no_key;
  std::uint64_t count = 0;
  std::uint64_t first = no_key, last = 0;  // indices of points
};

// Cubes by their keys: an open hash table that grows.
class CubeTable {
 public:
  CubeTable() : slots_(1 << 10) {}
  // The cube with the key; a new one has no points.
  Cube& at(std::uint64_t key);
  const Cube* find(std::uint64_t key) const;
  std::size_t size() const { return used_; }
  std::vector<Cube> sorted() const;  // by key

 private:
  static std::size_t place(std::uint64_t key, std::size_t slots) {
    return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15U) >> 32) & (slots - 1);
  }
  void grow();

  std::vector<Cube> slots_;  // a power of two
  std::size_t used_ = 0;
};

struct Census {
  Lattice lattice;
  std::vector<Cube> cubes;  // sorted by key
  std::uint64_t points = 0;
  std::uint64_t left_out = 0;  // with coordinates that are not finite
  std::array<double, 3> low{}, high{};

  double diagonal() const { return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]); }
};

// Chooses the lattice by some points of the source: their box, without outliers, has 2^levels cubes along an edge.
Lattice choose_lattice(const Source& source, const ReadOptions& options, unsigned levels);

using Advance = std::function<void(std::uint64_t points)>;  // gets the number of points that are done

// Points whose coordinates are not finite are left out; the reader may throw Error for them. Continues from a saved state.
Census take_census(BlockSource& source, const Lattice& lattice, const Advance& advance, Checkpoints& checkpoints);

}  // namespace glark::stream
