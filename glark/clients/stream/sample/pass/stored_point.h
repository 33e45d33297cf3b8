// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Points of shuffled scans, as they lie in a file of cells.
#pragma once

#include "glark/clients/stream/sample/pass/local_points.h"

namespace glark::stream {

struct StoredPoint {
  std::array<float, 3> from_centre{};  // of the cell
  std::array<std::int16_t, 3> normal{};
  std::array<std::uint8_t, 4> colour{};
};

// centre: that of the point's cell.
StoredPoint stored_point(const std::array<double, 3>& centre, const PointKind& kind, const Points& points,
                         std::size_t i);

// Adds a point to the small cubes of its cell. frame: that of the cell, about its centre.
void add_stored(const StoredPoint& stored, const CellFrame& frame, const PointKind& kind, MicroTable& table);

}  // namespace glark::stream
