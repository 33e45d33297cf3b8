// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Balls of any size around points. Points and triangles take away the balls that they reach.
#pragma once

#include <cstdint>
#include <vector>

#include "glark/clients/reconstruct/samples/octree.h"

namespace glark::reconstruct {

struct Ball {
  Float4 centre;  // in the unit cube
  Float4 normal;
  float radius;
};

class BallsInCells {
 public:
  explicit BallsInCells(const std::vector<Ball>& balls);

  // Takes away the balls that the triangle or the point reaches, unless they face away from it. It looks at a few cells
  // for each size of balls.
  void take(Float4 a, Float4 b, Float4 c) { take(Shape{a, b, c, cross(b - a, c - a), false}); }
  void take(Float4 point, Float4 normal) { take(Shape{point, point, point, normal, true}); }
  std::vector<Ball> left() const;

 private:
  // A ball is in the list of each cell that it touches, on the level whose cells are at least twice as wide as it is.
  struct Link {
    std::uint32_t ball, next;
  };
  struct Cell {
    std::uint32_t first = none;  // link
    bool has_finer = false;      // whether there are balls in cells within this one
  };
  struct Shape {
    Float4 a, b, c, normal;
    bool is_point;
  };

  // The cells of a level, from those of the last level.
  static CellBox cells_of(const CellBox& finest, unsigned level);
  static std::uint64_t key_on(unsigned level, const CellIndex& cell) {
    return std::uint64_t{1} << (3 * level) | key_of(cell);
  }
  Cell& cell_at(unsigned level, const CellIndex& cell);
  void add(std::uint32_t ball, unsigned level, const CellIndex& cell);
  void take(const Shape& shape);
  void take_in(Cell& cell, const Shape& shape);
  void visit(unsigned level, const CellIndex& cell, bool descends, const CellBox& finest, const Shape& shape);

  const std::vector<Ball>& balls_;
  std::vector<bool> is_left_;
  CellTable table_;
  std::vector<Cell> cells_;
  std::vector<Link> links_;
  std::vector<unsigned> levels_;  // those that have balls, in ascending order
};

}  // namespace glark::reconstruct
