// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/ranks/sample/shares.h"
#include "glark/clients/stream/files/work_folder.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "glark/clients/stream/ranks/agreement.h"

namespace glark::stream {
namespace {

// Cubes of the level, where some may have been smaller. They are sorted.
std::vector<Cube> at_level(const std::vector<Cube>& cubes, unsigned level) {
  std::vector<Cube> larger;
  for (const Cube& cube : cubes) {
    const std::uint64_t key = key_at_level(cube.key, level);
    if (larger.empty() || larger.back().key != key) larger.emplace_back().key = key;
    larger.back().add(cube);
  }
  return larger;
}

// Adds the cubes of all ranks. Rank 0 has the result. Each rank sends its own once, and receives log2(ranks) times.
void add_up(Ranks& ranks, std::size_t most_cubes, Census& census) {
  std::optional<BoundedCubes> sum;
  const auto add = [&](unsigned level, const std::vector<Cube>& cubes) {
    sum->coarsen_to(level);
    for (const Cube& cube : cubes) sum->add(cube);
  };
  together(ranks, [&] {
    sum.emplace(most_cubes);
    add(census.level, census.cubes);
  });
  for (std::size_t step = 1; step < ranks.size(); step *= 2) {
    const std::size_t rank = ranks.rank();
    const bool sends = rank % (2 * step) == step, receives = rank % (2 * step) == 0 && rank + step < ranks.size();
    const std::vector<Cube> cubes = sends ? sum->sorted() : std::vector<Cube>();
    const std::vector<std::uint64_t> counts = share(ranks, cubes.size()), levels = share(ranks, sum->level());
    if (sends) ranks.send_receive(rank - step, bytes_of(std::span<const Cube>(cubes)), Ranks::nobody, {});
    std::vector<Cube> received(receives ? static_cast<std::size_t>(counts[rank + step]) : 0);
    if (receives) ranks.send_receive(Ranks::nobody, {}, rank + step, bytes_of(received));
    together(ranks, [&] {
      if (receives) add(static_cast<unsigned>(levels[rank + step]), received);
    });
  }
  census.level = sum->level();
  census.cubes = sum->sorted();
}

}  // namespace

RanksCensus take_census(Ranks& ranks, BlockSource& source, const CensusOptions& options, const Progress& progress) {
  RanksCensus result;
  result.range = range_of(ranks, source.count().value_or(0), BlockSource::piece);
  Census& all = result.all;
  together(ranks, [&] {
    CensusOptions own = options;
    own.begin = result.range.begin;
    own.end = result.range.end;
    WorkFolder nowhere({}, "", false);
    common::Checkpoints checkpoints(nowhere, result.range.end - result.range.begin);
    const auto advance = [&](std::uint64_t done) {
      if (progress && done > 0) progress(static_cast<double>(done) / static_cast<double>(own.end - own.begin));
    };
    all = take_census(source, own, advance, checkpoints);
  });
  result.own = all.cubes;
  all.points = sum(ranks, all.points);
  all.left_out = sum(ranks, all.left_out);
  for (std::size_t k = 0; k < 3; ++k) {
    all.low[k] = least(ranks, all.low[k]);
    all.high[k] = greatest(ranks, all.high[k]);
  }
  add_up(ranks, options.most_cubes, all);
  std::vector<std::uint64_t> level{all.level};
  broadcast_values(ranks, level);
  broadcast_values(ranks, all.cubes);
  all.level = static_cast<unsigned>(level[0]);
  result.own = at_level(result.own, all.level);
  return result;
}

std::vector<std::uint32_t> deal_cells(const std::vector<Cell>& cells, std::size_t ranks) {
  std::vector<std::uint32_t> order(cells.size()), owners(cells.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return cells[a].first < cells[b].first; });
  double all = 0, before = 0;
  for (const Cell& cell : cells) all += static_cast<double>(cell.count);
  for (const std::uint32_t cell : order) {
    const auto count = static_cast<double>(cells[cell].count);
    const double place = (before + count / 2) / all * static_cast<double>(ranks);
    owners[cell] = static_cast<std::uint32_t>(std::min(static_cast<std::size_t>(place), ranks - 1));
    before += count;
  }
  return owners;
}

std::vector<std::uint64_t> counts_of(const std::vector<Cell>& cells, const std::vector<Cube>& cubes) {
  std::vector<std::uint64_t> counts(cells.size());
  for (const Cube& cube : cubes) counts[cell_of(cells, cube.key)] += cube.count;
  return counts;
}

}  // namespace glark::stream
