// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/pattern/pieces/border_pieces.h"

#include <algorithm>
#include <utility>

#include "glark/core/pattern/pieces/zipper.h"

namespace glark::pattern {
namespace {

using Chain = std::vector<std::uint16_t>;

LatticeVertex lattice_vertex(int u, int v) { return {static_cast<std::uint16_t>(u), static_cast<std::uint16_t>(v)}; }

// A point of an edge, at `along` / lattice_one of the way from its first corner.
LatticeVertex edge_vertex(int edge, int along) {
  if (edge == 0) return lattice_vertex(along, 0);
  if (edge == 1) return lattice_vertex(lattice_one - along, along);
  return lattice_vertex(0, lattice_one - along);
}

// The shared block, from shallow to deep, so that a shallow piece finds its vertices close together: the corners, the
// inner rows, then the edges' midpoints level after level. Middle rows of smooth skirts follow.
class BorderBlock {
 public:
  explicit BorderBlock(Pool& pool)
      : pool_(pool), base_(pool.vertices.size()), max_level_(static_cast<int>(pool.max_level)) {
    for (int edge = 0; edge < 3; ++edge) append(edge_vertex(edge, 0));
    for (int m = shallowest_interior; m <= std::min(max_level_, tile_level); ++m)
      inner_rows_.push_back(append_inner_row(m));
    first_midpoint_ = pool.vertices.size() - base_;
    for (int level = 1; level <= max_level_; ++level) append_midpoints(level);
  }

  // The 2^d segments of an edge, from its first corner to its second.
  Chain edge_chain(int edge, int d) const {
    Chain chain;
    for (int k = 0; k <= 1 << d; ++k) chain.push_back(edge_index(edge, k, d));
    return chain;
  }

  const Chain& inner_row(int m) const { return inner_rows_[static_cast<std::size_t>(m - shallowest_interior)]; }

  // A row of 2^g segments between edge 0 and the inner row of interior(m), from corner to corner. It rises to 3/8 of
  // the height of the ring, at about 15 degrees: half of the angle between edge 0 and the cut in the corner.
  Chain append_middle_row(int m, int g) {
    int step = lattice_one >> g;
    int ceiling = (lattice_one >> m) / 8 * 3;
    Chain row{edge_index(0, 0, 0)};
    for (int k = 1; k < 1 << g; ++k) {
      int along = k * step;
      int rise = std::min(std::min(along, lattice_one - along) / 16 * 5, ceiling);
      row.push_back(append(lattice_vertex(along - rise / 2, rise)));
    }
    row.push_back(edge_index(0, 1, 0));
    return row;
  }

  // The centre, as nearly as the lattice allows. The vertex stage moves it to the same place for every rotation.
  Chain append_centre() { return {append(lattice_vertex(lattice_one / 3 + 1, lattice_one / 3 + 1))}; }

  template <class MakeTriangles>
  void add_piece(int number, MakeTriangles make_triangles) {
    std::size_t first = pool_.indices.size();
    std::span<const LatticeVertex> vertices(pool_.vertices.data() + base_, pool_.vertices.size() - base_);
    make_triangles(vertices, pool_.indices);
    std::uint16_t highest =
        *std::max_element(pool_.indices.begin() + static_cast<std::ptrdiff_t>(first), pool_.indices.end());
    pool_.pieces[static_cast<std::size_t>(number)] = {
        static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(pool_.indices.size() - first),
        static_cast<std::uint16_t>(base_), static_cast<std::uint16_t>(highest + 1)};
  }

 private:
  std::uint16_t append(LatticeVertex vertex) {
    pool_.vertices.push_back(vertex);
    return static_cast<std::uint16_t>(pool_.vertices.size() - 1 - base_);
  }

  Chain append_inner_row(int m) {
    int step = lattice_one >> m;
    Chain row;
    for (int i = 1; i <= (1 << m) - 2; ++i) row.push_back(append(lattice_vertex(i * step, step)));
    return row;
  }

  void append_midpoints(int level) {
    int step = lattice_one >> level;
    for (int edge = 0; edge < 3; ++edge) {
      for (int along = step; along < lattice_one; along += 2 * step) append(edge_vertex(edge, along));
    }
  }

  // The vertex at k / 2^d of the way along an edge.
  std::uint16_t edge_index(int edge, int k, int d) const {
    while (d > 0 && k % 2 == 0) {
      k /= 2;
      --d;
    }
    if (d == 0) return static_cast<std::uint16_t>((edge + k) % 3);
    int per_edge = 1 << (d - 1);
    int shallower = 3 * (per_edge - 1);
    return static_cast<std::uint16_t>(static_cast<int>(first_midpoint_) + shallower + edge * per_edge + k / 2);
  }

  Pool& pool_;
  std::size_t base_;
  int max_level_;
  std::size_t first_midpoint_ = 0;
  std::vector<Chain> inner_rows_;
};

void append_skirts(BorderBlock& block, int m, int max_level) {
  // expand.glsl.h asks for edges shallower than the interior only where it lifts the interior to level 2.
  for (int d = m == shallowest_interior ? 0 : m; d <= max_level; ++d) {
    block.add_piece(skirt_piece(m, d), [&](auto vertices, auto& indices) {
      zip(vertices, block.edge_chain(0, d), block.inner_row(m), indices);
    });
  }
}

// The middle row has about the geometric mean of the segments on its two sides, so that the least angles of both strips
// are alike.
void append_smooth_skirts(BorderBlock& block, int m, int max_level) {
  for (int d = m + smooth_difference; d <= max_level; ++d) {
    Chain middle = block.append_middle_row(m, (m + d) / 2);
    block.add_piece(smooth_skirt_piece(m, d), [&](auto vertices, auto& indices) {
      zip(vertices, block.edge_chain(0, d), middle, indices);
      zip(vertices, middle, block.inner_row(m), indices);
    });
  }
}

// Appends the triangles between an edge and a row of points beside it. Halving every segment of the edge halves
// triangles. Moving each row to the next shallower one gives the triangles of that row (docs/explanation/depths.md,
// Geomorphing).
void append_nested(const Chain& edge, const Chain& row, int segments_at_row, std::vector<std::uint16_t>& indices) {
  const int segments = static_cast<int>(edge.size()) - 1;
  const auto apex = [&](int segment) {
    const int at_row = segment * segments_at_row / segments;
    return static_cast<std::size_t>(std::clamp(at_row - 1, 0, static_cast<int>(row.size()) - 1));
  };
  std::size_t at = 0;
  const auto walk_row = [&](std::uint16_t from, std::size_t to) {
    for (; at < to; ++at) indices.insert(indices.end(), {from, row[at + 1], row[at]});
  };
  for (int k = 0; k < segments; ++k) {
    const auto from = static_cast<std::size_t>(k);
    walk_row(edge[from], apex(k));
    indices.insert(indices.end(), {edge[from], edge[from + 1], row[at]});
  }
  walk_row(edge.back(), row.size() - 1);  // the rest of the row, if it has more segments than the edge
}

void append_nested_skirts(BorderBlock& block, int max_level) {
  for (int m = shallowest_interior; m <= std::min(max_level, tile_level); ++m) {
    for (int d = m <= lifted_interior ? 0 : m; d <= max_level; ++d) {
      block.add_piece(skirt_piece(m, d), [&](auto /*vertices*/, auto& indices) {
        append_nested(block.edge_chain(0, d), block.inner_row(m), 1 << m, indices);
      });
    }
  }
  const Chain centre = block.append_centre();
  for (int d = 0; d <= max_level; ++d) {
    block.add_piece(centre_skirt_piece(d), [&](auto /*vertices*/, auto& indices) {
      append_nested(block.edge_chain(0, d), centre, 1, indices);
    });
  }
}

void append_fans(BorderBlock& block, int max_level) {
  for (int b = 0; b <= max_level; ++b) {
    for (int c = 0; c <= max_level; ++c) {
      Chain right = block.edge_chain(1, b);
      Chain left = block.edge_chain(2, c);
      std::reverse(left.begin(), left.end());
      block.add_piece(fan_piece(b, c), [&](auto vertices, auto& indices) { zip(vertices, right, left, indices); });
    }
  }
}

}  // namespace

void append_border_pieces(Pool& pool) {
  BorderBlock block(pool);
  int max_level = static_cast<int>(pool.max_level);
  if (pool.nested) append_nested_skirts(block, max_level);
  for (int m = shallowest_interior; m <= std::min(max_level, tile_level) && !pool.nested; ++m) {
    append_skirts(block, m, max_level);
    append_smooth_skirts(block, m, max_level);
  }
  append_fans(block, max_level);
}

}  // namespace glark::pattern
