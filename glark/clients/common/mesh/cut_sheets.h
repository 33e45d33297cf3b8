// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Makes a mesh manifold: sheets of triangles that touch get vertices of their own.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/common/float4.h"

namespace glark::common {

// Gives each sheet of triangles its own vertices where sheets touch in a vertex or along an edge. Returns the original
// of each vertex. The first `points.size()` vertices are their own originals.
// points: the positions of the vertices. irregular: the result of irregular_vertices() for these triangles, or for a
// superset.
std::vector<std::uint32_t> cut_sheets(std::vector<std::uint32_t>& triangles, std::span<const Float4> points,
                                      std::span<const std::uint8_t> irregular);

// Moves each vertex that has copies, and each copy, towards the middle of its own triangles, by a share of the way. So
// no two sheets have an edge at the same place.
// points: one for each vertex, copies included. originals: the result of cut_sheets() for these triangles.
void move_apart(std::span<Float4> points, std::span<const std::uint32_t> triangles,
                std::span<const std::uint32_t> originals, float share);

}  // namespace glark::common
