// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Surfel stripping behind its public face.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

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

}  // namespace

Strips::State::State(const Cloud& cloud, const Options& chosen) : options(chosen), layer_options{}, workers(chosen.threads) {
  layer_options = {
      .tree = {chosen.leaf_points, chosen.delta_a, chosen.delta_d, chosen.inflation},
      .reach = chosen.reach,
      .unit = unit_of(greatest_of(cloud.positions)),
      .oriented = !cloud.normals.empty(),
  };
  std::vector<Surfel> surfels(cloud.positions.size() / 3);
  constexpr std::size_t grain = 16384;
  workers.each(surfels.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) surfels[i] = surfel_of(cloud, i, layer_options.unit);
  });
  points = surfels.size();
  build(std::move(surfels));
}

void Strips::State::build(std::vector<Surfel> surfels) {
  std::vector<std::uint32_t> names;
  layers.clear();
  indices.clear();
  for (unsigned level = 0; level < options.levels; ++level) {
    layers.push_back(build_layer(std::move(surfels), std::move(names), layer_options, workers, indices));
    if (level + 1 < options.levels) surfels = coarser(layers.back(), names);
  }
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
    counts.strips += patch.strip.count > 0 ? 1 : 0;
    counts.indices += patch.strip.count;
  }
  return counts;
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
