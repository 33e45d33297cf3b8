// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/fill/coarse_levels.h"

#include <algorithm>
#include <cassert>

namespace glark::maps {
namespace {

// Coarser levels have fewer cells, so more sweeps cost little.
constexpr int smoothing_sweeps = 2, most_sweeps = 16;
void resize(Level& level, unsigned width, unsigned height) {
  level.width = width;
  level.height = height;
  level.numbers.assign(std::size_t{width} * height, no_cell);
  level.cells.clear();
}

// Appends cells where `cell_at(x, y, cell)` returns true, first those with an even sum of column and row.
template <class CellAt>
void append_cells(Level& level, const CellAt& cell_at) {
  for (unsigned colour = 0; colour < 2; ++colour) {
    for (unsigned y = 0; y < level.height; ++y) {
      for (unsigned x = (y + colour) % 2; x < level.width; x += 2) {
        Cell cell{};
        if (!cell_at(x, y, cell)) continue;
        cell.position = y * level.width + x;
        cell.child = 4 * (y / 2 * ((level.width + 1) / 2) + x / 2) + quadrant_of(x, y);
        level.numbers[cell.position] = static_cast<std::uint32_t>(level.cells.size());
        level.cells.push_back(cell);
      }
    }
  }
}

void find_neighbours(Level& level) {
  for (std::uint32_t i = 0; i < level.cells.size(); ++i) {
    Cell& cell = level.cells[i];
    const std::array<std::uint32_t, 4> around{cell.position - 1, cell.position + 1, cell.position - level.width,
                                              cell.position + level.width};
    for (unsigned k = 0; k < 4; ++k) cell.neighbours[k] = cell.weights[k] > 0 ? level.numbers[around[k]] : i;
  }
}

// `side` is the width of a cell that does not reach beyond the raster.
Radius radius_of(const Cell& cell, const Level& level, const StateMap& map, unsigned side) {
  const unsigned x = cell.position % level.width * side, y = cell.position / level.width * side;
  const unsigned width = std::min(side, map.width - x), height = std::min(side, map.height - y);
  return {cell.count / (2 * static_cast<float>(height)), cell.count / (2 * static_cast<float>(width))};
}

// Turns the numbers of pairs into weights.
void divide_by_distances(Level& level, const StateMap& map, unsigned side, std::vector<Radius>& radii) {
  radii.clear();
  for (const Cell& cell : level.cells) radii.push_back(radius_of(cell, level, map, side));
  for (std::size_t i = 0; i < level.cells.size(); ++i) {
    Cell& cell = level.cells[i];
    const auto& neighbours = cell.neighbours;
    cell.weights[0] /= radii[i].x + radii[neighbours[0]].x;
    cell.weights[1] /= radii[i].x + radii[neighbours[1]].x;
    cell.weights[2] /= radii[i].y + radii[neighbours[2]].y;
    cell.weights[3] /= radii[i].y + radii[neighbours[3]].y;
    cell.known_scale = 1 / std::max(1.0F, std::max(radii[i].x, radii[i].y) + 0.5F);
    cell.known *= cell.known_scale;
    cell.inverse = 1 / (cell.known + (cell.weights[0] + cell.weights[1]) + (cell.weights[2] + cell.weights[3]));
  }
}

// The cells of 2 x 2 texels.
void build_first(const StateMap& map, Level& level) {
  resize(level, (map.width + 1) / 2, (map.height + 1) / 2);
  const std::array<std::ptrdiff_t, 4> steps{-1, 1, -static_cast<std::ptrdiff_t>(map.stride()),
                                            static_cast<std::ptrdiff_t>(map.stride())};
  append_cells(level, [&](unsigned cell_x, unsigned cell_y, Cell& cell) {
    for (unsigned k = 0; k < 4; ++k) {
      const unsigned x = 2 * cell_x + k % 2, y = 2 * cell_y + k / 2;
      if (x >= map.width || y >= map.height) continue;
      const TexelState* state = map.states.data() + map.at(x, y);
      if (*state != TexelState::unknown) continue;
      cell.count += 1;
      const std::array<bool, 4> leaves{k % 2 == 0, k % 2 == 1, k / 2 == 0, k / 2 == 1};
      for (unsigned side = 0; side < 4; ++side) {
        const TexelState neighbour = state[steps[side]];
        if (neighbour == TexelState::known) cell.known += 1;
        if (neighbour == TexelState::unknown && leaves[side]) cell.weights[side] += 1;
      }
    }
    return cell.count > 0;
  });
  find_neighbours(level);
}

void build_next(Level& fine, Level& level) {
  resize(level, (fine.width + 1) / 2, (fine.height + 1) / 2);
  append_cells(level, [&](unsigned cell_x, unsigned cell_y, Cell& cell) {
    for (unsigned k = 0; k < 4; ++k) {
      const unsigned x = 2 * cell_x + k % 2, y = 2 * cell_y + k / 2;
      if (x >= fine.width || y >= fine.height) continue;
      const std::uint32_t number_of_fine = fine.numbers[std::size_t{y} * fine.width + x];
      if (number_of_fine == no_cell) continue;
      const Cell& part = fine.cells[number_of_fine];
      cell.count += part.count;
      cell.known += part.known;
      cell.weights[k % 2] += part.weights[k % 2];
      cell.weights[2 + k / 2] += part.weights[2 + k / 2];
    }
    return cell.count > 0;
  });
  find_neighbours(level);
  for (Cell& cell : fine.cells) cell.child = 4 * level.numbers[cell.child / 4] + cell.child % 4;
}

// Adds the right sides of the cells to those of their parents.
template <unsigned blocks>
void restrict_to(const Level& fine, Level& coarse) {
  std::fill_n(coarse.right_sides.begin(), coarse.cells.size() * blocks, Float4{});
  for (std::size_t i = 0; i < fine.cells.size(); ++i) {
    Float4* to = coarse.right_sides.data() + std::size_t{fine.cells[i].child / 4} * blocks;
    for (unsigned b = 0; b < blocks; ++b) to[b] += fine.right_sides[i * blocks + b];
  }
}

// Sums of samples become right sides.
template <unsigned blocks>
void scale_known(Level& level) {
  for (std::size_t i = 0; i < level.cells.size(); ++i)
    for (unsigned b = 0; b < blocks; ++b) level.right_sides[i * blocks + b] *= level.cells[i].known_scale;
}

// Interpolates the values at the centres of the children. Where a cell has no neighbour, its own value stands for it.
template <unsigned blocks>
void interpolate(Level& level) {
  const Float4* values = level.values.data();
  Float4* child = level.children.data();
  for (std::size_t i = 0; i < level.cells.size(); ++i, child += 4 * blocks) {
    const std::array<std::uint32_t, 4>& neighbours = level.cells[i].neighbours;
    for (unsigned b = 0; b < blocks; ++b) {
      const auto quarter = [&](unsigned side) { return values[std::size_t{neighbours[side]} * blocks + b] * 0.25F; };
      const Float4 half = values[i * blocks + b] * 0.5F;
      const Float4 left = quarter(0), right = quarter(1), lower = quarter(2), upper = quarter(3);
      child[b] = half + (left + lower);
      child[blocks + b] = half + (right + lower);
      child[2 * blocks + b] = half + (left + upper);
      child[3 * blocks + b] = half + (right + upper);
    }
  }
}

template <unsigned blocks>
void prolong(const Level& coarse, Level& fine) {
  for (std::size_t i = 0; i < fine.cells.size(); ++i)
    for (unsigned b = 0; b < blocks; ++b)
      fine.values[i * blocks + b] = coarse.children[std::size_t{fine.cells[i].child} * blocks + b];
}

// One sweep of Gauss and Seidel. Even cells depend on odd ones only, and odd ones on even ones.
template <unsigned blocks>
void smooth(Level& level) {
  Float4* values = level.values.data();
  const Float4* right_sides = level.right_sides.data();
  for (std::size_t i = 0; i < level.cells.size(); ++i) {
    const Cell& cell = level.cells[i];
    for (unsigned b = 0; b < blocks; ++b) {
      Float4 sum = right_sides[i * blocks + b];
      for (unsigned k = 0; k < 4; ++k) sum += values[std::size_t{cell.neighbours[k]} * blocks + b] * cell.weights[k];
      values[i * blocks + b] = sum * cell.inverse;
    }
  }
}

}  // namespace

void CoarseLevels::build(const StateMap& map) {
  const auto next = [&]() -> Level& {
    if (used_ == levels_.size()) levels_.emplace_back();
    return levels_[used_++];
  };
  used_ = 0;
  build_first(map, next());
  while (levels_[used_ - 1].width > 1 || levels_[used_ - 1].height > 1) {
    Level& coarse = next();
    build_next(levels_[used_ - 2], coarse);
  }
  for (std::size_t l = 0; l < used_; ++l) divide_by_distances(levels_[l], map, 2U << l, radii_);
}

template <unsigned blocks>
void CoarseLevels::clear_right_sides() {
  for (std::size_t l = 0; l < used_; ++l) {
    const std::size_t size = levels_[l].cells.size() * blocks;
    if (levels_[l].values.size() < size) levels_[l].values.resize(size);
    if (levels_[l].children.size() < 4 * size) levels_[l].children.resize(4 * size);
    if (levels_[l].right_sides.size() < size) levels_[l].right_sides.resize(size);
  }
  Level& level = levels_.front();
  std::fill_n(level.right_sides.begin(), level.cells.size() * blocks, Float4{});
}

template <unsigned blocks>
void CoarseLevels::solve(Solution solution) {
  for (std::size_t l = 1; l < used_; ++l) restrict_to<blocks>(levels_[l - 1], levels_[l]);
  for (std::size_t l = 0; l < used_ && solution == Solution::values; ++l) scale_known<blocks>(levels_[l]);
  Level& coarsest = levels_[used_ - 1];
  assert(coarsest.cells.size() == 1 && coarsest.cells.front().known > 0);
  for (unsigned b = 0; b < blocks; ++b) coarsest.values[b] = coarsest.right_sides[b] * coarsest.cells.front().inverse;
  for (std::size_t l = used_ - 1; l-- > 0;) {
    interpolate<blocks>(levels_[l + 1]);
    prolong<blocks>(levels_[l + 1], levels_[l]);
    for (int sweep = 0; sweep < std::min(smoothing_sweeps << l, most_sweeps); ++sweep) smooth<blocks>(levels_[l]);
  }
  interpolate<blocks>(levels_.front());
}

template void CoarseLevels::clear_right_sides<1>();
template void CoarseLevels::clear_right_sides<2>();
template void CoarseLevels::solve<1>(Solution);
template void CoarseLevels::solve<2>(Solution);

}  // namespace glark::maps
