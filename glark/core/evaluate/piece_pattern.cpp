// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/evaluate/piece_pattern.h"

#include <unordered_map>

namespace glark::evaluate {

PiecePattern piece_pattern(std::span<const std::uint16_t> indices) {
  PiecePattern pattern;
  pattern.indices.reserve(indices.size());
  std::unordered_map<std::uint16_t, std::uint16_t> numbers;
  for (const std::uint16_t vertex : indices) {
    const auto [at, fresh] = numbers.try_emplace(vertex, static_cast<std::uint16_t>(pattern.vertices.size()));
    if (fresh) {
      pattern.vertices.push_back(vertex);
    }
    pattern.indices.push_back(at->second);
  }
  return pattern;
}

const PiecePattern& PiecePatterns::find(const gl::Dispatch& gl, const pattern::GpuPool& pool, std::uint64_t pool_number,
                                        std::uint32_t first_index, std::uint32_t index_count) {
  if (pool_number != pool_number_) {
    patterns_.clear();
    pool_number_ = pool_number;
  }
  const auto [at, missing] = patterns_.try_emplace({first_index, index_count});
  if (missing || at->second.indices.empty()) {
    at->second = piece_pattern(pool.read_indices(gl, {first_index, index_count, 0, 0}));
  }
  return at->second;
}

}  // namespace glark::evaluate
