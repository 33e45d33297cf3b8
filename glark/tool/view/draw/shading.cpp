// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/draw/shading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "glark/clients/common/vector.h"
#include "glark/clients/common/vertex_normals.h"

namespace glark::tool {
namespace {

constexpr std::size_t grid = 128;  // cubes along the longest side

}  // namespace

std::vector<float> normals_of_triangles(const geometry::Geometry& geometry) {
  std::vector<float> normals(geometry.positions.size());
  const std::span<const float> positions = geometry.positions;
  common::add_triangle_normals(
      geometry.triangles, [&](std::uint32_t vertex) { return common::vector_at(positions, vertex); },
      [&](std::uint32_t vertex, common::Vector3f normal) {
        for (std::size_t axis = 0; axis < 3; ++axis) normals[3 * std::size_t{vertex} + axis] += normal[axis];
      });
  for (std::size_t i = 0; i < normals.size(); i += 3) {
    const float length = std::hypot(normals[i], normals[i + 1], normals[i + 2]);
    for (std::size_t axis = 0; axis < 3 && length > 0; ++axis) normals[i + axis] /= length;
  }
  return normals;
}

std::vector<std::uint8_t> colours_by_height(std::span<const float> positions, float low, float high) {
  constexpr std::array<std::array<float, 3>, 3> stops{{{70, 110, 170}, {90, 160, 110}, {230, 215, 170}}};
  std::vector<std::uint8_t> colours;
  colours.reserve(positions.size() / 3 * 4);
  for (std::size_t i = 2; i < positions.size(); i += 3) {
    const float height = high > low ? 2 * (positions[i] - low) / (high - low) : 1;
    const std::size_t from = height < 1 ? 0 : 1;
    const float share = height - static_cast<float>(from);
    for (std::size_t k = 0; k < 3; ++k)
      colours.push_back(static_cast<std::uint8_t>(stops[from][k] + share * (stops[from + 1][k] - stops[from][k])));
    colours.push_back(255);
  }
  return colours;
}

std::array<std::uint8_t, 3> colour_between_blue_and_red(float share) {
  constexpr std::array<std::array<float, 3>, 4> stops{{{50, 80, 200}, {60, 190, 110}, {240, 220, 70}, {220, 50, 40}}};
  const float place = std::clamp(share, 0.0F, 1.0F) * (stops.size() - 1);
  const std::size_t from = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  const float rest = place - static_cast<float>(from);
  std::array<std::uint8_t, 3> colour{};
  for (std::size_t k = 0; k < 3; ++k)
    colour[k] = static_cast<std::uint8_t>(stops[from][k] + rest * (stops[from + 1][k] - stops[from][k]));
  return colour;
}

std::vector<std::uint8_t> colours_by_distance(std::span<const float> distances, float greatest) {
  std::vector<std::uint8_t> colours;
  colours.reserve(distances.size() * 4);
  for (const float distance : distances) {
    const auto [red, green, blue] = colour_between_blue_and_red(greatest > 0 ? distance / greatest : 0);
    colours.insert(colours.end(), {red, green, blue, 255});
  }
  return colours;
}

float estimated_spacing(std::span<const float> positions, const glm::vec3& low, const glm::vec3& high) {
  const glm::vec3 size = high - low;
  const float longest = std::max({size.x, size.y, size.z});
  if (!(longest > 0)) return 0;
  const float side = longest / grid;
  std::vector<bool> taken(grid * grid * grid);
  std::size_t count = 0;
  for (std::size_t i = 0; i < positions.size(); i += 3) {
    std::size_t cube = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const float above = positions[i + static_cast<std::size_t>(axis)] - low[axis];
      cube = cube * grid + std::min(static_cast<std::size_t>(above / side), grid - 1);
    }
    count += taken[cube] ? 0 : 1;
    taken[cube] = true;
  }
  // A surface crosses about 1.5 cubes for each piece that has the area of a cube's face.
  const double area = static_cast<double>(count) * side * side / 1.5;
  return static_cast<float>(std::sqrt(area / (static_cast<double>(positions.size()) / 3)));
}

}  // namespace glark::tool
