// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "conformance/support/program.h"

namespace glark::conformance {

using Vec2 = std::array<float, 2>;
using Vec3 = std::array<float, 3>;
using Vec4 = std::array<float, 4>;

struct MeshVertex {
  Vec4 position = {0, 0, 0, 1};  // in clip coordinates, for programs that pass it through
  Vec3 normal = {0, 0, 1};
  Vec3 weights = {0, 0, 0};  // (1, 0, 0), (0, 1, 0), (0, 0, 1); refinement turns them into barycentric coordinates
  Vec4 colour = {1, 1, 1, 1};
  Vec2 texture = {0, 0};
  float tag = 0;
  float triangle = 0;  // the number of the coarse triangle, if all three corners have the same
};

using Mesh = std::vector<MeshVertex>;

// One counter-clockwise triangle with its weights that fills half of the surface. Its colours are red, green and blue.
Mesh one_triangle(std::array<float, 3> tags = {0, 0, 0});

// Gives weights and triangle numbers to all vertices. Every three vertices are a triangle.
void number_triangles(Mesh& mesh);

// Makes and binds a vertex array and a buffer with the whole mesh. Enables the arrays at_position to at_texture and
// at_extra (the number of the triangle). If `has_tags`, also enables the depth tag array, by DepthTagPointerARK.
struct MeshBuffers {
  GLuint array = 0;
  GLuint buffer = 0;
};
MeshBuffers upload(const Mesh& mesh, bool has_tags = true);

}  // namespace glark::conformance
