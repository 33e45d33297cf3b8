// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What a picture takes and a file may lack.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/geometry/geometry.h"

namespace glark::tool {

// Of the points, the mean of the triangles' weighted by their area.
std::vector<float> normals_of_triangles(const geometry::Geometry& geometry);

// Blue at the bottom, green, then sand at the top.
std::vector<std::uint8_t> colours_by_height(std::span<const float> positions, float low, float high);

// About the distance of neighbouring points, from how many cubes of a grid have points.
float estimated_spacing(std::span<const float> positions, const std::array<float, 3>& low,
                        const std::array<float, 3>& high);

}  // namespace glark::tool
