// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "glark/clients/stream/ranks/ranks.h"

namespace glark::stream {

// The part of a row of elements that a rank works on.
struct RankRange {
  std::uint64_t begin = 0, end = 0;
};

// Ranges of all ranks follow one another. They begin at multiples of `step`, and differ by one step at most.
inline RankRange range_of(const Ranks& ranks, std::size_t rank, std::uint64_t count, std::uint64_t step) {
  const std::uint64_t steps = (count + step - 1) / step, each = steps / ranks.size(), more = steps % ranks.size();
  const auto begin = [&](std::uint64_t r) { return std::min(count, step * (each * r + std::min(r, more))); };
  return {begin(rank), begin(rank + 1)};
}
inline RankRange range_of(const Ranks& ranks, std::uint64_t count, std::uint64_t step) {
  return range_of(ranks, ranks.rank(), count, step);
}

}  // namespace glark::stream
