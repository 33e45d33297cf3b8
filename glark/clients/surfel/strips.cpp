// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Surfel stripping behind its public face.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "glark/clients/surfel/local_update.h"
#include "glark/clients/surfel/selection.h"
#include "glark/clients/surfel/state.h"

namespace glark::surfel {
namespace {

float greatest_of(std::span<const float> values) {
  float greatest = 0;
  for (const float value : values) greatest = std::max(greatest, std::fabs(value));
  return greatest;
}

// The mean distance of the points of a level, were they spread over a square like its box.
float spacing_of(const Node& root, std::size_t points) {
  std::array<float, 3> size{};
  for (std::size_t k = 0; k < 3; ++k) size[k] = std::max(0.0F, root.high[k] - root.low[k]);
  std::sort(size.begin(), size.end());
  return std::sqrt(size[2] * size[1] / static_cast<float>(std::max<std::size_t>(points, 1)));
}

// Sorted, those that touch as one, and none that is empty.
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
    : options(chosen), layer_options{}, workers(chosen.threads) {
  layer_options = {
      .tree = {chosen.leaf_points, chosen.delta_a, chosen.delta_d, chosen.inflation},
      .reach = chosen.reach,
      .unit = unit_of(greatest_of(cloud.positions)),
      .oriented = !cloud.normals.empty(),
      .turn_edges = chosen.turn_edges,
  };
  std::vector<Surfel> surfels(cloud.positions.size() / 3);
  constexpr std::size_t grain = 16384;
  workers.in_pieces(surfels.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) surfels[i] = surfel_of(cloud, i, layer_options.unit);
  });
  points = surfels.size();
  build(std::move(surfels));
}

void Strips::State::build(std::vector<Surfel> surfels) {
  layers.clear();
  indices.clear();
  layers.push_back(build_layer(std::move(surfels), {}, layer_options, workers, indices));
  for (unsigned level = 1; level < options.levels; ++level) {
    std::vector<std::uint32_t> names;
    std::vector<Surfel> kept = coarser(layers.back(), names);
    layers.push_back(build_layer(std::move(kept), std::move(names), layer_options, workers, indices));
  }
}

std::vector<Range> Strips::State::update(const Cloud& cloud, std::span<const std::uint32_t> moved) {
  std::vector<Surfel> surfels;
  float farthest = 0;
  for (const std::uint32_t point : moved) {
    surfels.push_back(surfel_of(cloud, point, layer_options.unit));
    const auto [x, y, z] = surfels.back().position;
    farthest = std::max({farthest, std::fabs(x), std::fabs(y), std::fabs(z)});
  }
  constexpr float most = 1024;  // units beyond which the unit no longer fits
  if (farthest > most || points == 0) {
    *this = State(cloud, options);
    return joined({{0, indices.size()}});
  }
  points = cloud.positions.size() / 3;
  std::vector<Range> changed;
  std::vector<Surfel> own;
  for (Layer& layer : layers) {
    own.clear();
    for (Surfel surfel : surfels) {
      if (!layer.names.empty()) {
        const auto name = std::lower_bound(layer.names.begin(), layer.names.end(), surfel.index);
        if (name == layer.names.end() || *name != surfel.index) continue;
        surfel.index = static_cast<std::uint32_t>(name - layer.names.begin());
      }
      own.push_back(surfel);
    }
    if (own.empty()) continue;
    update_layer(layer, own, layer_options, workers, indices, changed);
    if (overgrown(layer, layer_options)) {
      const std::size_t before = indices.size();
      rebuild(layer, layer_options, workers, indices);
      changed.push_back({before, indices.size() - before});
    }
    tidy(layer);
  }
  if (tidy_indices()) return joined({{0, indices.size()}});
  return joined(std::move(changed));
}

// Moves strips together where most of the indices belong to none; whether it did.
bool Strips::State::tidy_indices() {
  std::size_t live = 0;
  for (const Layer& layer : layers) {
    for (const Patch& patch : layer.patches) live += patch.strip.count;
  }
  constexpr std::size_t little = 4096;
  if (indices.size() <= 2 * live + little) return false;
  std::vector<std::uint32_t> together;
  together.reserve(live);
  for (Layer& layer : layers) {
    for (Patch& patch : layer.patches) {
      const auto from = indices.begin() + patch.strip.first;
      patch.strip.first = static_cast<std::uint32_t>(together.size());
      patch.strip.capacity = patch.strip.count;
      together.insert(together.end(), from, from + patch.strip.count);
    }
    for (std::size_t node = 0; node < layer.nodes.size(); ++node) {
      const std::uint32_t leaf = layer.tree.nodes[node].leaf;
      if (leaf != none) layer.nodes[node].first = layer.patches[leaf].strip.first;
    }
  }
  indices = std::move(together);
  return true;
}

Strips::Strips(const Cloud& cloud, const Options& options) {
  check_options(options);
  check_shape(cloud);
  for (std::size_t point = 0; point < cloud.positions.size() / 3; ++point) check_point(cloud, point);
  state_ = std::make_unique<State>(cloud, options);
}
Strips::~Strips() = default;
Strips::Strips(Strips&&) noexcept = default;
Strips& Strips::operator=(Strips&&) noexcept = default;

std::size_t Strips::point_count() const { return state_->points; }
std::span<const std::uint32_t> Strips::indices() const { return state_->indices; }
unsigned Strips::level_count() const { return static_cast<unsigned>(state_->layers.size()); }

std::span<const Node> Strips::nodes(unsigned level) const {
  if (level >= level_count()) {
    throw Error(Element::option, level,
                "level is " + std::to_string(level) + "; there are " + std::to_string(level_count()) +
                    ": ask for more by Options::levels");
  }
  return state_->layers[level].nodes;
}

Counts Strips::counts(unsigned level) const {
  Counts counts;
  static_cast<void>(nodes(level));
  for (const Patch& patch : state_->layers[level].patches) {
    counts.outer += patch.outer;
    counts.redundant += patch.redundant;
    counts.dual += patch.dual;
    counts.valid += patch.valid;
    counts.out_of_reach += patch.out_of_reach;
    counts.turned += patch.evened + patch.turned;
    counts.strips += patch.strip.count > 0 ? 1 : 0;
    counts.indices += patch.strip.count;
  }
  return counts;
}

std::vector<Range> Strips::update(const Cloud& cloud, std::span<const std::uint32_t> moved) {
  State& state = *state_;
  check_shape(cloud);
  const std::size_t count = cloud.positions.size() / 3;
  if (count < state.points || (state.points > 0 && cloud.normals.empty() == state.layer_options.oriented)) {
    throw Error(Element::cloud, 0,
                "of " + std::to_string(count) + " points, " + (cloud.normals.empty() ? "without" : "with") +
                    " normals, does not go on from one of " + std::to_string(state.points) +
                    "; points cannot be taken out, nor normals come or go: make new strips");
  }
  std::vector<std::uint32_t> points(moved.begin(), moved.end());
  for (const std::uint32_t point : points) {
    if (point >= count) {
      throw Error(Element::point, point,
                  "has moved, but there are " + std::to_string(count) + " points: name one of these");
    }
  }
  for (std::size_t point = state.points; point < count; ++point) points.push_back(static_cast<std::uint32_t>(point));
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  for (const std::uint32_t point : points) check_point(cloud, point);
  return state.update(cloud, points);
}

void Strips::select(const View& view, Frame& frame) const {
  const Camera camera(view);
  frame.counts.clear();
  frame.offsets.clear();
  frame.points.clear();
  frame.level = 0;
  frame.indices = frame.strips = frame.visited = frame.out_of_frustum = frame.back_faces = 0;
  for (unsigned level = 1; level < level_count() && view.level_pixels > 0; ++level) {
    const Node& root = state_->layers[level].nodes.front();
    const Vector middle = (to_vector(root.low) + to_vector(root.high)) * 0.5F;
    const float spacing = spacing_of(root, state_->layers[level].owner.size());
    const float to_eye = length(to_vector(root.high) - to_vector(root.low)) * 0.5F;
    if (!(camera.diameter(middle, to_eye) * spacing <= 2 * to_eye * view.level_pixels)) break;
    frame.level = level;
  }
  select_nodes(state_->layers[frame.level].nodes, view, camera, frame);
}

}  // namespace glark::surfel
