// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Normals, colours and spacing of points whose file has none.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "glark/clients/geometry/geometry.h"

namespace glark::tool {

// Returns normals at the points: means of the triangles' normals, weighted by area.
std::vector<float> normals_of_triangles(const geometry::Geometry& geometry);

// Returns red green blue alpha for each point: blue at the bottom, then green, sand at the top.
std::vector<std::uint8_t> colours_by_height(std::span<const float> positions, float low, float high);

// Red, green and blue from blue at 0 through green and yellow to red at 1.
std::array<std::uint8_t, 3> colour_between_blue_and_red(float share);

// Returns red green blue alpha for each point: blue where the distance is 0, then green and yellow, red from `greatest`
// on.
std::vector<std::uint8_t> colours_by_distance(std::span<const float> distances, float greatest);

// Estimates the distance of neighbouring points, from the number of cubes of a grid that have points.
float estimated_spacing(std::span<const float> positions, const glm::vec3& low, const glm::vec3& high);

}  // namespace glark::tool
