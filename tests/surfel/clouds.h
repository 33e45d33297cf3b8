// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Clouds of points for tests, and the triangles of their strips.
#pragma once

#include <glark/surfel.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace glark::surfel::test {

struct Points {
  std::vector<float> positions, normals;

  std::size_t size() const { return positions.size() / 3; }
  Cloud cloud() const { return {positions, normals}; }
  void add(std::array<float, 3> position, std::array<float, 3> normal);
};

Points sphere(std::size_t count);                        // radius 1, evenly spread
Points torus(std::size_t count);                         // radii 1 and 0.4, at random positions
Points plane(unsigned side, float noise, float at = 0);  // side * side points of the unit square at z = at, normals up
Points two_layers(unsigned side, float apart);           // a thin plate: normals up at z = apart, down at z = 0
Points cube(unsigned side);                              // edge 1, side * side points on each face, no point on an edge

// Reads a scan from ../shared/data beside the source tree with zstd. Returns nothing if the file or zstd is missing.
std::optional<Points> scan(const std::string& name);

using Triangle = std::array<std::uint32_t, 3>;

// Triangles without duplicate indices, counter-clockwise, leaf by leaf.
std::vector<std::vector<Triangle>> patches(const Strips& strips, unsigned level = 0);
std::vector<Triangle> triangles(const Strips& strips, unsigned level = 0);

struct Edges {
  std::size_t matched = 0;  // the number of edges of two triangles with the same orientation
  std::size_t single = 0;   // the number of edges of one triangle
  std::size_t other = 0;
  // Numbers of edges between patches. Single edges count as border_other.
  std::size_t border_matched = 0, border_other = 0;
};
Edges count_edges(const Strips& strips);

}  // namespace glark::surfel::test
