// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/density/neighbours.h"

#include <algorithm>
#include <array>
#include <bit>

#include "glark/clients/common/points/point_set.h"

namespace glark::reconstruct {
namespace {

constexpr std::int32_t cells_away = 3;
constexpr std::size_t together = 4;  // a cell with this many samples is shared

// Returns the finest level on which about half of the samples are in shared cells. The mean number of samples in a cell
// would depend on outliers, because each outlier has a cell of its own.
unsigned level_of_most(const std::vector<Entry>& entries) {
  std::array<std::size_t, cell_levels + 1> counts{};  // runs of samples by the finest level on which they share a cell
  for (std::size_t i = together - 1; i < entries.size(); ++i) {
    const std::uint64_t apart = entries[i].key ^ entries[i + 1 - together].key;
    ++counts[apart == 0 ? cell_levels : cell_levels - 1 - static_cast<unsigned>(63 - std::countl_zero(apart)) / 3];
  }
  unsigned level = cell_levels;
  for (std::size_t sum = counts[level]; level > 0 && 2 * sum < entries.size(); sum += counts[level]) --level;
  return level;
}

}  // namespace

CellBox cells_around(const CellIndex& cell, unsigned level, std::int32_t away) {
  const std::int32_t last = (1 << level) - 1;
  CellBox box;
  for (unsigned i = 0; i < 3; ++i) {
    box.low[i] = std::max(cell[i] - away, 0);
    box.high[i] = std::min(cell[i] + away, last);
  }
  return box;
}

Neighbours::Neighbours(const PointSet& points, const Cube& cube, const std::vector<Entry>& entries)
    : points_(points), cube_(cube), entries_(entries) {
  levels_.push_back(finest_level(entries, level_of_most(entries)));
  while (levels_.back().level > 0) levels_.push_back(coarser(levels_.back()));
}

Float4 Neighbours::unit_normal_of(std::uint32_t entry) const {
  return unit_normal(&points_.normals[3 * index_of(entry)]);
}

// The last entry before `end` with the key of this one. There may be a million of them.
std::uint32_t Neighbours::last_alike(std::uint32_t entry, std::uint32_t end) const {
  const auto first = entries_.begin() + entry;
  const auto beyond =
      std::partition_point(first, entries_.begin() + end, [&](const Entry& other) { return other.key == first->key; });
  return static_cast<std::uint32_t>(beyond - entries_.begin()) - 1;
}

void Neighbours::find(std::uint32_t entry, std::size_t count, std::vector<Near>& out) const {
  const Float4 here = point(entry);
  for (const Level& level : levels_) {
    out.clear();
    level.blocks.each(cells_around(cell_of(here, level.level), level.level),
                      [&](std::uint32_t begin, std::uint32_t end) {
                        for (std::uint32_t i = begin; i < end; ++i) {
                          if (i > begin && entries_[i].key == entries_[i - 1].key) {
                            i = last_alike(i, end);
                            continue;
                          }
                          const Float4 apart = point(i) - here;
                          const float square = dot(apart, apart);
                          if (square > 0) out.push_back({square, i});
                        }
                      });
    if (out.size() >= 2 * count) break;
  }
  count = std::min(count, out.size());
  std::partial_sort(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(count), out.end());
  out.resize(count);
}

std::size_t Neighbours::level_for(float side) const {
  std::size_t level = 0;
  while (level + 1 < levels_.size() && levels_[level + 1].side() <= side) ++level;
  return level;
}

void Neighbours::find_one_a_cell(std::uint32_t entry, std::size_t level, std::vector<Near>& out) const {
  const Level& cells = levels_[level];
  const unsigned shift = 3 * (cell_levels - cells.level);
  const Float4 here = point(entry);
  out.clear();
  cells.blocks.each(cells_around(cell_of(here, cells.level), cells.level, cells_away),
                    [&](std::uint32_t begin, std::uint32_t end) {
                      while (begin < end) {
                        const Float4 apart = point(begin) - here;
                        const float square = dot(apart, apart);
                        if (square > 0) out.push_back({square, begin});
                        const std::uint64_t cell = entries_[begin].key >> shift;
                        begin = static_cast<std::uint32_t>(
                            std::partition_point(entries_.begin() + begin, entries_.begin() + end,
                                                 [&](const Entry& other) { return other.key >> shift == cell; }) -
                            entries_.begin());
                      }
                    });
  std::sort(out.begin(), out.end());
}

}  // namespace glark::reconstruct
