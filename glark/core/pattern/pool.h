// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The pool: the vertices and triangles of all pieces, made once on the CPU and uploaded to two GPU buffers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "glark/core/pattern/pieces.glsl.h"

namespace glark::pattern {

// Local barycentrics of one vertex, as integers: 1.0 is lattice_one = 2^15, w = lattice_one - u - v. A vertex attribute
// of type GL_UNSIGNED_SHORT that is not normalised; multiplied by 2^-15 it is exact in float.
struct LatticeVertex {
  std::uint16_t u, v;
};

// The place of a piece in the pool. index_count is 0 for a piece that the pool's level does not reach.
struct Piece {
  std::uint32_t first_index;   // into Pool::indices
  std::uint32_t index_count;   // a triangle list: a multiple of 3
  std::uint16_t base_vertex;   // added to every index
  std::uint16_t vertex_count;  // indices are below this
};

// All that the CPU keeps once the buffers are uploaded: 3996 bytes.
using PieceTable = std::array<Piece, piece_count>;
static_assert(sizeof(PieceTable) <= 4000, "Boubekeur 2007, ch. 7: less than 4 kB on the CPU");

// A pool of level L draws every triple of depths 0..L, with either interior; a nested pool only with
// Interior::morphing.
struct Pool {
  unsigned max_level;
  bool nested;
  std::vector<LatticeVertex> vertices;
  std::vector<std::uint16_t> indices;  // counter-clockwise triangles in (u, v), relative to Piece::base_vertex
  PieceTable pieces;                   // by piece number (pieces.glsl.h)

  std::size_t gpu_bytes() const {
    return vertices.size() * sizeof(LatticeVertex) + indices.size() * sizeof(std::uint16_t);
  }
};

// Throws std::invalid_argument for a level above deepest_level.
// A `nested` pool is for vertices that move between levels: each skirt has the triangles of the next shallower skirt,
// halved at their edges.
Pool build_pool(unsigned max_level, bool nested = false);

}  // namespace glark::pattern
