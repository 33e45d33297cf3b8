// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/density/all_outliers.h"

#include <algorithm>
#include <cmath>

#include "glark/clients/reconstruct/density/outliers.h"

namespace glark::reconstruct {
namespace {

constexpr double sparse_spacings = 2;        // sparse samples are this much farther apart than the others
constexpr double sixth_neighbour = 1.38;     // its distance, in spacings
constexpr double least_around = 110;         // samples in a cube of three cells, of two sides each, that are not sparse
constexpr double least_unsupported = 0.003;  // a greater share without support means that there are outliers
constexpr int most_rounds = 6;               // of measuring noise and finding outliers
constexpr float same_noise = 0.9F;           // a smaller share of the noise is another one

std::vector<std::uint32_t> outliers_of(const Neighbours& neighbours, const Sampling& sampling, float noise,
                                       const Workers& workers) {
  constexpr auto factor = static_cast<float>(sparse_spacings * sparse_spacings);
  const float sparse = factor * sampling.sixth_square;
  return outliers_among(suspects_of(neighbours, sparse, noise, workers), neighbours, sparse, support_share * sparse,
                        noise, workers);
}

}  // namespace

std::vector<std::uint32_t> sparse_entries(const std::vector<Entry>& entries, double side) {
  const auto level = static_cast<unsigned>(std::clamp(std::floor(-std::log2(2 * side)), 0.0, double{cell_levels}));
  const Level cells = finest_level(entries, level);
  const double ratio = static_cast<double>(cells.side()) / (2 * side);
  const auto limit = static_cast<std::uint32_t>(least_around * ratio * ratio);
  std::vector<std::uint32_t> result;
  for (std::size_t i = 0; i < cells.keys.size(); ++i) {
    std::uint32_t around = 0;
    cells.blocks.each(cells_around(cell_of_key(cells.keys[i]), level),
                      [&](std::uint32_t begin, std::uint32_t end) { around += end - begin; });
    if (around >= limit) continue;
    for (std::uint32_t k = cells.begins[i]; k < cells.begins[i + 1]; ++k) result.push_back(k);
  }
  return result;
}

std::vector<Entry> without_entries(const std::vector<Entry>& entries, std::span<const std::uint32_t> removed) {
  std::vector<Entry> rest;
  rest.reserve(entries.size() - removed.size());
  for (std::size_t i = 0, next = 0; i < entries.size(); ++i) {
    if (next < removed.size() && removed[next] == i) {
      ++next;
    } else {
      rest.push_back(entries[i]);
    }
  }
  return rest;
}

// Tests a few samples first, and all of them only if some of the few lie on no surface. Outliers look like noise, and
// noise hides outliers. So the noise of what stays is measured again, until it is that which was assumed.
std::vector<std::uint32_t> outliers_among_all(const PointSet& points, const Cube& cube,
                                              const std::vector<Entry>& entries, const Workers& workers) {
  const Neighbours neighbours(points, cube, entries);
  const unsigned level = std::max(neighbours.finest().level, 1U) - 1;
  auto noise = static_cast<float>(noise_of(points, cube, entries, level));
  std::vector<std::uint32_t> outliers;
  for (int round = 0; round < most_rounds; ++round) {
    const Sampling sampling = look_at_some(neighbours, noise, workers);
    if (round == 0 && sampling.unsupported < least_unsupported) return {};
    outliers = outliers_of(neighbours, sampling, noise, workers);
    const auto without = static_cast<float>(noise_of(points, cube, without_entries(entries, outliers), level));
    if (without > same_noise * noise) break;
    noise = without;
  }
  if (2 * outliers.size() > entries.size()) return {};  // no surface at all
  return outliers;
}

std::vector<std::uint32_t> outliers_among_sparse(std::span<const std::uint32_t> sparse, const PointSet& points,
                                                 const Cube& cube, const std::vector<Entry>& entries,
                                                 const Workers& workers) {
  const Occupancy occupancy = occupancy_of(entries);
  const double spacing = spacing_share * side_for(occupancy, samples_a_cell);
  const auto noise = static_cast<float>(noise_of(points, cube, entries, level_for_noise(occupancy)));
  const auto sixth = static_cast<float>(std::pow(sixth_neighbour * sparse_spacings * spacing, 2));
  return outliers_among(sparse, Neighbours(points, cube, entries), sixth, sixth, noise, workers);
}

std::vector<std::uint32_t> all_outliers(const PointSet& points, const Workers& workers) {
  SortedSamples sorted = sort_by_cells(points, workers);
  std::vector<Entry>& entries = sorted.entries;
  std::vector<std::uint32_t> result;
  if (entries.size() < least_looked_at) return result;
  const auto remove = [&](const std::vector<std::uint32_t>& outliers) {
    for (const std::uint32_t i : outliers) result.push_back(entries[i].index);
    entries = without_entries(entries, outliers);
  };
  remove(outliers_among_all(points, sorted.cube, entries, workers));
  const std::vector<std::uint32_t> sparse = sparse_entries(entries, side_for(occupancy_of(entries), samples_a_cell));
  if (!sparse.empty()) {
    const std::vector<std::uint32_t> outliers = outliers_among_sparse(sparse, points, sorted.cube, entries, workers);
    if (2 * outliers.size() <= entries.size()) remove(outliers);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace glark::reconstruct
