// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace glark::core {

// The number of vertices of each polygon of a draw, in the order of the polygons.
using PolygonSides = std::vector<std::uint32_t>;

}  // namespace glark::core
