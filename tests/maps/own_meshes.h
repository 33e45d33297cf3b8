// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Coarse meshes with texture coordinates of their own.
#pragma once

#include <glark/maps.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace glark::maps::test {

struct OwnMesh {
  std::vector<float> positions, texcoords;
  std::vector<std::uint32_t> triangles;

  CoarseMesh coarse() const { return {.positions = positions, .triangles = triangles, .texcoords = texcoords}; }
  std::uint32_t vertices() const { return static_cast<std::uint32_t>(positions.size() / 3); }
  void add_vertex(const std::array<double, 3>& p, double s, double t) {
    for (const double x : p) positions.push_back(static_cast<float>(x));
    texcoords.insert(texcoords.end(), {static_cast<float>(s), static_cast<float>(t)});
  }
  // A grid of vertices row by row, from `first` on, `columns` and `rows` of them.
  void add_grid(std::uint32_t first, std::uint32_t columns, std::uint32_t rows) {
    for (std::uint32_t row = 0; row + 1 < rows; ++row)
      for (std::uint32_t column = 0; column + 1 < columns; ++column) {
        const std::uint32_t a = first + row * columns + column, b = a + 1, c = a + columns, d = c + 1;
        triangles.insert(triangles.end(), {a, b, d, a, d, c});
      }
  }
};

enum class Layout { plain, mirrored };

// A sphere of six faces, `parts` squares along an edge. Each face is an island, three beside each other in two rows.
// margin: around each island, relative to its cell. mirrored: every second island is turned over.
inline OwnMesh cube_sphere(std::uint32_t parts, Layout layout = Layout::plain, double margin = 0.05) {
  OwnMesh mesh;
  for (unsigned face = 0; face < 6; ++face) {
    const std::uint32_t first = mesh.vertices();
    const std::size_t axis = face % 3;
    const unsigned cell_row = face / 3;
    for (std::uint32_t row = 0; row <= parts; ++row) {
      for (std::uint32_t column = 0; column <= parts; ++column) {
        const double u = double(column) / parts, v = double(row) / parts;
        std::array<double, 3> p{};
        p.at(axis) = face < 3 ? 1 : -1;
        p.at((axis + 1) % 3) = 2 * (face < 3 ? u : v) - 1;
        p.at((axis + 2) % 3) = 2 * (face < 3 ? v : u) - 1;
        std::array<double, 3> squares{p[0] * p[0], p[1] * p[1], p[2] * p[2]};
        std::sort(squares.begin(), squares.end());  // the sum is the same on all faces
        const double length = std::sqrt(squares[0] + squares[1] + squares[2]);
        for (double& x : p) x /= length;
        const double along = layout == Layout::mirrored && face % 2 == 1 ? 1 - u : u;
        mesh.add_vertex(p, (face % 3 + margin + (1 - 2 * margin) * along) / 3,
                        (cell_row + margin + (1 - 2 * margin) * v) / 2);
      }
    }
    mesh.add_grid(first, parts + 1, parts + 1);
  }
  return mesh;
}

// A sphere between two parallels, as a map of the world shows it: one island, whose left and right ends meet.
inline OwnMesh globe(std::uint32_t columns, std::uint32_t rows) {
  OwnMesh mesh;
  for (std::uint32_t row = 0; row <= rows; ++row) {
    for (std::uint32_t column = 0; column <= columns; ++column) {
      const double turn = 2 * std::numbers::pi * (column % columns) / columns,
                   height = (double(row) / rows - 0.5) * 2.4;
      mesh.add_vertex({std::cos(height) * std::cos(turn), std::cos(height) * std::sin(turn), std::sin(height)},
                      0.03 + 0.94 * column / columns, 0.03 + 0.94 * row / rows);
    }
  }
  mesh.add_grid(0, columns + 1, rows + 1);
  return mesh;
}

}  // namespace glark::maps::test
