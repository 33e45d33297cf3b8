// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include "glark/core/objects/gpu_buffer.h"
#include "glark/core/refinement.h"
#include "glark/core/state/programs/derived_program.h"
#include "glark/core/state/textures/texture_stamps.h"

namespace glark::core {

// The texture that displaces a draw, and how it is sampled.
struct HeightMap {
  GLuint texture = 0;  // 0: nothing is displaced
  GLuint sampler = 0;
  TextureStamps::State written;
  GLint unit = 0;
  unsigned channel = 0;
  float scale = 0;
  float bias = 0;
  bool operator==(const HeightMap&) const = default;
};

// What refined vertices depend on, besides the key of the draw that they belong to.
struct RefinedVerticesKey {
  unsigned level = 0;
  Refinement refinement = Refinement::linear_inputs;
  float shape_number = 0;
  SurfaceWords surface;
  HeightMap heights = {};
  std::uint64_t view = 0;             // number of the view that the depths were measured in
  std::uint64_t shader = 0;           // the derived program's number, if it has a refinement shader of the application
  std::uint64_t uniform_changes = 0;  // of this shader
  bool operator==(const RefinedVerticesKey&) const = default;
};

// The vertex inputs of a kept draw at its refined vertices. The application's own program or fixed function draws them
// as it would draw a static mesh.
struct RefinedVertices {
  RefinedVerticesKey key;
  GpuBuffer buffer;
  GpuBuffer indices;        // empty if draws of the level share an index buffer
  GLuint vertex_array = 0;  // 0: nothing is kept
  GLsizei index_count = 0;
  std::shared_ptr<const char> lifetime;  // expires when the vertices are dropped; null: nothing is kept
  bool refused = false;                  // with this key: there is no memory, or GL does not draw them

  std::int64_t bytes() const { return buffer.size() + indices.size(); }
  void release(const gl::Dispatch& gl) {
    if (vertex_array != 0) {
      gl.DeleteVertexArrays(1, &vertex_array);
    }
    buffer.release(gl);
    indices.release(gl);
    *this = {};
  }
};

}  // namespace glark::core
