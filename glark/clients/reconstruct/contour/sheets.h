// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which edges of a cell the same sheet of the surface crosses, for each way that its corners can be inside and outside.
#pragma once

#include <array>
#include <cstdint>

namespace glark::reconstruct {

// Corner x + 2 y + 4 z. Edge 4 a + i runs along axis a; i has the place along the axis after, then the one after that.
struct CellEdge {
  unsigned from, to;  // corners, along the axis
};
CellEdge edge_of_cell(unsigned edge);

struct Sheets {
  std::uint8_t count = 0;
  std::array<std::uint8_t, 12> of_edge{};  // no_sheet: the surface does not cross it
};
inline constexpr std::uint8_t no_sheet = 0xFF;

// inside: a bit for each corner. Where two corners of a face that lie across are inside, they are apart, as both cells at the face see it.
const Sheets& sheets_of(unsigned inside);

}  // namespace glark::reconstruct
