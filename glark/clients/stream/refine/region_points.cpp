// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/refine/region_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "glark/clients/stream/sample/grid/block_source.h"

namespace glark::stream {
namespace {

using common::Vector3f;

constexpr std::uint64_t batch = 1 << 20;  // points
constexpr float same_place = 1e-6F;       // the square of a distance, relative to that of the second sample
constexpr std::size_t around = 5;         // the nearest samples tell how far the points of a sample may lie

struct Range {
  std::uint64_t first = 0, end = 0;
};

// The cells around the samples of the region.
std::vector<std::size_t> cells_around(const CellIndex& index, const Sampling& sampling,
                                      const std::vector<bool>& is_inside) {
  std::vector<bool> is_needed(index.cells.size());
  const auto need = [&](const Vector3f& sample, double reach) {
    for (std::size_t c = 0; c < index.cells.size(); ++c) {
      const SampledCell& cell = index.cells[c];
      bool meets = !is_needed[c];
      for (std::size_t k = 0; k < 3 && meets; ++k) {
        const double at = sampling.origin[k] + static_cast<double>(sample[k]);
        meets = at + reach >= cell.corner[k] && at - reach <= cell.corner[k] + cell.side;
      }
      if (meets) is_needed[c] = true;
    }
  };
  FoundSamples near;
  sampling.store->each([&](std::span<const std::uint32_t> indices, const Samples& samples) {
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (!is_inside[indices[i]]) continue;
      sampling.store->nearest(samples.before[i], around, near);
      need(samples.before[i], std::sqrt(static_cast<double>(near.nearest.back().square)));
    }
  });
  std::vector<std::size_t> cells;
  for (std::size_t c = 0; c < is_needed.size(); ++c)
    if (is_needed[c]) cells.push_back(c);
  return cells;
}

// The ranges of the stream that have the points of the cells. They do not overlap.
std::vector<Range> ranges_of(const CellIndex& index, const std::vector<std::size_t>& cells) {
  std::vector<Range> ranges;
  for (const std::size_t c : cells) ranges.push_back({index.cells[c].first, index.cells[c].last + 1});
  std::sort(ranges.begin(), ranges.end(), [](const Range& a, const Range& b) { return a.first < b.first; });
  std::vector<Range> merged;
  for (const Range& range : ranges)
    if (merged.empty() || range.first > merged.back().end)
      merged.push_back(range);
    else
      merged.back().end = std::max(merged.back().end, range.end);
  return merged;
}

bool is_in(const SampledCell& cell, const double* position) {
  bool inside = true;
  for (std::size_t k = 0; k < 3; ++k)
    inside &= position[k] >= cell.corner[k] && position[k] <= cell.corner[k] + cell.side;
  return inside;
}

// A cube around all cells.
SampledCell box_of(const std::vector<SampledCell>& cells) {
  SampledCell box = cells.front();
  for (const SampledCell& cell : cells)
    for (std::size_t k = 0; k < 3; ++k) box.corner[k] = std::min(box.corner[k], cell.corner[k]);
  for (const SampledCell& cell : cells)
    for (std::size_t k = 0; k < 3; ++k) box.side = std::max(box.side, cell.corner[k] + cell.side - box.corner[k]);
  return box;
}

// Keeps the points of a piece of the stream, so that the order does not depend on threads.
struct Piece {
  std::uint64_t first = 0;
  RegionPoints kept;
};

class RegionReader {
 public:
  RegionReader(const Sampling& sampling, const std::vector<bool>& is_inside, std::vector<SampledCell> cells,
               std::size_t memory)
      : sampling_(sampling), is_inside_(is_inside), cells_(std::move(cells)), box_(box_of(cells_)), memory_(memory) {}

  RegionPoints run(BlockSource& source, const std::vector<Range>& ranges) {
    RegionPoints all;
    all.schema = source.schema();
    for (const Range& range : ranges)
      for (std::uint64_t begin = range.first; begin < range.end; begin += batch) {
        pieces_.clear();
        all.points_read += source.each(begin, std::min(range.end, begin + batch),
                                       [&](const Points& points) { keep(points, all.schema.channels.size()); });
        std::sort(pieces_.begin(), pieces_.end(), [](const Piece& a, const Piece& b) { return a.first < b.first; });
        for (const Piece& piece : pieces_) append(piece.kept, all, source.name());
      }
    return all;
  }

 private:
  void keep(const Points& points, std::size_t channels) {
    Piece piece{points.first, {}};
    const SampledCell* cell = cells_.data();
    FoundSamples near;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double* position = &points.positions[3 * i];
      if (!is_in(box_, position)) continue;
      if (!is_in(*cell, position)) {  // most points are in the cell of the point before
        const auto found = std::find_if(cells_.begin(), cells_.end(),
                                        [&](const SampledCell& other) { return is_in(other, position); });
        if (found == cells_.end()) continue;
        cell = &*found;
      }
      Vector3f p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = static_cast<float>(position[k] - sampling_.origin[k]);
      sampling_.store->nearest(p, 2, near);
      if (!is_inside_[near.nearest[0].index]) continue;
      if (near.nearest[0].square <= same_place * near.nearest.back().square) {
        ++piece.kept.samples;
        continue;
      }
      const auto add = [](auto& to, const auto& from, std::size_t begin, std::size_t size) {
        to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(begin),
                  from.begin() + static_cast<std::ptrdiff_t>(begin + size));
      };
      add(piece.kept.positions, points.positions, 3 * i, 3);
      if (!points.normals.empty()) add(piece.kept.normals, points.normals, 3 * i, 3);
      add(piece.kept.channels, points.channels, channels * i, channels);
    }
    const std::lock_guard lock(mutex_);
    pieces_.push_back(std::move(piece));
  }

  void append(const RegionPoints& piece, RegionPoints& all, const std::string& file) const {
    all.positions.insert(all.positions.end(), piece.positions.begin(), piece.positions.end());
    all.normals.insert(all.normals.end(), piece.normals.begin(), piece.normals.end());
    all.channels.insert(all.channels.end(), piece.channels.begin(), piece.channels.end());
    all.samples += piece.samples;
    const std::size_t bytes =
        sizeof(double) * (all.positions.size() + all.channels.size()) + sizeof(float) * all.normals.size();
    if (2 * bytes > memory_)
      throw Error(Element::file, 0,
                  fmt::format("{}: the points of the region take more than half of the memory, {} bytes; choose a "
                              "smaller region, or a larger number for the option memory",
                              file, memory_));
  }

  const Sampling& sampling_;
  const std::vector<bool>& is_inside_;
  std::vector<SampledCell> cells_;
  SampledCell box_;
  std::size_t memory_;
  std::mutex mutex_;
  std::vector<Piece> pieces_;
};

// channel: the one of the region, if it is one.
bool is_in(const Region& region, const Sampling& sampling, std::size_t channel, const Samples& samples, std::size_t i) {
  if (region.kind == Region::Kind::channel) return samples.values[sampling.channels.size() * i + channel] != 0;
  double square = 0;
  bool in_box = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const double at = sampling.origin[k] + static_cast<double>(samples.after[i][k]);
    square += (at - region.centre[k]) * (at - region.centre[k]);
    in_box &= at >= region.low[k] && at <= region.high[k];
  }
  return region.kind == Region::Kind::box ? in_box : square <= region.radius * region.radius;
}

}  // namespace

std::vector<bool> samples_in(const Region& region, const Sampling& sampling, const std::string& file) {
  std::size_t channel = none;
  for (std::size_t k = 0; k < sampling.channels.size(); ++k)
    if (sampling.channels[k].name == region.channel) channel = k;
  if (region.kind == Region::Kind::channel && channel == none)
    throw Error(
        Element::option, 0,
        fmt::format("{}: its points have no new property \"{}\"; export the selection as one", file, region.channel));
  std::vector<bool> is_inside(sampling.store->size());
  sampling.store->each([&](std::span<const std::uint32_t> indices, const Samples& samples) {
    for (std::size_t i = 0; i < indices.size(); ++i)
      is_inside[indices[i]] = is_in(region, sampling, channel, samples, i);
  });
  if (std::find(is_inside.begin(), is_inside.end(), true) == is_inside.end())
    throw Error(Element::option, 0,
                file + ": no sample lies in the region; choose one within the bounding box of the sampling");
  return is_inside;
}

RegionPoints read_region(const std::filesystem::path& large, const CellIndex& index, const Sampling& sampling,
                         const std::vector<bool>& is_inside, std::size_t memory, const common::Workers& workers) {
  const std::vector<std::size_t> needed = cells_around(index, sampling, is_inside);
  std::vector<SampledCell> cells;
  for (const std::size_t c : needed) cells.push_back(index.cells[c]);
  if (cells.empty())
    throw Error(Element::file, 0,
                large.string() + ": no cell of its index has the region; the index may be that of another sampling");
  ReadOptions reading;
  reading.keep_invalid = true;
  const Source source = file_source(large);
  BlockSource points(source, reading, workers);
  if (points.count() && *points.count() != index.points)
    throw Error(Element::file, 0,
                fmt::format("{}: has {} points, its index was made for {}; sample the scan again", large.string(),
                            *points.count(), index.points));
  return RegionReader(sampling, is_inside, std::move(cells), memory).run(points, ranges_of(index, needed));
}

}  // namespace glark::stream
