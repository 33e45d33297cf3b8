// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/octree.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "glark/clients/reconstruct/near_samples.h"
#include "glark/clients/vstree/cells.h"
#include "glark/clients/vstree/moments.h"
#include "glark/clients/vstree/samples.h"

namespace glark::vstree {
namespace {

constexpr unsigned key_bits = 3 * cell_levels;
constexpr unsigned digit_bits = 12;
constexpr std::size_t grain = 1 << 15;
constexpr unsigned coarser_levels = 2;
constexpr std::size_t several = 8;  // samples
constexpr std::size_t most_looked_at = 1 << 14;
constexpr double sides_to_noise = 10;  // the least side of the finest cells, by the noise

struct Entry {
  std::uint64_t key;
  std::uint32_t index;
};

bool has_normal(const float* normal) { return normal[0] != 0 || normal[1] != 0 || normal[2] != 0; }

// By radix, the last digit first.
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

// How many cells of each level have samples, and how many samples are at places of their own.
struct Occupancy {
  std::array<std::size_t, cell_levels + 1> cells{};
  double samples() const { return static_cast<double>(cells[cell_levels]); }
  double samples_a_cell(unsigned level) const { return samples() / static_cast<double>(cells[level]); }
};

Occupancy occupancy_of(const std::vector<Entry>& entries) {
  Occupancy result;
  result.cells.fill(1);
  for (std::size_t i = 1; i < entries.size(); ++i) {
    const std::uint64_t apart = entries[i].key ^ entries[i - 1].key;
    if (apart == 0) continue;
    const auto top = static_cast<unsigned>(63 - std::countl_zero(apart)) / 3;
    for (unsigned level = cell_levels - top; level <= cell_levels; ++level) ++result.cells[level];
  }
  return result;
}

// The side of cells with `aim` samples each, about, within the unit cube.
double side_for(const Occupancy& occupancy, double aim) {
  unsigned level = 0;
  while (level + 1 < cell_levels && occupancy.samples_a_cell(level + 1) > aim) ++level;
  const double more = std::log2(occupancy.samples_a_cell(level) / aim);
  const double step = std::log2(occupancy.samples_a_cell(level) / occupancy.samples_a_cell(level + 1));
  const double part = step > 0 ? std::clamp(more / step, 0.0, 1.0) : 0;
  return std::exp2(-(level + part));
}

// The mean square of what is left of the samples' heights over their mean plane when the curvature is taken away that their normals show:
// a curved surface of second order is as high over the plane as half the slope that the normals have says.
float roughness(const std::vector<Record>& records) {
  const Moments moments = Moments::of(records);
  const Float4 normal = without_fourth(moments.normal()), centroid = without_fourth(moments.mean);
  float sum = 0;
  float squares = 0;
  for (const Record& record : records) {
    const float height = dot(record.point() - centroid, normal + record.normal) / 2;
    sum += height;
    squares += height * height;
  }
  const auto count = static_cast<float>(records.size());
  return std::max(0.0F, squares - sum * sum / count) / (count - 3);
}

// How rough the samples are, within the unit cube: the median over cells with at least `several`.
double noise_of(const PointSet& points, const Cube& cube, const std::vector<Entry>& entries, unsigned level) {
  const unsigned shift = 3 * (cell_levels - level);
  const std::size_t stride = std::max<std::size_t>(1, entries.size() / most_looked_at);
  std::vector<float> errors;
  std::vector<Record> records;
  for (std::size_t at = 0; at < entries.size();) {
    std::size_t end = at;
    records.clear();
    for (; end < entries.size() && entries[end].key >> shift == entries[at].key >> shift; ++end) {
      if (records.size() >= most_looked_at) continue;
      const std::size_t index = 3 * std::size_t{entries[end].index};
      records.push_back({cube.inside(&points.positions[index]), unit_normal(&points.normals[index])});
    }
    if (records.size() >= several) errors.push_back(roughness(records));
    at = std::max(end, std::min(at + several * stride, entries.size()));
    while (at > end && at < entries.size() && entries[at].key >> shift == entries[at - 1].key >> shift) ++at;
  }
  if (errors.empty()) return 0;
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  return std::sqrt(static_cast<double>(*middle));
}

// The cube that the box lies in the middle of, with cells of the side on some level, and room for a few cells around.
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

Octree sort_samples(const PointSet& points, const ReconstructOptions& options, const Workers& workers) {
  Octree octree;
  const Cube tight = bounding_cube(points.positions, workers);
  std::vector<Entry> entries = sorted_entries(points, tight, workers);
  if (entries.empty()) return octree;
  const Occupancy occupancy = occupancy_of(entries);
  double side = side_for(occupancy, static_cast<double>(options.node_samples));
  const auto measured_at = static_cast<unsigned>(-std::log2(side_for(occupancy, 2 * several)));
  const double noise = std::max(noise_of(points, tight, entries, std::min(measured_at, cell_levels)),
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

}  // namespace glark::vstree
