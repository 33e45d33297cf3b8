// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Triangles between two chains of vertices.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/core/pattern/pool.h"

namespace glark::pattern {

// Appends the counter-clockwise triangles between two chains that run the same way, `left` to the left of `right`. The
// chains (indices into `vertices`) may share their first or their last vertex. If they share both, each has at least
// two segments. The shorter of the two next diagonals is taken, measured in the equilateral triangle. Between parallel
// lines, this is the Delaunay triangulation, whose least angle is the largest possible.
void zip(std::span<const LatticeVertex> vertices, std::span<const std::uint16_t> right,
         std::span<const std::uint16_t> left, std::vector<std::uint16_t>& indices);

}  // namespace glark::pattern
