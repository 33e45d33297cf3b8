// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Triangles of a patch as one triangle strip.
// Based on: Boubekeur 2007, ch. 5.2.3. A greedy walk that turns where it has to (a vertex twice), tried from several triangles:
// patches are small enough for that, and so small that what matters is the number of runs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace glark::surfel {

using StripTriangle = std::array<std::uint32_t, 3>;  // counter-clockwise

// Makes strips, one after the other, in memory that it keeps.
class Stripper {
 public:
  // One strip that has all the triangles with their orientation, and others without area. Valid until the next one.
  std::span<const std::uint32_t> strip(std::span<const StripTriangle> triangles);

 private:
  struct Start {
    std::uint32_t triangle;
    std::uint32_t first;  // corner
    int patience;         // by how many more free neighbours the triangle ahead may have than the one that takes a turn
  };

  void find_neighbours();
  void find_starts();
  void cover(const Start& start);
  bool step(int patience);
  void begin_run();
  void enter(std::uint32_t triangle);
  void forget_uses();
  std::uint32_t beyond(std::uint32_t corner_point) const;

  std::span<const StripTriangle> triangles_;
  std::vector<std::array<std::uint32_t, 3>> neighbours_;  // across the edge opposite to each corner
  std::vector<std::uint32_t> table_;                      // of half-edges, by their ends
  std::vector<Start> starts_;
  std::vector<std::uint8_t> used_;
  std::vector<std::uint8_t> free_;     // how many neighbours are not used
  std::vector<std::uint32_t> unused_;  // triangles, some of which have been used since
  std::vector<std::uint32_t> strip_;
  std::vector<std::uint32_t> best_;
  std::uint32_t at_ = 0;
  std::size_t left_ = 0;
};

}  // namespace glark::surfel
