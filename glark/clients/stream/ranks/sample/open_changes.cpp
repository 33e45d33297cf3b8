// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/ranks/sample/open_changes.h"

#include <bit>

#include "glark/clients/stream/ranks/deliver.h"
#include "glark/clients/stream/ranks/range.h"
#include "glark/clients/stream/sample/pass/open_memory.h"

namespace glark::stream {

bool fit_in_open_memory(Ranks& ranks, const Plan& plan, std::uint64_t batches, const std::vector<OpenChange>& changes) {
  std::vector<std::vector<OpenChange>> to_each(ranks.size());
  const std::uint64_t each = range_of(ranks, 0, batches, 1).end;  // the first ranks have the most batches
  for (const OpenChange& change : changes) {
    std::size_t rank = change.batch / each;
    while (change.batch < range_of(ranks, rank, batches, 1).begin) --rank;
    while (change.batch >= range_of(ranks, rank, batches, 1).end) ++rank;
    to_each[rank].push_back(change);
  }
  const RankRange range = range_of(ranks, batches, 1);
  std::vector<std::int64_t> bytes(static_cast<std::size_t>(range.end - range.begin));
  deliver_values(ranks, to_each, [&](std::size_t, std::span<const OpenChange> some) {
    for (const OpenChange& change : some) bytes[static_cast<std::size_t>(change.batch - range.begin)] += change.bytes;
  });
  std::int64_t own = 0, open = 0;
  for (const std::int64_t change : bytes) own += change;
  const std::vector<std::uint64_t> totals = share(ranks, std::bit_cast<std::uint64_t>(own));
  for (std::size_t rank = 0; rank < ranks.rank(); ++rank) open += std::bit_cast<std::int64_t>(totals[rank]);
  bool fits = true;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    open += bytes[i];
    fits = fits && fits_in_open_memory(plan, static_cast<std::size_t>(open), range.begin + i + 1);
  }
  return sum(ranks, fits ? 0 : 1) == 0;
}

}  // namespace glark::stream
