// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/samples/cells/samples_in_cells.h"

#include <algorithm>
#include <utility>

#include "glark/clients/stream/files/trim_memory.h"

namespace glark::stream {

using common::Vector3f;

SamplesInCells::SamplesInCells(std::unique_ptr<SampleCells> file, const CellPlan& plan)
    : file_(std::move(file)), cache_(*file_, plan), tree_(file_->boxes()) {
  for (std::size_t cell = 0; cell < file_->cells(); ++cell) size_ += file_->size_of(cell);
}

// Most places lie near the one before, so its cell comes first: then few others may have nearer samples.
void SamplesInCells::nearest(const Vector3f& point, std::size_t count, FoundSamples& found) const {
  const Vector3f place = within_floats(point);
  NearestSet<CellSample> set(found.in_cells, std::min(count, size_));
  const std::uint32_t first = found.last_cell;
  const auto search = [&](std::uint32_t number) {
    const std::shared_ptr<const LoadedCell> cell = cache_.get(number);
    cell->tree->add_nearest(place, {number, cell->indices}, set);
  };
  search(first);
  tree_.each_near(
      place, [&] { return set.worst(); },
      [&](std::uint32_t number) {
        if (number != first) search(number);
      });
  found.last_cell = found.in_cells.front().cell;
  found.nearest.clear();
  for (const CellSample& sample : found.in_cells) found.nearest.push_back({sample.square, sample.index});
}

void SamplesInCells::gather(const Vector3f& point, std::size_t count, FoundSamples& found) const {
  nearest(point, count, found);
  const std::vector<CellSample>& all = found.in_cells;
  found.samples.resize(all.size(), file_->channels());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto is_same = [&](const CellSample& other) { return other.cell == all[i].cell; };
    if (std::any_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(i), is_same)) continue;
    const std::shared_ptr<const LoadedCell> cell = cache_.get(all[i].cell);
    for (std::size_t k = i; k < all.size(); ++k)
      if (is_same(all[k])) found.samples.copy(cell->samples, all[k].place, k, file_->channels());
  }
}

void SamplesInCells::each(const TakeSamples& take) const {
  for (std::uint32_t number = 0; number < file_->cells(); ++number) {
    const std::shared_ptr<const LoadedCell> cell = cache_.get(number);
    take(cell->indices, cell->samples);
  }
}

void SamplesInCells::set_turned_normals(const common::Workers& workers, const Turned& turned) {
  workers.in_pieces(file_->cells(), 1, [&](std::size_t number, std::size_t) {
    FoundSamples found;
    found.last_cell = static_cast<std::uint32_t>(number);
    const std::shared_ptr<const LoadedCell> cell = cache_.get(found.last_cell);
    file_->write_turned_normals(number, turned(*cell, found));
  });
  cache_.clear();
  trim_memory(0);
}

}  // namespace glark::stream
