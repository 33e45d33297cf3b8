// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Captures refined triangles by transform feedback.
#pragma once

#include <cstring>
#include <functional>
#include <vector>

#include "conformance/support/mesh.h"

namespace glark::conformance {

// One vertex that the capture program writes.
struct CapturedVertex {
  Vec4 position;   // gl_Position
  Vec3 weights;    // barycentric, in the coarse triangle
  float triangle;  // which coarse triangle
};

// A program that reads the mesh's attributes (support/mesh.h); gl_Position is the position.
GLuint capture_program(Test& t);

// Captures the primitives that draw() gives with the program in use, which writes `Vertex`es. The case fails and ends
// if there are more than `most` primitives.
template <typename Vertex>
std::vector<Vertex> capture_as(Test& t, std::size_t most, const std::function<void()>& draw,
                               GLenum mode = GL_TRIANGLES);

inline std::vector<CapturedVertex> capture(Test& t, const std::function<void()>& draw, std::size_t most = 40000) {
  return capture_as<CapturedVertex>(t, most, draw);
}

// The captured bytes: `stride` for each vertex, `per_primitive` vertices for each primitive.
std::vector<unsigned char> capture_bytes(Test& t, std::size_t stride, std::size_t per_primitive, std::size_t most,
                                         GLenum mode, const std::function<void()>& draw);

// Call ARKinit, choose uniform depth or depth tags, and enable ARK.
void refine_uniformly(GLuint level, GLenum refinement = GL_LINEAR_INPUTS_ARK);
void refine_by_tags(GLuint pool_level, GLenum refinement = GL_LINEAR_INPUTS_ARK);

// Clears to black and sets the viewport to the surface.
void clear_surface();
// The picture of a draw on a cleared surface.
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
