// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Triangles of clusters instead of points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/common/workers.h"

namespace glark::common {

// Returns the triangles whose corners lie in three different clusters, in their order. Their indices are clusters.
std::vector<std::uint32_t> spanning(std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> clusters,
                                    const Workers& workers);
// Returns 1 for each vertex whose triangles are not one fan, open or closed. These are the corners of triangles that
// occur twice, the ends of edges with more than two triangles or with two that run the same way, and vertices where
// sheets touch. They are few.
std::vector<std::uint8_t> irregular_vertices(std::span<const std::uint32_t> triangles, std::size_t vertices);
// Keeps one of several equal triangles. Two triangles with opposite orientations are a fin without thickness; both are
// removed, so that a closed mesh stays closed.
std::vector<std::uint32_t> without_repeats(std::vector<std::uint32_t> spanning,
                                           std::span<const std::uint8_t> irregular);

}  // namespace glark::common
