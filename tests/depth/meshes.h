// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Meshes whose curvature is known.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace glark::depth::testing {

struct Mesh {
  std::vector<float> positions;
  std::vector<float> normals;
  std::vector<std::uint32_t> triangles;
  std::size_t vertices() const { return positions.size() / 3; }
};

// Makes a grid of (columns + 1) * (rows + 1) vertices. Calls surface(u, v, position, normal) for u, v in 0..1.
template <class Surface>
Mesh make_grid(std::uint32_t columns, std::uint32_t rows, Surface surface) {
  Mesh mesh;
  for (std::uint32_t j = 0; j <= rows; ++j) {
    for (std::uint32_t i = 0; i <= columns; ++i) {
      float position[3];
      float normal[3];
      surface(static_cast<float>(i) / static_cast<float>(columns), static_cast<float>(j) / static_cast<float>(rows),
              position, normal);
      mesh.positions.insert(mesh.positions.end(), position, position + 3);
      mesh.normals.insert(mesh.normals.end(), normal, normal + 3);
      if (i == columns || j == rows) continue;
      const std::uint32_t at = j * (columns + 1) + i;
      const std::uint32_t above = at + columns + 1;
      mesh.triangles.insert(mesh.triangles.end(), {at, at + 1, above + 1, at, above + 1, above});
    }
  }
  return mesh;
}

constexpr float turn = 2 * std::numbers::pi_v<float>;

// A torus: the circle has the radius `major`, the tube `minor`. Triangles are seen from outside.
inline Mesh make_torus(float major, float minor, std::uint32_t n) {
  return make_grid(n, n, [=](float u, float v, float* position, float* normal) {
    const float c = std::cos(turn * u);
    const float s = std::sin(turn * u);
    normal[0] = c * std::cos(turn * v);
    normal[1] = s * std::cos(turn * v);
    normal[2] = std::sin(turn * v);
    position[0] = major * c + minor * normal[0];
    position[1] = major * s + minor * normal[1];
    position[2] = minor * normal[2];
  });
}

inline Mesh make_cylinder(float radius, std::uint32_t n) {
  return make_grid(n, n, [=](float u, float v, float* position, float* normal) {
    normal[0] = std::cos(turn * u);
    normal[1] = std::sin(turn * u);
    normal[2] = 0;
    position[0] = radius * normal[0];
    position[1] = radius * normal[1];
    position[2] = 4 * v;
  });
}

// A sphere without the caps of 20 degrees around its poles.
inline Mesh make_sphere(float radius, std::uint32_t n) {
  return make_grid(n, n, [=](float u, float v, float* position, float* normal) {
    const float latitude = (v - 0.5F) * turn * 140 / 360;
    normal[0] = std::cos(turn * u) * std::cos(latitude);
    normal[1] = std::sin(turn * u) * std::cos(latitude);
    normal[2] = std::sin(latitude);
    for (int k = 0; k < 3; ++k) position[k] = radius * normal[k];
  });
}

}  // namespace glark::depth::testing
