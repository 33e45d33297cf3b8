// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/density/even_samples.h"

#include <algorithm>
#include <cmath>

#include "glark/clients/reconstruct/density/all_outliers.h"

namespace glark::reconstruct {
namespace {

constexpr double filled_spacings = 1.3;
// Where dense parts are tiny, a filling like them would not end. Then all cells become coarser.
constexpr double most_filled = 8, least_room = 4e6;  // samples for each given one; samples

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

std::vector<std::uint32_t> EvenSamples::outliers() const {
  std::vector<std::uint32_t> sorted = outliers_;
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

void EvenSamples::remove_outliers(const Workers& workers) {
  const std::vector<std::uint32_t> outliers = outliers_among_all(points(), sorted_.cube, sorted_.entries, workers);
  if (outliers.empty()) return;
  change(outliers, {}, workers);
}

void EvenSamples::fill_sparse_parts(const Workers& workers) {
  const std::vector<Entry>& entries = sorted_.entries;
  const double side = side_for(occupancy_of(entries), samples_a_cell), spacing = spacing_share * side;
  std::vector<std::uint32_t> sparse = sparse_entries(entries, side);
  if (sparse.empty()) return;
  const PointSet points = this->points();
  const std::vector<std::uint32_t> outliers = outliers_among_sparse(sparse, points, sorted_.cube, entries, workers);
  if (2 * outliers.size() > entries.size()) return;
  std::vector<std::uint8_t> is_used(entries.size(), 1);
  for (const std::uint32_t i : outliers) is_used[i] = 0;
  std::erase_if(sparse, [&](std::uint32_t i) { return is_used[i] == 0; });
  const Neighbours neighbours(points, sorted_.cube, entries);
  auto filled_spacing = static_cast<float>(filled_spacings * spacing);
  const double most = std::max(least_room, most_filled * static_cast<double>(entries.size()));
  const double count = count_of_filling(sparse, neighbours, filled_spacing, workers);
  if (count > most) filled_spacing *= static_cast<float>(std::sqrt(count / most));
  const Filling filling = filling_around(sparse, neighbours, points, is_used, filled_spacing, workers);
  if (outliers.empty() && filling.points.empty()) return;
  change(outliers, filling, workers);
}

void EvenSamples::change(const std::vector<std::uint32_t>& removed, const Filling& added, const Workers& workers) {
  const PointSet before = points();
  std::vector<bool> is_removed(before.positions.size() / 3);
  for (const std::uint32_t i : removed) is_removed[sorted_.entries[i].index] = true;
  std::vector<std::uint32_t> given_as;
  std::vector<float> positions, normals;
  std::vector<std::uint8_t> colours;
  const auto append = [](auto& array, const auto& from, std::size_t i) {
    if (!from.empty()) array.insert(array.end(), &from[3 * i], &from[3 * i] + 3);
  };
  for (std::size_t i = 0; i < is_removed.size(); ++i) {
    const std::uint32_t given = given_as_.empty() ? static_cast<std::uint32_t>(i) : given_as_[i];
    (is_removed[i] ? outliers_ : given_as).push_back(given);
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
  given_as_ = std::move(given_as);
  sorted_ = sort_by_cells(points(), workers);
}

}  // namespace glark::reconstruct
