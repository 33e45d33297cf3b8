// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/common/counting_sort.h"

#include <algorithm>
#include <utility>

namespace glark::common {
namespace {

constexpr std::size_t grain = 1 << 16;  // the least number of records for a thread

// On entry, counts[part * cells + cell] is the number of a part's records in a cell. On return, it is the slot of the
// first of these records.
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

}  // namespace

std::vector<std::uint32_t> sort_by_key(std::size_t count, std::size_t cells, const KeyFunction& key,
                                       const MoveFunction& move, const Workers& workers) {
  thread_local std::vector<std::uint32_t> kept_keys;
  // While this thread waits, it may run another task that sorts, too. So it takes the buffer.
  std::vector<std::uint32_t> keys = std::exchange(kept_keys, {});
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

}  // namespace glark::common
