// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Joins the triangles of a mesh to strips that keep their orientation, without degenerate triangles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace glark::maps {

struct TriangleStrips {
  std::vector<std::uint32_t> vertices;  // of all strips, one after the other
  std::vector<std::uint32_t> sizes;     // of each strip
};

// triangles: [3 * triangles], counter-clockwise. Each triangle is in one strip; a triangle with two equal vertices is in
// none.
TriangleStrips strips_of(std::span<const std::uint32_t> triangles);

}  // namespace glark::maps
