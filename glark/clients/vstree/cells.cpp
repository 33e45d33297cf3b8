// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/cells.h"

#include <algorithm>
#include <utility>

namespace glark::vstree {
namespace {

constexpr std::size_t grain = 1 << 16;  // fewer records are not worth a thread

// counts[part * cells + cell] becomes the slot of the part's first record of the cell.
std::vector<std::uint32_t> slots_of(std::vector<std::uint32_t>& counts, std::size_t parts, std::size_t cells) {
  std::vector<std::uint32_t> begins(cells + 1);
  std::uint32_t slot = 0;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    begins[cell] = slot;
    for (std::size_t part = 0; part < parts; ++part) slot += std::exchange(counts[part * cells + cell], slot);
  }
  begins[cells] = slot;
  return begins;
}

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

std::vector<std::uint32_t> sort_by_key(std::size_t count, std::size_t cells, const KeyFunction& key,
                                       const MoveFunction& move, const Workers& workers) {
  thread_local std::vector<std::uint32_t> kept_keys;
  std::vector<std::uint32_t> keys = std::exchange(kept_keys, {});  // another task may run here while this one waits
  keys.resize(std::max(keys.size(), count));
  const std::size_t parts = std::clamp<std::size_t>(count / grain, 1, workers.count());
  std::vector<std::uint32_t> counts(parts * cells);
  const auto part_begin = [&](std::size_t part) { return count * part / parts; };
  workers.each(parts, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t part = first; part < last; ++part) {
      key(part_begin(part), part_begin(part + 1), keys.data() + part_begin(part));
      std::uint32_t* const mine = counts.data() + part * cells;
      for (std::size_t i = part_begin(part); i < part_begin(part + 1); ++i) ++mine[keys[i]];
    }
  });
  std::vector<std::uint32_t> begins = slots_of(counts, parts, cells);
  workers.each(parts, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t part = first; part < last; ++part) {
      std::uint32_t* const mine = counts.data() + part * cells;
      for (std::size_t i = part_begin(part); i < part_begin(part + 1); ++i) keys[i] = mine[keys[i]]++;
      move(part_begin(part), part_begin(part + 1), keys.data() + part_begin(part));
    }
  });
  if (keys.size() <= grain) kept_keys = std::move(keys);
  return begins;
}

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
