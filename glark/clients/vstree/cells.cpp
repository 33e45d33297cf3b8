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

std::vector<Cell> finest(std::span<const Record> sorted, std::span<const std::uint32_t> begins,
                         const Workers& workers) {
  std::vector<Cell> cells;
  for (std::uint32_t key = 0; key + 1 < begins.size(); ++key) {
    if (begins[key] == begins[key + 1]) continue;
    cells.emplace_back();
    cells.back().key = key;
    cells.back().begin = begins[key];
  }
  const std::size_t count = cells.size();
  cells.emplace_back();
  cells.back().begin = begins.back();
  const std::size_t cells_a_piece = std::max<std::size_t>(1, grain * count / std::max<std::size_t>(1, sorted.size()));
  workers.each(count, cells_a_piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      cells[i].moments = Moments::of(sorted.subspan(cells[i].begin, cells[i + 1].begin - cells[i].begin));
    }
  });
  return cells;
}

std::vector<Cell> coarser(const std::vector<Cell>& fine, unsigned key_bits) {
  std::vector<Cell> cells;
  for (std::uint32_t i = 0; i + 1 < fine.size(); ++i) {
    const std::uint32_t key = fine[i].key >> key_bits;
    if (cells.empty() || cells.back().key != key) {
      cells.push_back(fine[i]);
      cells.back().key = key;
      cells.back().first_child = i;
    } else {
      cells.back().moments.add(fine[i].moments);
    }
  }
  cells.push_back(fine.back());
  cells.back().first_child = static_cast<std::uint32_t>(fine.size() - 1);
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

Cells cells_of(std::span<const Record> sorted, std::span<const std::uint32_t> begins, unsigned levels,
               unsigned key_bits, const Workers& workers) {
  Cells result;
  result.levels.resize(levels + 1);
  result.levels[levels] = finest(sorted, begins, workers);
  for (unsigned level = levels; level > 0; --level) result.levels[level - 1] = coarser(result.levels[level], key_bits);
  return result;
}

}  // namespace glark::vstree
