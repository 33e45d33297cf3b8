// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "glark/clients/stream/sample/cell_pass.h"

namespace glark::stream {

inline constexpr std::uint32_t no_cell = 0xFFFFFFFF;

// Finds the cells of points that follow one another, which are mostly in the cube of the point before.
class CellFinder {
 public:
  CellFinder(const Plan& plan, const std::string& source) : plan_(plan), source_(source) {}
  // Returns no_cell for a position that is not finite. Throws Error if no cell has the position: the source has changed.
  std::uint32_t find(const double* position);

 private:
  const Plan& plan_;
  const std::string& source_;
  std::uint64_t key_ = Cube::no_key;
  std::uint32_t cell_ = no_cell;
};

// Sets the key and the position of a point. `from_centre`: its position relative to the cell's centre.
void place_in_cell(const std::array<double, 3>& from_centre, double side, unsigned bits, LocalPoint& point);

// A normal of unit length, or zero.
std::array<float, 3> unit_normal_of(const Points& points, std::size_t i);

[[noreturn]] void fail_as_changed(const std::string& source);

}  // namespace glark::stream
