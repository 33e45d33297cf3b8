// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/pattern/gpu_pool.h"

#include <cassert>
#include <vector>

namespace glark::pattern {
namespace {

struct Patch {
  float ou, ov, s, r;
};

// All tiles of the uniform levels, level by level; the levels that need no tiling share the first.
std::vector<Patch> uniform_tiles(unsigned max_level) {
  std::vector<Patch> patches{{0.0F, 0.0F, 1.0F, 0.0F}};
  for (unsigned level = deepest_uniform + 1U; level <= max_level; ++level) {
    for (const Instance& tile :
         expand(static_cast<int>(level), static_cast<int>(level), static_cast<int>(level), Interior::minimum)) {
      patches.push_back({tile.ou, tile.ov, tile.s, tile.r});
    }
  }
  return patches;
}

// Words of a DrawElementsIndirectCommand for each uniform piece, without instances. They are written once: NVIDIA (580)
// loses what glBufferSubData writes to a buffer beside the result of a query.
std::vector<std::uint32_t> uniform_commands(const PieceTable& pieces) {
  std::vector<std::uint32_t> words;
  for (int level = 0; level <= deepest_uniform; ++level) {
    const Piece& piece = pieces[static_cast<std::size_t>(uniform_piece(level))];
    words.insert(words.end(),
                 {piece.index_count, 0, piece.first_index, static_cast<std::uint32_t>(piece.base_vertex), 0});
  }
  return words;
}

// Makes indices count from the beginning of the pool, so that no draw needs a base vertex. With a base vertex, llvmpipe
// takes a slower path for every index, which costs a sixth of the speed of the vertex stage.
void point_into_pool(Pool& pool) {
  assert(pool.vertices.size() <= 0x10000);
  // Interiors share the indices of uniform pieces.
  for (int number = 0; number < piece_count; ++number) {
    const Piece& piece = pool.pieces[static_cast<std::size_t>(number)];
    const bool shares = number >= first_interior && number < first_skirt;
    for (std::uint32_t i = 0; i < piece.index_count && !shares; ++i) {
      std::uint16_t& index = pool.indices[piece.first_index + i];
      index = static_cast<std::uint16_t>(index + piece.base_vertex);
    }
  }
  for (Piece& piece : pool.pieces) piece.base_vertex = 0;
}

}  // namespace

unsigned GpuPool::first_tile(unsigned level) {
  unsigned first = level <= deepest_uniform ? 0 : 1;
  for (unsigned tiled = deepest_uniform + 1U; tiled < level; ++tiled) {
    first += tile_count(tiled);
  }
  return first;
}

bool GpuPool::build(const gl::Dispatch& gl, unsigned max_level, bool nested) {
  Pool pool = build_pool(max_level, nested);
  point_into_pool(pool);
  const std::vector<Patch> tiles = uniform_tiles(max_level);
  const std::vector<std::uint32_t> commands = uniform_commands(pool.pieces);
  GpuPool fresh;
  if (!fresh.vertices_.allocate(gl, static_cast<std::int64_t>(pool.vertices.size() * sizeof(pool.vertices[0])),
                                pool.vertices.data(), GL_STATIC_DRAW) ||
      !fresh.indices_.allocate(gl, static_cast<std::int64_t>(pool.indices.size() * sizeof(pool.indices[0])),
                               pool.indices.data(), GL_STATIC_DRAW) ||
      !fresh.patches_.allocate(gl, static_cast<std::int64_t>(tiles.size() * sizeof(tiles[0])), tiles.data(),
                               GL_STATIC_DRAW) ||
      !fresh.commands_.allocate(gl, static_cast<std::int64_t>(commands.size() * sizeof(commands[0])), commands.data(),
                                GL_DYNAMIC_COPY)) {
    fresh.release(gl);
    return false;
  }
  fresh.pieces_ = pool.pieces;
  fresh.max_level_ = max_level;
  fresh.nested_ = nested;
  release(gl);
  *this = fresh;
  return true;
}

std::vector<std::uint16_t> GpuPool::read_indices(const gl::Dispatch& gl, const Piece& piece) const {
  std::vector<std::uint16_t> indices(piece.index_count);
  if (!indices_.read(gl, static_cast<GLintptr>(piece.first_index) * 2, static_cast<std::int64_t>(indices.size()) * 2,
                     indices.data())) {
    indices.clear();
  }
  return indices;
}

void GpuPool::release(const gl::Dispatch& gl) {
  vertices_.release(gl);
  indices_.release(gl);
  patches_.release(gl);
  commands_.release(gl);
}

}  // namespace glark::pattern
