// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/tree/cells.h"

#include <algorithm>

namespace glark::vstree {
namespace {

constexpr std::size_t grain = 1 << 16;  // the least number of records for a thread

std::vector<Cell> finest(std::span<const std::uint32_t> begins) {
  std::vector<Cell> cells;
  cells.reserve(std::min<std::size_t>(begins.size(), begins.back() + 1));
  for (std::uint32_t key = 0; key + 1 < begins.size(); ++key) {
    if (begins[key] != begins[key + 1]) cells.push_back({key, begins[key], 0});
  }
  cells.push_back({0, begins.back(), 0});
  return cells;
}

std::vector<Cell> coarser(const std::vector<Cell>& fine, unsigned key_bits) {
  std::vector<Cell> cells;
  cells.reserve(fine.size());
  for (std::uint32_t i = 0; i + 1 < fine.size(); ++i) {
    const std::uint32_t key = fine[i].key >> key_bits;
    if (cells.empty() || cells.back().key != key) cells.push_back({key, fine[i].begin, i});
  }
  cells.push_back({0, fine.back().begin, static_cast<std::uint32_t>(fine.size() - 1)});
  return cells;
}

}  // namespace

Cells cells_of(std::span<const std::uint32_t> begins, unsigned levels, unsigned key_bits) {
  Cells result;
  result.levels.resize(levels + 1);
  result.levels[levels] = finest(begins);
  for (unsigned level = levels; level-- > 0;) result.levels[level] = coarser(result.levels[level + 1], key_bits);
  return result;
}

void add_moments(Cells& cells, std::span<const Record> sorted, const Workers& workers) {
  cells.moments.resize(cells.levels.size());
  const std::vector<Cell>& fine = cells.levels.back();
  const std::size_t count = fine.size() - 1;
  cells.moments.back().resize(count);
  const std::size_t cells_a_piece = std::max<std::size_t>(1, grain * count / std::max<std::size_t>(1, sorted.size()));
  workers.each(count, cells_a_piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      cells.moments.back()[i] = Moments::of(sorted.subspan(fine[i].begin, fine[i + 1].begin - fine[i].begin));
  });
  for (std::size_t level = cells.levels.size() - 1; level-- > 0;) {
    const std::vector<Cell>& mine = cells.levels[level];
    for (std::size_t i = 0; i + 1 < mine.size(); ++i) {
      Moments& sum = cells.moments[level].emplace_back(cells.moments[level + 1][mine[i].first_child]);
      for (std::uint32_t child = mine[i].first_child + 1; child < mine[i + 1].first_child; ++child)
        sum.add(cells.moments[level + 1][child]);
    }
  }
}

}  // namespace glark::vstree
