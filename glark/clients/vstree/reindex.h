// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Triangles over clusters instead of points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/vstree/record.h"

namespace glark::vstree {

// The triangles whose corners are in three clusters, over these, in their order.
std::vector<std::uint32_t> spanning(std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> clusters,
                                    const Workers& workers);
// 1 for each vertex around which the triangles are not one fan, open or closed: so for all corners of a triangle that is there twice, the ends
// of an edge with more than two triangles or with two that run the same way, and where sheets touch in a vertex. Few vertices are.
std::vector<std::uint8_t> irregular_vertices(std::span<const std::uint32_t> triangles, std::size_t vertices);
// Each triangle once. Two that are the same but reversed, a fin of no thickness, cancel: so what is closed stays closed.
std::vector<std::uint32_t> without_repeats(std::vector<std::uint32_t> spanning,
                                           std::span<const std::uint8_t> irregular);

// Makes one vertex for each sheet of triangles where sheets touch in a vertex or along an edge. Returns of each vertex which one it
// is a copy of: the first `points.size()` are their own. `points`: where the vertices are. `irregular`: of these or more triangles.
std::vector<std::uint32_t> cut(std::vector<std::uint32_t>& triangles, std::span<const Float4> points,
                               std::span<const std::uint8_t> irregular);

}  // namespace glark::vstree
