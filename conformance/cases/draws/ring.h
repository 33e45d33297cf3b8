// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A mesh and indices that every mode of drawing commands makes triangles of.
#pragma once

#include "conformance/support/mesh.h"

namespace glark::conformance {

// Twelve vertices in a ring: every mode gives triangles with an area. Coordinates are eighths, so that sums are exact.
inline Mesh ring() {
  const Vec2 places[] = {{-0.75F, -0.5F}, {-0.25F, -0.875F}, {0.25F, -0.75F},  {0.75F, -0.25F},
                         {0.875F, 0.25F}, {0.5F, 0.625F},    {0.125F, 0.875F}, {-0.375F, 0.75F},
                         {-0.75F, 0.5F},  {-0.875F, 0.125F}, {-0.5F, -0.125F}, {-0.625F, -0.375F}};
  Mesh mesh(12);
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const auto n = static_cast<float>(i);
    mesh[i].position = {places[i][0], places[i][1], n / 16, 1};
    mesh[i].colour = {n / 16, 1 - n / 16, static_cast<float>(i % 3) / 2, 1};
    mesh[i].tag = static_cast<float>((i * 5 + i / 3) % 4);
  }
  return mesh;
}

template <typename Index>
void bind_indices_as() {
  const Index indices[] = {11, 3, 5, 0, 7, 2, 9, 4, 1, 6, 8, 10};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
}

// Returns the size of an index.
inline std::size_t bind_indices(GLenum type) {
  if (type == GL_UNSIGNED_BYTE) bind_indices_as<GLubyte>();
  if (type == GL_UNSIGNED_SHORT) bind_indices_as<GLushort>();
  if (type == GL_UNSIGNED_INT) bind_indices_as<GLuint>();
  return type == GL_UNSIGNED_BYTE ? 1 : type == GL_UNSIGNED_SHORT ? 2 : 4;
}

}  // namespace glark::conformance
