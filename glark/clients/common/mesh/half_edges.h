// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Half-edges of triangles. Corner i starts half-edge i, which ends at the next corner of its triangle.
#pragma once

#include <cstdint>
#include <vector>

namespace glark::common {

inline std::uint32_t next_corner(std::uint32_t i) { return i % 3 == 2 ? i - 2 : i + 1; }

inline constexpr std::uint32_t no_half_edge = 0xFFFFFFFF;

// Returns the opposite of each half-edge, or no_half_edge at the boundary.
std::vector<std::uint32_t> opposite_of(const std::vector<std::uint32_t>& triangles, std::size_t vertices);

}  // namespace glark::common
