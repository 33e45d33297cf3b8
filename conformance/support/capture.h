// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Refined triangles, read back through transform feedback.
#pragma once

#include <cstring>
#include <functional>
#include <vector>

#include "conformance/support/mesh.h"

namespace glark::conformance {

// What the capture program writes for one vertex.
struct CapturedVertex {
  Vec4 position;   // gl_Position
  Vec3 weights;    // barycentric, in the coarse triangle
  float triangle;  // which coarse triangle
};

// Of the mesh's attributes (support/mesh.h); gl_Position is the position.
GLuint capture_program(Test& t);

// Three vertices for each triangle that draw() gives to transform feedback of the program in use, which writes `Vertex`es. The case
// ends as failed where there are more than `most` triangles or the query of primitives written disagrees with the one generated.
template <typename Vertex>
std::vector<Vertex> capture_as(Test& t, std::size_t most, const std::function<void()>& draw,
                               GLenum mode = GL_TRIANGLES);

inline std::vector<CapturedVertex> capture(Test& t, const std::function<void()>& draw, std::size_t most = 40000) {
  return capture_as<CapturedVertex>(t, most, draw);
}

// The bytes that draw() writes, `stride` for a vertex, `per_primitive` vertices for a primitive.
std::vector<unsigned char> capture_bytes(Test& t, std::size_t stride, std::size_t per_primitive, std::size_t most,
                                         GLenum mode, const std::function<void()>& draw);

// "ARKinit; uniform depth; Enable(ARK)" and "ARKinit; depth tags; Enable(ARK)".
void refine_uniformly(GLuint level, GLenum refinement = GL_LINEAR_INPUTS_ARK);
void refine_by_tags(GLuint pool_level, GLenum refinement = GL_LINEAR_INPUTS_ARK);

// Clears to black and sets the viewport to the surface.
void clear_surface();
// What a draw makes of the cleared surface.
Picture picture_of(const std::function<void()>& draw);

template <typename Vertex>
std::vector<Vertex> capture_as(Test& t, std::size_t most, const std::function<void()>& draw, GLenum mode) {
  const std::size_t per_primitive = mode == GL_POINTS ? 1 : mode == GL_LINES ? 2 : 3;
  const auto bytes = capture_bytes(t, sizeof(Vertex), per_primitive, most, mode, draw);
  std::vector<Vertex> vertices(bytes.size() / sizeof(Vertex));
  std::memcpy(vertices.data(), bytes.data(), vertices.size() * sizeof(Vertex));
  return vertices;
}

}  // namespace glark::conformance
