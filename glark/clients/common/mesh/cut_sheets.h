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

// Makes one vertex for each sheet of triangles where sheets touch in a vertex or along an edge. Returns for each vertex
// the one that it is a copy of; the first `points.size()` vertices are no copies. `points`: the positions of the
// vertices. `irregular`: as irregular_vertices() returns it, for these triangles or more.
std::vector<std::uint32_t> cut_sheets(std::vector<std::uint32_t>& triangles, std::span<const Float4> points,
                                      std::span<const std::uint8_t> irregular);

}  // namespace glark::common
