// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/samples/octree.h"

#include <algorithm>
#include <cmath>

#include "glark/clients/common/counting_sort.h"
#include "glark/clients/common/points/point_set.h"
#include "glark/clients/reconstruct/samples/near_samples.h"
#include "glark/clients/reconstruct/samples/spacing.h"

namespace glark::reconstruct {
namespace {

constexpr unsigned key_bits = 3 * cell_levels;
constexpr unsigned digit_bits = 12;
constexpr std::size_t grain = 1 << 15;
constexpr unsigned coarser_levels = 2;
constexpr double sides_to_noise = 10;  // the least side of the finest cells, relative to the noise

bool has_normal(const float* normal) { return normal[0] != 0 || normal[1] != 0 || normal[2] != 0; }

// Sorts by radix, the last digit first.
std::vector<Entry> sorted_entries(const PointSet& points, const Cube& cube, const Workers& workers) {
  std::vector<std::uint32_t> used;
  for (std::size_t i = 0; i < points.positions.size() / 3; ++i) {
    if (has_normal(&points.normals[3 * i])) used.push_back(static_cast<std::uint32_t>(i));
  }
  std::vector<Entry> entries(used.size()), other(used.size());
  workers.each(used.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      entries[i] = {key_of(cell_of(cube.inside(&points.positions[3 * std::size_t{used[i]}]), cell_levels)), used[i]};
  });
  for (unsigned shift = 0; shift < key_bits; shift += digit_bits) {
    sort_by_key(
        entries.size(), std::size_t{1} << digit_bits,
        [&](std::size_t begin, std::size_t end, std::uint32_t* keys) {
          for (std::size_t i = begin; i < end; ++i)
            *keys++ = static_cast<std::uint32_t>(entries[i].key >> shift) & ((1U << digit_bits) - 1);
        },
        [&](std::size_t begin, std::size_t end, const std::uint32_t* slots) {
          for (std::size_t i = begin; i < end; ++i) other[*slots++] = entries[i];
        },
        workers);
    entries.swap(other);
  }
  return entries;
}

// Returns a cube around the box with room for a few more cells. Sets `level` to the level whose cells have the given
// side.
Cube cube_with(const Cube& tight, double side, unsigned& level) {
  Cube cube = tight;
  level = 3;
  while (level < cell_levels && side * static_cast<double>(1U << level) < 1 + 4 * side) ++level;
  const double scale = std::max(1.0, side * static_cast<double>(1U << level));
  const auto extra = static_cast<float>((scale - 1) / 2) * tight.side;
  cube.low = tight.low - Float4{extra, extra, extra, 0};
  cube.side = static_cast<float>(scale) * tight.side;
  cube.scale = 1 / cube.side;
  cube.diagonal = tight.diagonal * tight.side / cube.side;
  return cube;
}

Level level_of(std::vector<std::uint64_t> keys, std::vector<std::uint32_t> begins, unsigned level) {
  Level result;
  result.level = level;
  result.keys = std::move(keys);
  result.begins = std::move(begins);
  result.blocks = CellBlocks(result.keys, result.begins);
  return result;
}

std::vector<Record> records_of(const PointSet& points, const Cube& cube, const std::vector<Entry>& entries,
                               const Workers& workers) {
  std::vector<Record> records(entries.size());
  workers.each(entries.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t index = entries[i].index;
      records[i].position = cube.inside(&points.positions[3 * index]);
      if (!points.colours.empty()) records[i].position[3] = pack_colour(&points.colours[3 * index]);
      records[i].normal = unit_normal(&points.normals[3 * index]);
    }
  });
  return records;
}

}  // namespace

CellIndex cell_of(Float4 point, unsigned level) {
  const Float4 scaled = point * static_cast<float>(1U << level);
  const auto last = static_cast<std::int32_t>(1U << level) - 1;
  const auto of = [&](float x) { return std::clamp(static_cast<std::int32_t>(x), 0, last); };
  return {of(scaled[0]), of(scaled[1]), of(scaled[2])};
}

SortedSamples sort_by_cells(const PointSet& points, const Workers& workers) {
  SortedSamples result;
  result.cube = bounding_cube(points.positions, workers);
  result.entries = sorted_entries(points, result.cube, workers);
  return result;
}

Level finest_level(const std::vector<Entry>& entries, unsigned level) {
  const unsigned shift = 3 * (cell_levels - level);
  std::vector<std::uint64_t> keys;
  std::vector<std::uint32_t> begins;
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    const std::uint64_t key = entries[i].key >> shift;
    if (!keys.empty() && keys.back() == key) continue;
    keys.push_back(key);
    begins.push_back(i);
  }
  begins.push_back(static_cast<std::uint32_t>(entries.size()));
  return level_of(std::move(keys), std::move(begins), level);
}

Level coarser(const Level& fine) {
  std::vector<std::uint64_t> keys;
  std::vector<std::uint32_t> begins;
  for (std::size_t i = 0; i < fine.keys.size(); ++i) {
    if (!keys.empty() && keys.back() == fine.keys[i] >> 3) continue;
    keys.push_back(fine.keys[i] >> 3);
    begins.push_back(fine.begins[i]);
  }
  begins.push_back(fine.begins.back());
  return level_of(std::move(keys), std::move(begins), fine.level - 1);
}

Octree octree_of(const PointSet& points, SortedSamples sorted, const ReconstructOptions& options,
                 const Workers& workers) {
  Octree octree;
  const Cube tight = sorted.cube;
  std::vector<Entry> entries = std::move(sorted.entries);
  if (entries.empty()) return octree;
  const Occupancy occupancy = occupancy_of(entries);
  double side = side_for(occupancy, static_cast<double>(options.node_samples));
  const double noise = std::max(noise_of(points, tight, entries, level_for_noise(occupancy)),
                                static_cast<double>(options.threshold * tight.diagonal));
  side = std::max(side, sides_to_noise * noise);
  unsigned level = 0;
  octree.cube = cube_with(tight, side, level);
  octree.noise = static_cast<float>(noise) * tight.side / octree.cube.side;
  entries = {};
  entries = sorted_entries(points, octree.cube, workers);
  octree.levels.push_back(finest_level(entries, level));
  for (unsigned i = 0; i < coarser_levels && octree.levels.back().level > 0; ++i)
    octree.levels.push_back(coarser(octree.levels.back()));
  octree.has_colours = !points.colours.empty();
  octree.records = records_of(points, octree.cube, entries, workers);
  return octree;
}

}  // namespace glark::reconstruct
