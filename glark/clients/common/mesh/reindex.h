// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Triangles whose indices are clusters instead of points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/common/workers.h"

namespace glark::common {

// Returns the triangles whose corners lie in three different clusters, in the order of the input. Their indices are
// clusters.
std::vector<std::uint32_t> spanning(std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> clusters,
                                    const Workers& workers);
// Returns 1 for each irregular vertex: its triangles do not form one fan, open or closed. Irregular are the corners of
// repeated triangles, and the vertices where sheets touch. So are the ends of edges that have more than two triangles,
// or two with different orientations. Few vertices are irregular.
std::vector<std::uint8_t> irregular_vertices(std::span<const std::uint32_t> triangles, std::size_t vertices);
// Two equal triangles with opposite orientations are a fin without thickness. Both are removed. Triangles with one
// orientation all stay: they belong to sheets that lie on one another. So a closed mesh stays closed.
std::vector<std::uint32_t> without_repeats(std::vector<std::uint32_t> spanning,
                                           std::span<const std::uint8_t> irregular);

}  // namespace glark::common
