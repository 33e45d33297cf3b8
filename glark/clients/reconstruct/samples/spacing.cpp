// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/samples/spacing.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "glark/clients/common/points/moments.h"
#include "glark/clients/common/points/point_set.h"

namespace glark::reconstruct {
namespace {

constexpr std::size_t most_looked_at = 1 << 14;  // the most samples in a cell, and the most cells, that are measured

// Keeps the samples of the side that faces most of them. The two sides of a thin sheet are no noise. Keeps none if their
// normals differ so much that there is no surface: outliers say nothing about its noise.
void keep_one_side(std::vector<Record>& records) {
  constexpr float common = 0.7F;  // the length of the mean normal; random normals of one side have 0.5
  Float4 normal{};
  for (const Record& record : records) normal += record.normal;
  if (!(dot(normal, normal) > 0)) normal = records.front().normal;
  std::erase_if(records, [&](const Record& record) { return dot(record.normal, normal) < 0; });
  Float4 mean{};
  for (const Record& record : records) mean += record.normal / static_cast<float>(records.size());
  if (dot(mean, mean) < common * common) records.clear();
}

// The height of a sample over a plane, less the part that the curvature of the surface explains. On a quadratic surface,
// half the slope of the normals gives the height over the plane.
float flat_height(const Record& record, Float4 centroid, Float4 normal) {
  return dot(record.point() - centroid, normal + record.normal) / 2;
}

struct Layers {
  std::ptrdiff_t begin = 0, end = 0;              // of the largest
  float gap = std::numeric_limits<float>::max();  // the least distance of two
};

// Layers are the runs of sorted heights without a gap that is wide beside the spacing of their samples. `square` is the
// mean squared distance of the samples from the axis.
Layers largest_layer(const std::vector<float>& heights, double square) {
  constexpr float far = 1.5F;  // the least distance of two layers, relative to the distance of samples
  Layers layers;
  const auto count = static_cast<std::ptrdiff_t>(heights.size());
  const auto step = [&](std::ptrdiff_t i) {
    return heights[static_cast<std::size_t>(i)] - heights[static_cast<std::size_t>(i - 1)];
  };
  for (std::ptrdiff_t begin = 0, i = 1; i <= count; ++i) {
    // A square of the side a has the mean square a^2 / 6.
    const auto spacing = static_cast<float>(std::sqrt(6 * square / static_cast<double>(i - begin)));
    if (i != count && step(i) < far * spacing) continue;
    if (i - begin > layers.end - layers.begin) {
      layers.begin = begin;
      layers.end = i;
    }
    if (i != count) layers.gap = std::min(layers.gap, step(i));
    begin = i;
  }
  return layers;
}

// The standard deviation of the heights of a layer.
float thickness(std::span<const float> heights) {
  float sum = 0, squares = 0;
  for (const float height : heights) {
    sum += height;
    squares += height * height;
  }
  const auto count = static_cast<float>(heights.size());
  return std::sqrt(std::max(0.0F, squares - sum * sum / count) / count);
}

// Keeps the largest of several layers that face the same way. Layers are no noise: they are farther apart than their
// samples are from each other, and than these are from their layer. Returns whether there are several.
bool keep_one_layer(std::vector<Record>& records) {
  constexpr float farther = 3;  // the least distance of two layers, relative to the heights of a layer's samples
  constexpr std::ptrdiff_t fewest = 4;  // samples of another layer
  Float4 normal{}, centroid{};
  for (const Record& record : records) {
    normal += record.normal;
    centroid += record.point() / static_cast<float>(records.size());
  }
  normal = unit(normal);
  std::vector<float> heights;
  const auto height = [&](const Record& record) { return flat_height(record, centroid, normal); };
  std::ranges::sort(records, {}, height);
  double square = 0;  // the mean squared distance from the axis
  for (const Record& record : records) {
    heights.push_back(height(record));
    const Float4 way = record.point() - centroid;
    const float along = dot(way, normal);
    square += static_cast<double>(dot(way, way) - along * along) / static_cast<double>(records.size());
  }
  const Layers layers = largest_layer(heights, square);
  const auto size = static_cast<std::size_t>(layers.end - layers.begin);
  if (layers.end - layers.begin + fewest > static_cast<std::ptrdiff_t>(heights.size())) return false;
  if (layers.gap < farther * thickness(std::span(heights).subspan(static_cast<std::size_t>(layers.begin), size)))
    return false;
  records.erase(records.begin() + layers.end, records.end());
  records.erase(records.begin(), records.begin() + layers.begin);
  return true;
}

// Returns the mean squared height of the samples over their mean plane, less the part that the curvature of the surface
// explains.
float roughness(const std::vector<Record>& records) {
  const Moments moments = Moments::of(records);
  const Float4 normal = without_fourth(moments.normal()), centroid = without_fourth(moments.mean);
  float sum = 0;
  float squares = 0;
  for (const Record& record : records) {
    const float height = flat_height(record, centroid, normal);
    sum += height;
    squares += height * height;
  }
  const auto count = static_cast<float>(records.size());
  return std::max(0.0F, squares - sum * sum / count) / (count - 3);
}

}  // namespace

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

double side_for(const Occupancy& occupancy, double aim) {
  unsigned level = 0;
  while (level + 1 < cell_levels && occupancy.samples_a_cell(level + 1) > aim) ++level;
  const double more = std::log2(occupancy.samples_a_cell(level) / aim);
  const double step = std::log2(occupancy.samples_a_cell(level) / occupancy.samples_a_cell(level + 1));
  const double part = step > 0 ? std::clamp(more / step, 0.0, 1.0) : 0;
  return std::exp2(-(level + part));
}

unsigned level_for_noise(const Occupancy& occupancy) {
  return std::min(static_cast<unsigned>(-std::log2(side_for(occupancy, 2 * least_samples))), cell_levels);
}

namespace {

// Calls body(records) for cells of the level that have at least `least_samples`, with those of one side.
template <typename Body>
void each_side(const PointSet& points, const Cube& cube, const std::vector<Entry>& entries, unsigned level,
               const Body& body) {
  const unsigned shift = 3 * (cell_levels - level);
  const std::size_t stride = std::max<std::size_t>(1, entries.size() / most_looked_at);
  std::vector<Record> records;
  for (std::size_t at = 0; at < entries.size();) {
    std::size_t end = at;
    records.clear();
    for (; end < entries.size() && entries[end].key >> shift == entries[at].key >> shift; ++end) {
      if (records.size() >= most_looked_at) continue;
      const std::size_t index = 3 * std::size_t{entries[end].index};
      records.push_back({cube.inside(&points.positions[index]), unit_normal(&points.normals[index])});
    }
    if (records.size() >= least_samples) keep_one_side(records);
    if (records.size() >= least_samples) body(records);
    at = std::max(end, std::min(at + least_samples * stride, entries.size()));
    while (at > end && at < entries.size() && entries[at].key >> shift == entries[at - 1].key >> shift) ++at;
  }
}

}  // namespace

double noise_of(const PointSet& points, const Cube& cube, const std::vector<Entry>& entries, unsigned level) {
  std::vector<float> errors;
  each_side(points, cube, entries, level, [&](std::vector<Record>& records) {
    keep_one_layer(records);
    if (records.size() >= least_samples) errors.push_back(roughness(records));
  });
  if (errors.empty()) return 0;
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  return std::sqrt(static_cast<double>(*middle));
}

double share_of_layers(const PointSet& points, const Cube& cube, const std::vector<Entry>& entries, unsigned level) {
  double cells = 0, layered = 0;
  each_side(points, cube, entries, level, [&](std::vector<Record>& records) {
    ++cells;
    layered += keep_one_layer(records) ? 1 : 0;
  });
  return cells > 0 ? layered / cells : 0;
}

}  // namespace glark::reconstruct
