// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "glark/clients/stream/sample/pass/cell_pass.h"

namespace glark::stream {

inline constexpr std::uint32_t no_cell = 0xFFFFFFFF;

// The small cubes of a cell.
class CellFrame {
 public:
  CellFrame() = default;
  // corner: the least one of the cell, relative to the origin of the positions that place() gets.
  CellFrame(const std::array<double, 3>& corner, double side, unsigned bits);
  // Sets the key and the position of a point.
  void place(const std::array<double, 3>& position, LocalPoint& point) const;

 private:
  std::array<double, 3> corner_{};
  double small_ = 1, cubes_a_unit_ = 1, last_ = 0;
};

// Finds the cells of points that follow one another, which are mostly in the cube of the point before.
class CellFinder {
 public:
  CellFinder(const Plan& plan, const std::string& source) : plan_(plan), source_(source) {}
  // Returns no_cell for a position that is not finite. Throws Error if no cell has the position: the source has changed.
  std::uint32_t find(const double* position);
  // The frame and the centre of the cell that was found last.
  const CellFrame& frame() const { return frame_; }
  const std::array<double, 3>& centre() const { return centre_; }

 private:
  const Plan& plan_;
  const std::string& source_;
  std::array<std::uint32_t, 3> cube_{};
  std::uint32_t cell_ = no_cell;
  CellFrame frame_;
  std::array<double, 3> centre_{};
};

// The point of a span in the cell that was found last. cell: its index, or no_cell, which leaves the rest empty.
LocalPoint local_point(const CellFinder& finder, std::uint32_t cell, const PointKind& kind, const Points& points,
                       std::size_t i);

// A normal of unit length, or zero.
std::array<float, 3> unit_normal_of(const Points& points, std::size_t i);

[[noreturn]] void fail_as_changed(const std::string& source);

}  // namespace glark::stream
