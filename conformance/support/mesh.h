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
  Vec4 position = {0, 0, 0, 1};  // in clip coordinates, for programs that leave it as it is
  Vec3 normal = {0, 0, 1};
  Vec3 weights = {0, 0, 0};  // (1, 0, 0), (0, 1, 0), (0, 0, 1): the barycentric coordinates, once refined
  Vec4 colour = {1, 1, 1, 1};
  Vec2 texture = {0, 0};
  float tag = 0;
  float triangle = 0;  // which coarse triangle, where all three corners have the same
};

using Mesh = std::vector<MeshVertex>;

// One triangle, counter-clockwise, that fills half of the surface, with its weights, and red, green and blue for colours.
Mesh one_triangle(std::array<float, 3> tags = {0, 0, 0});

// Every third vertex begins a triangle: gives weights and triangle numbers to all.
void number_triangles(Mesh& mesh);

// A vertex array and buffer with all of it, bound. The arrays at_position to at_texture and at_extra (the number of the triangle)
// are enabled; the depth tag array is, too, by DepthTagPointerARK, where `has_tags`.
struct MeshBuffers {
  GLuint array = 0;
  GLuint buffer = 0;
};
MeshBuffers upload(const Mesh& mesh, bool has_tags = true);

}  // namespace glark::conformance
