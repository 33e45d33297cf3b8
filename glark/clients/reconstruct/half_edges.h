// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The edges of triangles: corner i starts the half-edge to the next corner of its triangle.
#pragma once

#include <cstdint>
#include <vector>

namespace glark::vstree {

inline std::uint32_t next_corner(std::uint32_t i) { return i % 3 == 2 ? i - 2 : i + 1; }

// Of each half-edge the one that runs against it; none at the border.
std::vector<std::uint32_t> opposite_of(const std::vector<std::uint32_t>& triangles, std::size_t vertices);

}  // namespace glark::vstree
