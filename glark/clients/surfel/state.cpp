// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/state.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "glark/clients/surfel/level/slot_array.h"
#include "glark/clients/surfel/level_builder.h"
#include "glark/clients/surfel/update/local_update.h"

namespace glark::surfel {
namespace {

float greatest_magnitude(std::span<const float> values) {
  float greatest = 0;
  for (const float value : values) greatest = std::max(greatest, std::fabs(value));
  return greatest;
}

// Returns a power of two that scales coordinates below 1. Then products of coordinates neither overflow nor underflow.
float unit_for(float greatest) {
  int exponent = 0;
  if (greatest > 0) std::frexp(greatest, &exponent);
  return std::ldexp(1.0F, std::clamp(exponent, -120, 120));
}

// The coordinates of the surfel are in units of `unit_length`.
Surfel make_surfel(const Cloud& cloud, std::size_t point, float unit_length) {
  const auto triple = [&](std::span<const float> values) {
    return Vector{values[3 * point], values[3 * point + 1], values[3 * point + 2]};
  };
  return {triple(cloud.positions) * (1 / unit_length), static_cast<std::uint32_t>(point),
          cloud.normals.empty() ? Vector{} : unit(triple(cloud.normals)), 0};
}

// Sorts the ranges, joins ranges that touch, and removes empty ones.
std::vector<Range> joined(std::vector<Range> ranges) {
  std::erase_if(ranges, [](const Range& range) { return range.count == 0; });
  std::sort(ranges.begin(), ranges.end(), [](const Range& a, const Range& b) { return a.first < b.first; });
  std::vector<Range> all;
  for (const Range& range : ranges) {
    if (!all.empty() && all.back().first + all.back().count >= range.first) {
      all.back().count = std::max(all.back().count, range.first + range.count - all.back().first);
    } else {
      all.push_back(range);
    }
  }
  return all;
}

}  // namespace

Strips::State::State(const Cloud& cloud, const Options& chosen)
    : options(chosen), level_options{}, workers(chosen.threads) {
  level_options = {
      .tree = {chosen.leaf_points, {chosen.delta_a, chosen.delta_d}, chosen.inflation},
      .reach = chosen.reach,
      .unit = unit_for(greatest_magnitude(cloud.positions)),
      .has_normals = !cloud.normals.empty(),
      .flip_edges = chosen.turn_edges,
  };
  std::vector<Surfel> surfels(cloud.positions.size() / 3);
  constexpr std::size_t grain = 16384;
  workers.in_pieces(surfels.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) surfels[i] = make_surfel(cloud, i, level_options.unit);
  });
  points = surfels.size();
  build(std::move(surfels));
}

void Strips::State::build(std::vector<Surfel> surfels) {
  levels.clear();
  indices.clear();
  levels.push_back(build_level(std::move(surfels), {}, level_options, workers, indices));
  for (unsigned level = 1; level < options.levels; ++level) {
    std::vector<std::uint32_t> cloud_indices;
    std::vector<Surfel> coarser = coarser_surfels(levels.back(), cloud_indices);
    levels.push_back(build_level(std::move(coarser), std::move(cloud_indices), level_options, workers, indices));
  }
}

std::vector<Range> Strips::State::update(const Cloud& cloud, std::span<const std::uint32_t> moved) {
  std::vector<Surfel> surfels;
  float farthest = 0;
  for (const std::uint32_t point : moved) {
    surfels.push_back(make_surfel(cloud, point, level_options.unit));
    const auto [x, y, z] = surfels.back().position;
    farthest = std::max({farthest, std::fabs(x), std::fabs(y), std::fabs(z)});
  }
  constexpr float most_units = 1024;  // a farther point needs a larger unit
  if (farthest > most_units || points == 0) {
    *this = State(cloud, options);
    return joined({{0, indices.size()}});
  }
  points = cloud.positions.size() / 3;
  std::vector<Range> changed;
  for (Level& level : levels) update_level_of(level, surfels, changed);
  if (compact_indices()) return joined({{0, indices.size()}});
  return joined(std::move(changed));
}

// moved: the indices in the cloud.
void Strips::State::update_level_of(Level& level, std::span<const Surfel> moved, std::vector<Range>& changed) {
  std::vector<Surfel> of_level;
  for (Surfel surfel : moved) {
    if (!level.cloud_indices.empty()) {
      const auto found = std::lower_bound(level.cloud_indices.begin(), level.cloud_indices.end(), surfel.index);
      if (found == level.cloud_indices.end() || *found != surfel.index) continue;
      surfel.index = static_cast<std::uint32_t>(found - level.cloud_indices.begin());
    }
    of_level.push_back(surfel);
  }
  if (of_level.empty()) return;
  update_level(level, of_level, level_options, workers, indices, changed);
  if (needs_rebuild(level, level_options)) {
    const std::size_t before = indices.size();
    rebuild_level(level, level_options, workers, indices);
    changed.push_back({before, indices.size() - before});
  }
  compact_level(level);
}

// Closes the gaps between strips if more than half of the indices are unused. Returns whether indices moved.
bool Strips::State::compact_indices() {
  const bool moved = compact_slots(indices, [&](const auto& body) {
    for (Level& level : levels) {
      for (Patch& patch : level.patches) body(patch.strip);
    }
  });
  if (!moved) return false;
  for (Level& level : levels) {
    for (std::size_t node = 0; node < level.nodes.size(); ++node) {
      const std::uint32_t leaf = level.tree.nodes[node].leaf;
      if (leaf != none) level.nodes[node].first = level.patches[leaf].strip.first;
    }
  }
  return true;
}

}  // namespace glark::surfel
