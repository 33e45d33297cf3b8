// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Points on the triangles of a mesh, for meshes whose corners alone do not show the surface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace glark::reconstruct {

struct TriangleSamples {
  std::vector<float> positions, normals;  // [3 * samples]; a normal is that of its triangle
  std::vector<std::uint8_t> colours;      // [4 * samples], or empty
};

// Returns how much of the area belongs to triangles that are much longer than their share of corners tells, 0 to 1. The
// triangles of scans are all about as large, and the triangles of machine parts are not.
double share_of_long_triangles(std::span<const float> positions, std::span<const std::uint32_t> triangles);

// Puts about `count` samples on the triangles, each for the same area, and the same ones each time.
// colours: [4 * vertices], or empty.
TriangleSamples sample_triangles(std::span<const float> positions, std::span<const std::uint8_t> colours,
                                 std::span<const std::uint32_t> triangles, std::size_t count);

}  // namespace glark::reconstruct
