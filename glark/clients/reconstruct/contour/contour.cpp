// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Based on: G. Nielson, Dual Marching Cubes, 2004: a cell has one vertex for each sheet of the surface that passes
// through it, so that the sheets stay apart.
#include "glark/clients/reconstruct/contour/contour.h"

#include <algorithm>

#include "glark/clients/reconstruct/contour/blocks.h"
#include "glark/clients/reconstruct/contour/sheets.h"

namespace glark::reconstruct {
namespace {

constexpr std::size_t grain = 16;              // in blocks
constexpr std::int32_t wide = block_side + 1;  // the side of a block plus one row of a neighbour
constexpr std::size_t wide_cells = 9UL * 9UL * 9UL;

std::uint32_t in_wide(std::int32_t x, std::int32_t y, std::int32_t z) {
  return static_cast<std::uint32_t>(x + wide * (y + wide * z));
}

// The cells of a block that the surface passes through. The arrays are empty if there are none.
struct BlockCells {
  std::vector<std::uint8_t>
      inside;  // [block_corners] which corners are inside; 0: the surface does not pass through the cell
  std::vector<std::uint32_t> first;  // [block_corners] the first vertex
  std::uint32_t count = 0;           // the number of vertices
};

// Copies a block with one row of its neighbours: those after it (side 1) or those before it (side -1).
template <typename Value, typename Get>
void gather(const Blocks& blocks, std::uint32_t number, int side, Value missing, const Get& get,
            std::array<Value, wide_cells>& out) {
  const CellIndex place = blocks.places[number];
  for (int which = 0; which < 8; ++which) {
    const CellIndex apart{which & 1, (which >> 1) & 1, which >> 2};
    const std::uint32_t from =
        which == 0 ? number
                   : blocks.find({place[0] + side * apart[0], place[1] + side * apart[1], place[2] + side * apart[2]});
    // In the copy, the block starts at 1 if the neighbours lie before it, and at 0 if they lie after it.
    CellIndex low{}, high{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (apart[i] == 0) {
        low[i] = side > 0 ? 0 : 1;
        high[i] = low[i] + block_side;
      } else {
        low[i] = side > 0 ? block_side : 0;
        high[i] = low[i] + 1;
      }
    }
    for (std::int32_t z = low[2]; z < high[2]; ++z) {
      for (std::int32_t y = low[1]; y < high[1]; ++y) {
        for (std::int32_t x = low[0]; x < high[0]; ++x) {
          const auto local = [&](std::int32_t i) { return (side > 0 ? i : i + block_side - 1) % block_side; };
          out[in_wide(x, y, z)] =
              from == CellTable::absent ? missing : get(from, corner_in_block(local(x), local(y), local(z)));
        }
      }
    }
  }
}

class Contouring {
 public:
  Contouring(const Blocks& blocks, unsigned level) : blocks_(blocks), level_(level), cells_(blocks.places.size()) {}

  Contour run(const Workers& workers) {
    workers.each(cells_.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) classify(static_cast<std::uint32_t>(i));
    });
    std::uint32_t vertices = 0;
    for (BlockCells& block : cells_) {
      for (std::uint32_t& first : block.first) first += vertices;
      vertices += block.count;
    }
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
  using Values = std::array<float, wide_cells>;

  void values_of(std::uint32_t number, Values& values) const {
    gather(
        blocks_, number, 1, no_value, [&](std::uint32_t from, std::size_t i) { return blocks_.values[from][i]; },
        values);
  }

  static float corner_value(const Values& values, std::int32_t x, std::int32_t y, std::int32_t z, unsigned corner) {
    return values[in_wide(x + static_cast<int>(corner & 1), y + static_cast<int>((corner >> 1) & 1),
                          z + static_cast<int>(corner >> 2))];
  }

  void classify(std::uint32_t number) {
    Values values;
    values_of(number, values);
    BlockCells& block = cells_[number];
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
          if (block.inside.empty()) {
            block.inside.resize(block_corners);
            block.first.resize(block_corners);
          }
          block.inside[cell] = static_cast<std::uint8_t>(inside);
          block.first[cell] = block.count;
          block.count += sheets_of(inside).count;
        }
      }
    }
  }

  void place_vertices(std::uint32_t number) {
    Values values;
    values_of(number, values);
    const BlockCells& block = cells_[number];
    const CellIndex place = blocks_.places[number];
    const float side = 1.0F / static_cast<float>(1U << level_);
    for (std::int32_t z = 0; z < block_side; ++z) {
      for (std::int32_t y = 0; y < block_side; ++y) {
        for (std::int32_t x = 0; x < block_side; ++x) {
          const std::size_t cell = corner_in_block(x, y, z);
          if (block.inside[cell] == 0) continue;
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

  void add_quads(const Places& around, std::size_t cell, std::vector<std::uint32_t>& quads) const {
    constexpr std::size_t steps[3] = {1, wide, static_cast<std::size_t>(wide) * wide};
    const std::uint8_t inside = inside_of(around[cell]);
    if (inside == 0) return;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const bool from_inside = (inside & 1) != 0, to_inside = ((inside >> (1U << axis)) & 1) != 0;
      if (from_inside == to_inside) continue;
      const std::size_t u = steps[(axis + 1) % 3], v = steps[(axis + 2) % 3];
      // The cells lie counter-clockwise about the axis; edges[i] is the number of the edge in cells[i].
      const std::size_t cells[4] = {cell - u - v, cell - v, cell, cell - u};
      const unsigned edges[4] = {3, 2, 0, 1};
      std::uint32_t corners[4];
      bool known = true;
      for (std::size_t i = 0; i < 4 && known; ++i) {
        const Place place = around[cells[i]];
        const std::uint8_t mask = inside_of(place);
        known = mask != 0;
        if (known) corners[i] = cells_[place.block].first[place.cell] + sheets_of(mask).of_edge[4 * axis + edges[i]];
      }
      if (!known) continue;
      if (!from_inside) std::swap(corners[1], corners[3]);
      quads.insert(quads.end(), corners, corners + 4);
    }
  }

  const Blocks& blocks_;
  const unsigned level_;
  std::vector<BlockCells> cells_;
  Contour contour_;
};

}  // namespace

Contour contour(const TransitionLayer& layer, unsigned level, const Workers& workers) {
  const Blocks blocks = evaluate(layer, level, workers);
  return Contouring(blocks, level).run(workers);
}

}  // namespace glark::reconstruct
