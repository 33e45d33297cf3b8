// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Coarse meshes, and the same meshes refined beforehand.
#pragma once

#include <cstdint>
#include <vector>

namespace glark::bench {

struct Vertex {
  float position[3];
  float normal[3];
  float uv[2];
};

struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;  // triangles; empty: every three vertices form one triangle
  std::size_t triangles() const { return indices.size() / 3; }
};

// Makes a sphere of radius 1 about the origin. `triangles` is the number of triangles of about equal size: even, at
// least 20.
Mesh make_sphere(int triangles);

// Makes a square of side 2 * half in the plane y = 0 with 2 * cells * cells triangles.
Mesh make_plane(int cells, float half);

// Returns the first `triangles` triangles of a mesh.
Mesh first_triangles(const Mesh& mesh, std::size_t triangles);

// Divides each triangle into 4^level triangles, in the order of the pattern. Vertices are shared within a coarse
// triangle. From level 9, they are shared within a tile of it.
Mesh refine(const Mesh& coarse, unsigned level);

// Returns the same triangles without indices. Each triangle has three vertices of its own.
Mesh separate(const Mesh& mesh);

}  // namespace glark::bench
