// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/density/even_samples.h"

#include <algorithm>
#include <cmath>

#include "glark/clients/reconstruct/density/outliers.h"

namespace glark::reconstruct {
namespace {

constexpr double node_samples = 6;         // in the cells whose side is the unit of the numbers below
constexpr double spacing_share = 1.0 / 3;  // of the side; a plane fills about 1.5 cells for each square of a side
constexpr double sparse_spacings = 2;      // sparse samples are this much farther apart than the others
constexpr double filled_spacings = 1.3;
constexpr double sixth_neighbour = 1.38;     // its distance, in spacings
constexpr double least_around = 110;         // samples in a cube of three cells, of two sides each, that are not sparse
constexpr double least_unsupported = 0.003;  // a greater share without support means that there are outliers
constexpr std::size_t least_looked_at = 50;  // fewer samples tell nothing about their density
constexpr int most_rounds = 6;               // of measuring noise and finding outliers
constexpr float same_noise = 0.9F;           // a smaller share of the noise is another one

// Returns the entries in cells with few samples around.
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

std::vector<std::uint32_t> outliers_of(const Neighbours& neighbours, const Sampling& sampling, float noise,
                                       const Workers& workers) {
  constexpr auto factor = static_cast<float>(sparse_spacings * sparse_spacings);
  const float sparse = factor * sampling.sixth_square;
  return outliers_among(suspects_of(neighbours, sparse, noise, workers), neighbours, sparse, noise, workers);
}

// removed: in ascending order.
std::vector<Entry> without_entries(const std::vector<Entry>& entries, const std::vector<std::uint32_t>& removed) {
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

}  // namespace

EvenSamples::EvenSamples(const PointSet& given, const Workers& workers)
    : given_(given), sorted_(sort_by_cells(given, workers)) {
  if (sorted_.entries.size() < least_looked_at) return;
  remove_outliers(workers);
  fill_sparse_parts(workers);
}

PointSet EvenSamples::points() const {
  if (positions_.empty()) return given_;
  return {.positions = positions_, .normals = normals_, .colours = colours_};
}

// Removes the samples that lie on no surface. Tests a few samples first, and all of them only if some of the few lie on
// no surface. Outliers look like noise, and noise hides outliers. So the noise of what stays is measured again, until it
// is that which was assumed.
void EvenSamples::remove_outliers(const Workers& workers) {
  const std::vector<Entry>& entries = sorted_.entries;
  const PointSet points = this->points();
  const Neighbours neighbours(points, sorted_.cube, entries);
  const unsigned level = std::max(neighbours.finest().level, 1U) - 1;
  auto noise = static_cast<float>(noise_of(points, sorted_.cube, entries, level));
  std::vector<std::uint32_t> outliers;
  for (int round = 0; round < most_rounds; ++round) {
    const Sampling sampling = look_at_some(neighbours, noise, workers);
    if (round == 0 && sampling.unsupported < least_unsupported) return;
    outliers = outliers_of(neighbours, sampling, noise, workers);
    const auto without = static_cast<float>(noise_of(points, sorted_.cube, without_entries(entries, outliers), level));
    if (without > same_noise * noise) break;
    noise = without;
  }
  if (outliers.empty() || 2 * outliers.size() > entries.size()) return;  // no surface at all
  outliers_ = static_cast<std::uint32_t>(outliers.size());
  change(outliers, {}, workers);
}

void EvenSamples::fill_sparse_parts(const Workers& workers) {
  const std::vector<Entry>& entries = sorted_.entries;
  const Occupancy occupancy = occupancy_of(entries);
  const double side = side_for(occupancy, node_samples), spacing = spacing_share * side;
  std::vector<std::uint32_t> sparse = sparse_entries(entries, side);
  if (sparse.empty()) return;
  const PointSet points = this->points();
  const Neighbours neighbours(points, sorted_.cube, entries);
  const auto noise = static_cast<float>(noise_of(points, sorted_.cube, entries, level_for_noise(occupancy)));
  const auto sixth = static_cast<float>(std::pow(sixth_neighbour * sparse_spacings * spacing, 2));
  const std::vector<std::uint32_t> outliers = outliers_among(sparse, neighbours, sixth, noise, workers);
  if (2 * outliers.size() > entries.size()) return;
  std::vector<std::uint8_t> is_used(entries.size(), 1);
  for (const std::uint32_t i : outliers) is_used[i] = 0;
  std::erase_if(sparse, [&](std::uint32_t i) { return is_used[i] == 0; });
  const Filling filling =
      filling_around(sparse, neighbours, points, is_used, static_cast<float>(filled_spacings * spacing), workers);
  if (outliers.empty() && filling.points.empty()) return;
  outliers_ += static_cast<std::uint32_t>(outliers.size());
  change(outliers, filling, workers);
}

void EvenSamples::change(const std::vector<std::uint32_t>& removed, const Filling& added, const Workers& workers) {
  const PointSet before = points();
  std::vector<bool> is_removed(before.positions.size() / 3);
  for (const std::uint32_t i : removed) is_removed[sorted_.entries[i].index] = true;
  std::vector<float> positions, normals;
  std::vector<std::uint8_t> colours;
  const auto append = [](auto& array, const auto& from, std::size_t i) {
    if (!from.empty()) array.insert(array.end(), &from[3 * i], &from[3 * i] + 3);
  };
  for (std::size_t i = 0; i < is_removed.size(); ++i) {
    if (is_removed[i]) continue;
    append(positions, before.positions, i);
    append(normals, before.normals, i);
    append(colours, before.colours, i);
  }
  for (std::size_t i = 0; i < added.points.size(); ++i) {
    const Float4 point = sorted_.cube.low + added.points[i] * sorted_.cube.side;
    for (int k = 0; k < 3; ++k) {
      positions.push_back(point[k]);
      normals.push_back(added.normals[i][k]);
    }
    append(colours, added.colours, i);
  }
  positions_ = std::move(positions);
  normals_ = std::move(normals);
  colours_ = std::move(colours);
  sorted_ = sort_by_cells(points(), workers);
}

}  // namespace glark::reconstruct
