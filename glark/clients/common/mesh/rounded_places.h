// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Seams that are open by rounding alone. Where a surface meets itself, programs write both sides from sines and cosines,
// which differ by rounding: 0 and -2e-16.
#pragma once

#include <cstdint>
#include <span>

namespace glark::common {

// Gives points at the boundary of the mesh one position if they are nearer to each other than floats can tell at the size
// of the mesh: 2^-21 of the longest side of its bounding box. Returns the number of points that moved.
// positions: [3 * points]
std::size_t join_rounded_places(std::span<float> positions, std::span<const std::uint32_t> triangles);

}  // namespace glark::common
