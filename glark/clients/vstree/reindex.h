// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Triangles over clusters instead of points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/vstree/float4.h"
#include "glark/clients/workers.h"

namespace glark::vstree {

// The triangles whose corners are in three clusters, over these, in their order.
std::vector<std::uint32_t> spanning(std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> clusters,
                                    const Workers& workers);
// Each of them once. Two that are the same but reversed, a fin of no thickness, cancel: so what is closed stays closed.
std::vector<std::uint32_t> without_repeats(std::span<const std::uint32_t> spanning, std::size_t clusters);

// Makes one vertex for each sheet of triangles where sheets touch in a vertex or along an edge. Returns of each vertex which one it
// is a copy of: the first `points.size()` are their own. `points`: where the vertices are.
std::vector<std::uint32_t> cut(std::vector<std::uint32_t>& triangles, std::span<const Float4> points);

}  // namespace glark::vstree
