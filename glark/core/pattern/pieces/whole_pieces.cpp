// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/pattern/pieces/whole_pieces.h"

#include <algorithm>
#include <map>
#include <utility>

#include "glark/core/pattern/expand.h"

namespace glark::pattern {
namespace {

// Where an instance has a vertex of its piece. Exact, because these patterns have at most 2 * 2^5 segments on an edge.
LatticeVertex placed(LatticeVertex vertex, const Instance& instance) {
  const int local[3] = {lattice_one - vertex.u - vertex.v, vertex.u, vertex.v};
  float tile[3] = {};
  for (int k = 0; k < 3; ++k) tile[(k + static_cast<int>(instance.r)) % 3] = static_cast<float>(local[k]);
  const auto whole = static_cast<float>(lattice_one);
  return {static_cast<std::uint16_t>(instance.ou * whole + instance.s * tile[1]),
          static_cast<std::uint16_t>(instance.ov * whole + instance.s * tile[2])};
}

void append_whole(Pool& pool, int m, int b, int c) {
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::uint16_t> index_of;
  const auto base_vertex = static_cast<std::uint16_t>(pool.vertices.size());
  const auto first_index = static_cast<std::uint32_t>(pool.indices.size());
  for (const Instance& instance : expand(m, b, c, Interior::parts)) {
    const Piece& piece = pool.pieces[static_cast<std::size_t>(instance.piece)];
    for (std::uint32_t k = 0; k < piece.index_count; ++k) {
      const std::size_t from = std::size_t{piece.base_vertex} + pool.indices[piece.first_index + k];
      const LatticeVertex vertex = placed(pool.vertices[from], instance);
      const auto [place, fresh] =
          index_of.try_emplace({vertex.u, vertex.v}, static_cast<std::uint16_t>(index_of.size()));
      if (fresh) pool.vertices.push_back(vertex);
      pool.indices.push_back(place->second);
    }
  }
  pool.pieces[static_cast<std::size_t>(whole_piece(m, b, c))] = {
      first_index, static_cast<std::uint32_t>(pool.indices.size()) - first_index, base_vertex,
      static_cast<std::uint16_t>(index_of.size())};
}

}  // namespace

void append_whole_pieces(Pool& pool) {
  const int deepest = std::min(static_cast<int>(pool.max_level), deepest_whole);
  for (int m = 1; m <= deepest; ++m) {
    for (int b = m; b <= deepest; ++b) {
      for (int c = m; c <= deepest; ++c) {
        if (b != m || c != m) append_whole(pool, m, b, c);
      }
    }
  }
}

}  // namespace glark::pattern
