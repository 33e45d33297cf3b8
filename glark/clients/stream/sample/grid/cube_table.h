// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The occupied cubes of the first pass. Their number is bounded, whatever the points fill.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace glark::stream {

// A cube of the octree over the lattice that has points.
struct Cube {
  static constexpr std::uint64_t no_key = ~std::uint64_t{0};
  std::uint64_t key = no_key;  // the Morton code of its first cube of the lattice
  std::uint64_t count = 0;
  std::uint64_t first = no_key, last = 0;  // indices of points

  // Adds what is counted in a cube within this one.
  void add(const Cube& part);
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
  // Calls step(cube) for each cube, in any order.
  template <class Step>
  void each(const Step& step) const {
    for (const Cube& cube : slots_)
      if (cube.key != Cube::no_key) step(cube);
  }
  void clear();

 private:
  static std::size_t place(std::uint64_t key, std::size_t slots) {
    return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15U) >> 32) & (slots - 1);
  }
  void grow();

  std::vector<Cube> slots_;  // a power of two
  std::size_t used_ = 0;
};

// The cubes of one level of the octree, which is the finest one that has no more than `most` occupied cubes. So the
// result does not depend on the order in which cubes are added.
class BoundedCubes {
 public:
  // most: a power of two.
  explicit BoundedCubes(std::size_t most) : most_(most) {}
  // The cube has the size of level() or less.
  void add(const Cube& cube);
  // No cube is smaller than those of this level.
  void coarsen_to(unsigned level);
  // A cube has 2^level cubes of the lattice along an edge.
  unsigned level() const { return level_; }
  std::vector<Cube> sorted() const { return table_.sorted(); }

 private:
  CubeTable table_;
  std::size_t most_;
  unsigned level_ = 0;
};

// The key of the cube of a level that has the cube with this key.
inline std::uint64_t key_at_level(std::uint64_t key, unsigned level) { return key >> (3 * level) << (3 * level); }

}  // namespace glark::stream
