// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/pattern/gpu_pool.h"

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

}  // namespace

unsigned GpuPool::first_tile(unsigned level) {
  unsigned first = level <= deepest_uniform ? 0 : 1;
  for (unsigned tiled = deepest_uniform + 1U; tiled < level; ++tiled) {
    first += tile_count(tiled);
  }
  return first;
}

bool GpuPool::build(const gl::Dispatch& gl, unsigned max_level) {
  const Pool pool = build_pool(max_level);
  const std::vector<Patch> tiles = uniform_tiles(max_level);
  GpuPool fresh;
  if (!fresh.vertices_.allocate(gl, static_cast<GLsizeiptr>(pool.vertices.size() * sizeof(pool.vertices[0])),
                                pool.vertices.data(), GL_STATIC_DRAW) ||
      !fresh.indices_.allocate(gl, static_cast<GLsizeiptr>(pool.indices.size() * sizeof(pool.indices[0])),
                               pool.indices.data(), GL_STATIC_DRAW) ||
      !fresh.patches_.allocate(gl, static_cast<GLsizeiptr>(tiles.size() * sizeof(tiles[0])), tiles.data(),
                               GL_STATIC_DRAW)) {
    fresh.release(gl);
    return false;
  }
  fresh.pieces_ = pool.pieces;
  fresh.max_level_ = max_level;
  release(gl);
  *this = fresh;
  return true;
}

void GpuPool::release(const gl::Dispatch& gl) {
  vertices_.release(gl);
  indices_.release(gl);
  patches_.release(gl);
}

}  // namespace glark::pattern
