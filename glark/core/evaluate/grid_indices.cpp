// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/evaluate/grid_indices.h"

#include <algorithm>
#include <utility>

namespace glark::evaluate {
namespace {

std::int64_t bytes_of(unsigned level, std::uint32_t triangles) {
  return static_cast<std::int64_t>(lattice_indices(level) * triangles * sizeof(std::uint32_t));
}

}  // namespace

bool GridIndices::read_pattern(const gl::Dispatch& gl, const pattern::GpuPool& pool, unsigned number, Level& level) {
  const pattern::Piece& piece = pool.piece(pattern::uniform_piece(static_cast<int>(number)));
  std::vector<std::uint16_t> pattern = pool.read_indices(gl, piece);
  if (pattern.empty()) {
    return false;
  }
  const auto [least, most] = std::minmax_element(pattern.begin(), pattern.end());
  const std::uint16_t first = *least;
  level.first_vertex = first;
  level.vertex_count = *most - first + 1;
  for (std::uint16_t& index : pattern) {
    index = static_cast<std::uint16_t>(index - first);
  }
  if (pattern != level.pattern) {
    level.pattern = std::move(pattern);
    level.triangles = 0;  // the indices in the buffer are those of another pattern
  }
  return true;
}

std::int64_t GridIndices::bytes_with(unsigned level, std::uint32_t triangles) const {
  std::int64_t bytes = 0;
  for (unsigned other = 0; other < levels_.size(); ++other) {
    const Level& found = levels_.at(other);
    const bool grows = other == level && triangles > found.triangles;
    bytes += found.older_bytes + found.buffer.size() + (grows ? bytes_of(level, found.grown(triangles)) : 0);
  }
  return bytes;
}

// Writes the indices of coarse triangles from `first` on.
void GridIndices::write(const gl::Dispatch& gl, const Level& level, std::uint32_t first, std::uint32_t triangles) {
  std::vector<std::uint32_t> indices;
  indices.reserve(level.pattern.size() * triangles);
  for (std::uint32_t triangle = first; triangle < first + triangles; ++triangle) {
    const std::uint32_t vertex = triangle * static_cast<std::uint32_t>(level.vertex_count);
    for (const std::uint16_t index : level.pattern) {
      indices.push_back(vertex + index);
    }
  }
  const auto each = static_cast<std::int64_t>(level.pattern.size() * sizeof(indices[0]));
  level.buffer.write(gl, first * each, triangles * each, indices.data());
}

bool GridIndices::fill(const gl::Dispatch& gl, Level& level, std::uint32_t triangles) {
  const auto each = static_cast<std::int64_t>(level.pattern.size() * sizeof(std::uint32_t));
  const std::int64_t older = level.buffer.size();
  if (!level.buffer.allocate(gl, triangles * each, nullptr, GL_STATIC_DRAW)) {
    return false;
  }
  level.older_bytes += older;
  level.triangles = 0;
  constexpr std::int64_t bytes_at_once = std::int64_t{1} << 20;
  const auto at_once = static_cast<std::uint32_t>(std::max<std::int64_t>(1, bytes_at_once / each));
  for (std::uint32_t first = 0; first < triangles; first += at_once) {
    write(gl, level, first, std::min(at_once, triangles - first));
  }
  if (gl.GetError() != GL_NO_ERROR) {
    return false;
  }
  level.triangles = triangles;
  return true;
}

GridIndices::Grid GridIndices::ensure(const gl::Dispatch& gl, const pattern::GpuPool& pool, std::uint64_t pool_number,
                                      unsigned level, std::uint32_t triangles) {
  Level& found = levels_.at(level);
  if (found.pool_number != pool_number) {
    if (!read_pattern(gl, pool, level, found)) {
      return {};
    }
    found.pool_number = pool_number;
  }
  if (found.triangles < triangles && !fill(gl, found, found.grown(triangles))) {
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
