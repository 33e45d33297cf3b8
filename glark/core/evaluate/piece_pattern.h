// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The refined vertices and triangles of one instance of a piece.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "glark/core/pattern/gpu_pool.h"

namespace glark::evaluate {

struct PiecePattern {
  std::vector<std::uint16_t> vertices;  // in the pool, in the order of their first use
  std::vector<std::uint16_t> indices;   // into `vertices`
};

// `indices`: of the piece, into the vertices of the pool.
PiecePattern piece_pattern(std::span<const std::uint16_t> indices);

// Reads each piece of a pool back once.
class PiecePatterns {
 public:
  // `pool_number` tells pools apart. The pattern is empty if the piece cannot be read. Valid until the next pool.
  const PiecePattern& find(const gl::Dispatch& gl, const pattern::GpuPool& pool, std::uint64_t pool_number,
                           std::uint32_t first_index, std::uint32_t index_count);

 private:
  std::uint64_t pool_number_ = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, PiecePattern> patterns_;
};

}  // namespace glark::evaluate
