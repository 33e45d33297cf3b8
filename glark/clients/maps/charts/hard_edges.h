// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Edges where the fine surface has a crease, as machine parts have them.
#pragma once

#include <span>

#include "glark/clients/maps/charts/surface.h"

namespace glark::maps {

// Normals that differ by less than this at a hard edge, 20 degrees, are made equal.
inline constexpr float cosine_of_crease = 0.94F;

// Sets Surface::hard: the edges at which two triangles meet in a large angle, and the fine surface is flat on both.
// spreads: [triangles] the median angle between the normals of the fine surface and that of the triangle; infinite
// where it is not known.
void find_hard_edges(std::span<const float> spreads, Surface& surface);

// Makes an edge soft, on both sides.
void set_soft(std::uint32_t triangle, std::size_t edge, Surface& surface);

// The number of these edges.
std::size_t count_hard_edges(const Surface& surface);

}  // namespace glark::maps
