// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/support/mesh.h"

namespace glark::conformance {
namespace {

void attribute(GLuint location, GLint components, std::size_t offset) {
  gl.EnableVertexAttribArray(location);
  gl.VertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, sizeof(MeshVertex),
                         reinterpret_cast<const void*>(offset));
}

}  // namespace

Mesh one_triangle(std::array<float, 3> tags) {
  Mesh mesh(3);
  mesh[0].position = {-0.75F, -0.75F, 0, 1};
  mesh[1].position = {0.75F, -0.75F, 0, 1};
  mesh[2].position = {-0.25F, 0.75F, 0, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    mesh[i].colour = {i == 0 ? 1.0F : 0.0F, i == 1 ? 1.0F : 0.0F, i == 2 ? 1.0F : 0.0F, 1};
    mesh[i].tag = tags[i];
  }
  number_triangles(mesh);
  return mesh;
}

void number_triangles(Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    mesh[i].weights = {i % 3 == 0 ? 1.0F : 0.0F, i % 3 == 1 ? 1.0F : 0.0F, i % 3 == 2 ? 1.0F : 0.0F};
    const std::size_t triangle = i / 3;
    mesh[i].triangle = static_cast<float>(triangle);
  }
}

MeshBuffers upload(const Mesh& mesh, bool has_tags) {
  MeshBuffers buffers;
  gl.GenVertexArrays(1, &buffers.array);
  gl.BindVertexArray(buffers.array);
  gl.GenBuffers(1, &buffers.buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffers.buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.size() * sizeof(MeshVertex)), mesh.data(),
                GL_STATIC_DRAW);
  attribute(at_position, 4, offsetof(MeshVertex, position));
  attribute(at_normal, 3, offsetof(MeshVertex, normal));
  attribute(at_weights, 3, offsetof(MeshVertex, weights));
  attribute(at_colour, 4, offsetof(MeshVertex, colour));
  attribute(at_texture, 2, offsetof(MeshVertex, texture));
  attribute(at_extra, 1, offsetof(MeshVertex, triangle));
  if (has_tags) {
    gl.DepthTagPointerARK(GL_FLOAT, sizeof(MeshVertex), reinterpret_cast<const void*>(offsetof(MeshVertex, tag)));
    gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  }
  return buffers;
}

}  // namespace glark::conformance
