// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Captures refined positions and normals and compares them with the reference.
#pragma once

#include <string>
#include <vector>

#include "conformance/reference/refinement.h"
#include "conformance/support/capture.h"

namespace glark::conformance {

struct SurfaceVertex {
  Vec4 position;
  Vec3 normal;
  Vec3 weights;
  float triangle;
  Vec2 texture;
};

// Names of the program's inputs; some clauses are about names.
struct SurfaceNames {
  std::string position = "position";
  std::string normal = "normal";
  std::string texture = "texcoord";
};
GLuint surface_program(Test& t, const SurfaceNames& names = {});

// Two triangles that share an edge. All corners differ, and their normals are neither parallel nor of unit length.
Mesh bent_mesh();

struct ShapeTags {
  std::vector<Vec4> discontinuities;  // one for each vertex; empty: the current values remain
  std::vector<Vec3> scalars;
};
// Makes arrays for DISCONTINUITY_ATTRIBUTE_ARK and SCALAR_TAG_ATTRIBUTE_ARK in the bound vertex array.
void upload_shape_tags(const ShapeTags& tags);

reference::Corners corners_of(const Mesh& mesh, std::size_t triangle, const ShapeTags& tags = {});

std::vector<SurfaceVertex> capture_surface(Test& t, const Mesh& mesh);

// Compares positions and normals, within `tolerance` for each component. Reports the first failure in each triangle.
using SurfaceOf = reference::Surface (*)(const reference::Corners&, const Vec3& weights);
void expect_surface(Test& t, const std::vector<SurfaceVertex>& vertices, const Mesh& mesh, const ShapeTags& tags,
                    SurfaceOf surface, double tolerance = 2e-6);

// Compares positions by bits, except for the sign of zero.
bool same_position(const Vec4& a, const Vec4& b);

}  // namespace glark::conformance
