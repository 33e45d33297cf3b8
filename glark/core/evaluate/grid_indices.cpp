// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/evaluate/grid_indices.h"

#include <algorithm>

namespace glark::evaluate {

void GridIndices::read_pattern(const gl::Dispatch& gl, const pattern::GpuPool& pool, unsigned number, Level& level) {
  const pattern::Piece& piece = pool.piece(pattern::uniform_piece(static_cast<int>(number)));
  level.pattern = pool.read_indices(gl, piece);
  const auto [least, most] = std::minmax_element(level.pattern.begin(), level.pattern.end());
  const std::uint16_t first = *least;
  level.first_vertex = first;
  level.vertex_count = *most - first + 1;
  for (std::uint16_t& index : level.pattern) {
    index = static_cast<std::uint16_t>(index - first);
  }
}

bool GridIndices::fill(const gl::Dispatch& gl, Level& level, std::uint32_t triangles) {
  std::vector<std::uint32_t> indices;
  indices.reserve(level.pattern.size() * triangles);
  for (std::uint32_t triangle = 0; triangle < triangles; ++triangle) {
    const std::uint32_t first = triangle * static_cast<std::uint32_t>(level.vertex_count);
    for (const std::uint16_t index : level.pattern) {
      indices.push_back(first + index);
    }
  }
  const auto bytes = static_cast<GLsizeiptr>(indices.size() * sizeof(indices[0]));
  if (!level.buffer.allocate(gl, bytes, indices.data(), GL_STATIC_DRAW)) {
    return false;
  }
  level.triangles = triangles;
  return true;
}

GridIndices::Grid GridIndices::ensure(const gl::Dispatch& gl, const pattern::GpuPool& pool, unsigned level,
                                      std::uint32_t triangles) {
  Level& found = levels_.at(level);
  if (found.pattern.empty()) {
    read_pattern(gl, pool, level, found);
  }
  // Vertex arrays that were made with a smaller buffer keep it alive.
  if (found.triangles < triangles && !fill(gl, found, std::max(triangles, found.triangles + found.triangles / 2))) {
    return {};
  }
  return {found.buffer.name(), static_cast<std::uint32_t>(found.pattern.size()), found.first_vertex,
          found.vertex_count};
}

void GridIndices::release(const gl::Dispatch& gl) {
  for (Level& level : levels_) {
    level.buffer.release(gl);
    level = {};
  }
}

}  // namespace glark::evaluate
