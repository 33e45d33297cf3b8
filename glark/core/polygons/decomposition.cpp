// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/polygons/decomposition.h"

#include <algorithm>

namespace glark::polygons {
namespace {

using QuadCorners = std::array<int, 6>;  // corners of both triangles: the number of the boundary vertex, -1 for none

QuadCorners quad_corners(GLenum mode, std::size_t quad, std::span<const float> numbers) {
  constexpr std::array<int, 4> strip_boundary{0, 1, 3, 2};
  QuadCorners result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const int first = static_cast<int>(quad) * (mode == GL_QUADS ? 4 : 2);
    const int vertex = static_cast<int>(numbers[6 * quad + i]) - first;
    const bool inside = vertex >= 0 && vertex < 4;
    result[i] = !inside ? -1 : mode == GL_QUADS ? vertex : strip_boundary[static_cast<std::size_t>(vertex)];
  }
  return result;
}

// Returns the vertex of the quad that is not in the triangle; -1 if the triangle and the quad differ in orientation.
int vertex_left_out(const int* triangle) {
  for (int out = 0; out < 4; ++out) {
    for (int first = 0; first < 3; ++first) {
      const auto expected = [&](int i) { return (out + 1 + (first + i) % 3) % 4; };
      if (triangle[0] == expected(0) && triangle[1] == expected(1) && triangle[2] == expected(2)) {
        return out;
      }
    }
  }
  return -1;
}

std::optional<Decomposition> quad_decomposition(GLenum mode, std::span<const float> numbers) {
  const QuadCorners corners = quad_corners(mode, 0, numbers);
  const int first_out = vertex_left_out(corners.data());
  const int second_out = vertex_left_out(corners.data() + 3);
  if (corners != quad_corners(mode, 1, numbers) || first_out < 0 || second_out != (first_out + 2) % 4) {
    return std::nullopt;
  }
  Decomposition result;
  for (int vertex = 0; vertex < 4; ++vertex) {
    const auto* const found = std::find(corners.begin(), corners.end(), vertex);
    result.corners[static_cast<std::size_t>(vertex)] = static_cast<GLint>(found - corners.begin());
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (corners[corner] == vertex && corners[corner + 3] == vertex) {
        result.common_corners[static_cast<std::size_t>(vertex)] = static_cast<int>(corner);
      }
    }
  }
  return result;
}

std::optional<Decomposition> fan_decomposition(std::span<const float> numbers) {
  const auto hub = static_cast<std::size_t>(std::find(numbers.begin(), numbers.begin() + 3, 0.0F) - numbers.begin());
  const std::size_t corners[3] = {hub, (hub + 1) % 3, (hub + 2) % 3};
  for (std::size_t triangle = 0; 3 * triangle < numbers.size(); ++triangle) {
    const auto vertex = [&](std::size_t i) { return static_cast<std::size_t>(numbers[3 * triangle + corners[i]]); };
    if (hub > 2 || vertex(0) != 0 || vertex(1) != triangle + 1 || vertex(2) != triangle + 2) {
      return std::nullopt;
    }
  }
  Decomposition result{.fan = true};
  result.common_corners[0] = static_cast<int>(hub);
  std::copy(std::begin(corners), std::end(corners), result.corners.begin());
  return result;
}

}  // namespace

std::optional<Decomposition> decomposition_of(GLenum mode, std::span<const float> numbers) {
  return mode == GL_POLYGON ? fan_decomposition(numbers) : quad_decomposition(mode, numbers);
}

}  // namespace glark::polygons
