// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/pattern/pool.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "glark/core/pattern/pieces/border_pieces.h"
#include "glark/core/pattern/pieces/whole_pieces.h"
#include "glark/core/pattern/uniform_order.h"

namespace glark::pattern {
namespace {

// Appends uniform(m) and interior(m), which is its prefix; vertices are in the order of their first use.
void append_uniform(Pool& pool, int m) {
  constexpr std::uint16_t unused = 0xffff;
  int n = 1 << m;
  UniformOrder order = order_uniform(n);
  auto first_index = static_cast<std::uint32_t>(pool.indices.size());
  auto base_vertex = static_cast<std::uint16_t>(pool.vertices.size());
  std::uint16_t vertex_count = 0;
  auto close_piece = [&](int number, std::size_t triangle_count) {
    pool.pieces[static_cast<std::size_t>(number)] = {first_index, static_cast<std::uint32_t>(3 * triangle_count),
                                                     base_vertex, vertex_count};
  };
  std::vector<std::uint16_t> index_of(static_cast<std::size_t>((n + 1) * (n + 1)), unused);
  for (std::size_t k = 0; k < order.triangles.size(); ++k) {
    if (k != 0 && k == order.interior_count && m <= tile_level) close_piece(interior_piece(m), k);
    for (LatticePoint p : order.triangles[k]) {
      std::uint16_t& index =
          index_of[static_cast<std::size_t>(p.j) * static_cast<std::size_t>(n + 1) + static_cast<std::size_t>(p.i)];
      if (index == unused) {
        index = vertex_count++;
        int step = lattice_one / n;
        pool.vertices.push_back({static_cast<std::uint16_t>(p.i * step), static_cast<std::uint16_t>(p.j * step)});
      }
      pool.indices.push_back(index);
    }
  }
  close_piece(uniform_piece(m), order.triangles.size());
}

}  // namespace

Pool build_pool(unsigned max_level, bool nested) {
  if (max_level > static_cast<unsigned>(deepest_level)) {
    throw std::invalid_argument("glark: pool level " + std::to_string(max_level) + " exceeds " +
                                std::to_string(deepest_level) + "; ask for a lower maximum level");
  }
  Pool pool{};
  pool.max_level = max_level;
  pool.nested = nested;
  append_border_pieces(pool);
  for (int m = 0; m <= std::min(static_cast<int>(max_level), deepest_uniform); ++m) append_uniform(pool, m);
  if (!nested) append_whole_pieces(pool);
  return pool;
}

}  // namespace glark::pattern
