// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/result/balls_in_cells.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "glark/clients/reconstruct/result/triangle_distance.h"

namespace glark::reconstruct {
namespace {

template <typename Body>
void each_cell(const CellBox& box, const Body& body) {
  for (std::int32_t z = box.low[2]; z <= box.high[2]; ++z) {
    for (std::int32_t y = box.low[1]; y <= box.high[1]; ++y) {
      for (std::int32_t x = box.low[0]; x <= box.high[0]; ++x) body(CellIndex{x, y, z});
    }
  }
}

// The finest level whose cells are at least as wide.
unsigned level_for(float width) {
  if (!(width > 0)) return cell_levels;
  return static_cast<unsigned>(std::clamp(std::floor(-std::log2(width)), 0.0F, static_cast<float>(cell_levels)));
}

float longest(Float4 way) { return std::max({way[0], way[1], way[2]}); }

}  // namespace

BallsInCells::BallsInCells(const std::vector<Ball>& balls)
    : balls_(balls), is_left_(balls.size(), true), table_(4 * balls.size()) {
  std::array<bool, cell_levels + 1> is_used{};
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    const Float4 reach = Float4{1, 1, 1, 0} * balls[i].radius;
    const unsigned level = level_for(2 * balls[i].radius);
    is_used[level] = true;
    each_cell({cell_of(balls[i].centre - reach, level), cell_of(balls[i].centre + reach, level)},
              [&](const CellIndex& cell) { add(i, level, cell); });
  }
  for (unsigned level = 0; level <= cell_levels; ++level) {
    if (is_used[level]) levels_.push_back(level);
  }
}

BallsInCells::Cell& BallsInCells::cell_at(unsigned level, const CellIndex& cell) {
  const auto next = static_cast<std::uint32_t>(cells_.size());
  const std::uint32_t number = table_.insert(key_on(level, cell), next);
  if (number == next) cells_.emplace_back();
  return cells_[number];
}

void BallsInCells::add(std::uint32_t ball, unsigned level, const CellIndex& cell) {
  Cell& own = cell_at(level, cell);
  links_.push_back({ball, own.first});
  own.first = static_cast<std::uint32_t>(links_.size() - 1);
  for (CellIndex above = cell; level-- > 0;) {
    for (std::int32_t& number : above) number /= 2;
    Cell& wider = cell_at(level, above);
    if (wider.has_finer) return;
    wider.has_finer = true;
  }
}

std::vector<Ball> BallsInCells::left() const {
  std::vector<Ball> result;
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    if (is_left_[i]) result.push_back(balls_[i]);
  }
  return result;
}

CellBox BallsInCells::cells_of(const CellBox& finest, unsigned level) {
  const unsigned shift = cell_levels - level;
  CellBox box;
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] = finest.low[i] >> shift;
    box.high[i] = finest.high[i] >> shift;
  }
  return box;
}

void BallsInCells::take_in(Cell& cell, const Shape& shape) {
  const auto squared_distance = [&](Float4 from) {
    const Float4 apart = from - shape.a;
    return shape.is_point ? dot(apart, apart) : squared_distance_to_triangle(from, shape.a, shape.b, shape.c);
  };
  std::uint32_t* last = &cell.first;
  while (*last != none) {
    Link& link = links_[*last];
    if (is_left_[link.ball]) {
      const Ball& ball = balls_[link.ball];
      if (dot(ball.normal, shape.normal) < 0 || squared_distance(ball.centre) > ball.radius * ball.radius) {
        last = &link.next;
        continue;
      }
      is_left_[link.ball] = false;
    }
    *last = link.next;
  }
}

void BallsInCells::visit(unsigned level, const CellIndex& cell, bool descends, const CellBox& finest,
                         const Shape& shape) {
  const std::uint32_t number = table_.find(key_on(level, cell));
  if (number == CellTable::absent) return;
  take_in(cells_[number], shape);
  if (!descends || !cells_[number].has_finer) return;
  const CellBox inside = cells_of(finest, level + 1);
  CellBox children;
  for (std::size_t i = 0; i < 3; ++i) {
    children.low[i] = std::max(inside.low[i], 2 * cell[i]);
    children.high[i] = std::min(inside.high[i], 2 * cell[i] + 1);
  }
  each_cell(children, [&](const CellIndex& child) { visit(level + 1, child, true, finest, shape); });
}

// On the level of cells as wide as the shape, and on coarser levels, it touches few cells. Finer cells are found from
// the cells that hold them.
void BallsInCells::take(const Shape& shape) {
  if (levels_.empty()) return;
  const Float4 low = least(least(shape.a, shape.b), shape.c), high = greatest(greatest(shape.a, shape.b), shape.c);
  const unsigned own = shape.is_point ? levels_.back() : std::min(level_for(longest(high - low)), levels_.back());
  const CellBox finest{cell_of(low, cell_levels), cell_of(high, cell_levels)};
  for (const unsigned level : levels_) {
    if (level >= own) break;
    each_cell(cells_of(finest, level), [&](const CellIndex& cell) { visit(level, cell, false, finest, shape); });
  }
  each_cell(cells_of(finest, own), [&](const CellIndex& cell) { visit(own, cell, true, finest, shape); });
}

}  // namespace glark::reconstruct
