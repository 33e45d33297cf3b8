// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Based on: G. Nielson, Dual Marching Cubes, 2004: a cell has one vertex for each sheet of the surface that passes
// through it, so that the sheets stay apart.
#include "glark/clients/reconstruct/contour/contour.h"

#include <algorithm>

#include "glark/clients/reconstruct/contour/sheets.h"
#include "glark/clients/reconstruct/contour/thin_cells.h"
#include "glark/clients/reconstruct/contour/wide_block.h"

namespace glark::reconstruct {
namespace {

constexpr std::size_t grain = 16;        // in blocks
constexpr std::uint8_t thin_mark = 255;  // in BlockCells::inside

// The cells of a block that the surface passes through. The arrays are empty if there are none.
struct BlockCells {
  std::vector<std::uint8_t>
      inside;  // [block_corners] which corners are inside, or thin_mark; 0: the surface does not pass through the cell
  std::vector<std::uint32_t> first;                           // [block_corners] the first vertex
  std::uint32_t count = 0;                                    // the number of vertices
  std::vector<std::pair<std::uint32_t, std::uint32_t>> thin;  // the cells that are thin, and their indices

  void make_room() {
    if (!inside.empty()) return;
    inside.resize(block_corners);
    first.resize(block_corners);
  }
};

class Contouring {
 public:
  Contouring(const Blocks& blocks, const std::vector<ThinCell>& thin, unsigned level)
      : blocks_(blocks), thin_(thin), level_(level), cells_(blocks.places.size()) {
    for (std::uint32_t i = 0; i < thin.size(); ++i) {
      const CellIndex& cell = thin[i].cell();
      const std::uint32_t block = blocks.find({cell[0] / block_side, cell[1] / block_side, cell[2] / block_side});
      cells_[block].thin.emplace_back(corner_in_block(cell[0] % block_side, cell[1] % block_side, cell[2] % block_side),
                                      i);
    }
  }

  Contour run(const Workers& workers) {
    workers.each(cells_.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) classify(static_cast<std::uint32_t>(i));
    });
    std::uint32_t vertices = 0;
    for (BlockCells& block : cells_) {
      for (std::uint32_t& first : block.first) first += vertices;
      vertices += block.count;
    }
    contour_.has_thin_cells = !thin_.empty();
    contour_.points.resize(vertices);
    contour_.cells.resize(vertices);
    std::vector<std::vector<std::uint32_t>> quads(cells_.size());
    workers.each(cells_.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        if (cells_[i].count > 0) place_vertices(static_cast<std::uint32_t>(i));
        quads_of(static_cast<std::uint32_t>(i), quads[i]);
      }
    });
    for (const auto& part : quads) contour_.quads.insert(contour_.quads.end(), part.begin(), part.end());
    return std::move(contour_);
  }

 private:
  static float corner_value(const WideValues& values, std::int32_t x, std::int32_t y, std::int32_t z, unsigned corner) {
    return values[in_wide(x + static_cast<int>(corner & 1), y + static_cast<int>((corner >> 1) & 1),
                          z + static_cast<int>(corner >> 2))];
  }

  void classify(std::uint32_t number) {
    WideValues values;
    values_of(blocks_, number, values);
    BlockCells& block = cells_[number];
    for (const auto& [cell, i] : block.thin) {
      block.make_room();
      block.inside[cell] = thin_mark;
      block.first[cell] = block.count;
      block.count += static_cast<std::uint32_t>(thin_[i].sheets().size());
    }
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    if (*least >= 0 || *greatest < 0) return;
    for (std::int32_t z = 0; z < block_side; ++z) {
      for (std::int32_t y = 0; y < block_side; ++y) {
        for (std::int32_t x = 0; x < block_side; ++x) {
          unsigned inside = 0;
          bool known = true;
          for (unsigned corner = 0; corner < 8; ++corner) {
            const float value = corner_value(values, x, y, z, corner);
            inside |= value < 0 ? 1U << corner : 0U;
            known &= value != no_value;
          }
          if (!known || inside == 0 || inside == 255) continue;
          const std::size_t cell = corner_in_block(x, y, z);
          block.make_room();
          if (block.inside[cell] == thin_mark) continue;
          block.inside[cell] = static_cast<std::uint8_t>(inside);
          block.first[cell] = block.count;
          block.count += sheets_of(inside).count;
        }
      }
    }
  }

  void place_vertices(std::uint32_t number) {
    WideValues values;
    values_of(blocks_, number, values);
    const BlockCells& block = cells_[number];
    const CellIndex place = blocks_.places[number];
    const float side = 1.0F / static_cast<float>(1U << level_);
    for (const auto& [cell, number_of_thin] : block.thin)
      place_vertices_of(thin_[number_of_thin], block.first[cell], side);
    for (std::int32_t z = 0; z < block_side; ++z) {
      for (std::int32_t y = 0; y < block_side; ++y) {
        for (std::int32_t x = 0; x < block_side; ++x) {
          const std::size_t cell = corner_in_block(x, y, z);
          if (block.inside[cell] == 0 || block.inside[cell] == thin_mark) continue;
          const CellIndex at{block_side * place[0] + x, block_side * place[1] + y, block_side * place[2] + z};
          const Float4 low{static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2]), 0};
          const Sheets& sheets = sheets_of(block.inside[cell]);
          std::array<Float4, 4> sums{};  // the fourth float is the number of points
          for (unsigned edge = 0; edge < 12; ++edge) {
            if (sheets.of_edge[edge] == no_sheet) continue;
            const CellEdge ends = edge_of_cell(edge);
            const float from = corner_value(values, x, y, z, ends.from), to = corner_value(values, x, y, z, ends.to);
            Float4 crossing{static_cast<float>(ends.from & 1), static_cast<float>((ends.from >> 1) & 1),
                            static_cast<float>(ends.from >> 2), 1};
            crossing[static_cast<int>(edge / 4)] += from / (from - to);
            sums[sheets.of_edge[edge]] += crossing;
          }
          for (std::uint32_t i = 0; i < sheets.count; ++i) {
            contour_.points[block.first[cell] + i] = without_fourth(sums[i] / sums[i][3] + low) * side;
            contour_.cells[block.first[cell] + i] = key_of(at);
          }
        }
      }
    }
  }

  void place_vertices_of(const ThinCell& cell, std::uint32_t first, float side) {
    const CellIndex at = cell.cell();
    const Float4 low{static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2]), 0};
    for (const Float4& point : cell.sheets()) {
      contour_.points[first] = (point + low) * side;
      contour_.cells[first++] = key_of(at);
    }
  }

  // A cell of a block.
  struct Place {
    std::uint32_t block;
    std::uint32_t cell;
  };
  using Places = std::array<Place, wide_cells>;

  // Returns the corners of the cell that are inside, or 0 if the surface does not pass through the cell.
  std::uint8_t inside_of(const Place& place) const {
    if (place.block == CellTable::absent || cells_[place.block].count == 0) return 0;
    return cells_[place.block].inside[place.cell];
  }

  // Makes the quadrilaterals of the edges that start at the corners of a block. A quadrilateral has a vertex in each of
  // the four cells around its edge. One of these cells lies in the block, so a block without vertices has no
  // quadrilaterals.
  void quads_of(std::uint32_t number, std::vector<std::uint32_t>& quads) const {
    if (cells_[number].count == 0) return;
    Places around;
    gather(
        blocks_, number, -1, Place{CellTable::absent, 0},
        [](std::uint32_t from, std::size_t i) {
          return Place{from, static_cast<std::uint32_t>(i)};
        },
        around);
    for (std::int32_t z = 1; z < wide; ++z) {
      for (std::int32_t y = 1; y < wide; ++y) {
        for (std::int32_t x = 1; x < wide; ++x) add_quads(around, in_wide(x, y, z), quads);
      }
    }
  }

  const ThinCell& thin_at(const Place& place) const {
    const auto& thin = cells_[place.block].thin;
    return thin_[std::find_if(thin.begin(), thin.end(), [&](const auto& one) {
                   return one.first == place.cell;
                 })->second];
  }

  // Returns the vertex of the sheet that crosses an edge of the cell, as crossing `which` of the edge.
  std::uint32_t vertex_at(const Place& place, std::uint8_t mask, unsigned edge, std::uint32_t which) const {
    const std::uint32_t sheet =
        mask == thin_mark ? thin_at(place).sheet_of(edge, which) : sheets_of(mask).of_edge[edge];
    return cells_[place.block].first[place.cell] + sheet;
  }

  void add_quads(const Places& around, std::size_t cell, std::vector<std::uint32_t>& quads) const {
    const std::uint8_t inside = inside_of(around[cell]);
    if (inside == 0) return;
    if (inside == thin_mark) {
      const ThinCell& thin = thin_at(around[cell]);
      for (unsigned axis = 0; axis < 3; ++axis) {
        for (std::uint32_t i = 0; i < thin.crossings_of(4 * axis); ++i)
          add_quad(around, cell, axis, i, thin.is_inside(0) == (i % 2 == 0), quads);
      }
      return;
    }
    for (unsigned axis = 0; axis < 3; ++axis) {
      const bool from_inside = (inside & 1) != 0, to_inside = ((inside >> (1U << axis)) & 1) != 0;
      if (from_inside != to_inside) add_quad(around, cell, axis, 0, from_inside, quads);
    }
  }

  // Adds the quadrilateral of crossing `which` of the edge that starts at the cell's low corner.
  void add_quad(const Places& around, std::size_t cell, unsigned axis, std::uint32_t which, bool from_inside,
                std::vector<std::uint32_t>& quads) const {
    constexpr std::size_t steps[3] = {1, wide, static_cast<std::size_t>(wide) * wide};
    const std::size_t u = steps[(axis + 1) % 3], v = steps[(axis + 2) % 3];
    // The cells lie counter-clockwise about the axis; edges[i] is the number of the edge in cells[i].
    const std::size_t cells[4] = {cell - u - v, cell - v, cell, cell - u};
    const unsigned edges[4] = {3, 2, 0, 1};
    std::uint32_t corners[4];
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint8_t mask = inside_of(around[cells[i]]);
      if (mask == 0) return;
      corners[i] = vertex_at(around[cells[i]], mask, 4 * axis + edges[i], which);
    }
    if (!from_inside) std::swap(corners[1], corners[3]);
    quads.insert(quads.end(), corners, corners + 4);
  }

  const Blocks& blocks_;
  const std::vector<ThinCell>& thin_;
  const unsigned level_;
  std::vector<BlockCells> cells_;
  Contour contour_;
};

}  // namespace

Contour contour(const TransitionLayer& layer, unsigned level, const Workers& workers) {
  Blocks blocks = evaluate(layer, level, workers);
  const std::vector<ThinCell> thin = thin_cells(cross_thin_edges(layer, level, blocks, workers), blocks);
  return Contouring(blocks, thin, level).run(workers);
}

}  // namespace glark::reconstruct
