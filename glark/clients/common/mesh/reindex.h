// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Triangles over clusters instead of points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/common/workers.h"

namespace glark::common {

// The triangles whose corners are in three clusters, over these, in their order.
std::vector<std::uint32_t> spanning(std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> clusters,
                                    const Workers& workers);
// 1 for each vertex around which the triangles are not one fan, open or closed: so for all corners of a triangle that is there twice, the ends
// of an edge with more than two triangles or with two that run the same way, and where sheets touch in a vertex. Few vertices are.
std::vector<std::uint8_t> irregular_vertices(std::span<const std::uint32_t> triangles, std::size_t vertices);
// Each triangle once. Two that are the same but reversed, a fin of no thickness, cancel: so what is closed stays closed.
std::vector<std::uint32_t> without_repeats(std::vector<std::uint32_t> spanning,
                                           std::span<const std::uint8_t> irregular);

}  // namespace glark::common
