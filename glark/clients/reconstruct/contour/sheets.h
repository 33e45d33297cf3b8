// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The sheets of the surface in a cell, for each of the 256 ways that its corners can be inside or outside.
#pragma once

#include <array>
#include <cstdint>

namespace glark::reconstruct {

// An edge of a cell. Corner (x, y, z) has the number x + 2 y + 4 z. Edge 4 a + i runs along axis a; bit 0 of i is the
// position along the next axis, bit 1 along the axis after that.
struct CellEdge {
  unsigned from, to;  // corners, in the direction of the axis
};
CellEdge edge_of_cell(unsigned edge);

struct Sheets {
  std::uint8_t count = 0;
  std::array<std::uint8_t, 12> of_edge{};  // no_sheet: the surface does not cross the edge
};
inline constexpr std::uint8_t no_sheet = 0xFF;

// inside: a bit for each corner. Two inside corners on a diagonal of a face are not connected. The cells on both sides
// of the face use this rule, so they agree.
const Sheets& sheets_of(unsigned inside);

}  // namespace glark::reconstruct
