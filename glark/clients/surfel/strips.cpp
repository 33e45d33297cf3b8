// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The class Strips of the public header.
#include <algorithm>
#include <cmath>
#include <utility>

#include "glark/clients/surfel/cull/camera.h"
#include "glark/clients/surfel/cull/node_selection.h"
#include "glark/clients/surfel/input_validation.h"
#include "glark/clients/surfel/state.h"

namespace glark::surfel {
namespace {

// Estimates the spacing of a level's points, as if they covered the largest face of the root's box.
float spacing_of(const Node& root, std::size_t points) {
  std::array<float, 3> size{};
  for (std::size_t k = 0; k < 3; ++k) size[k] = std::max(0.0F, root.high[k] - root.low[k]);
  std::sort(size.begin(), size.end());
  return std::sqrt(size[2] * size[1] / static_cast<float>(std::max<std::size_t>(points, 1)));
}

}  // namespace

Strips::Strips(const Cloud& cloud, const Options& options) {
  check_options(options);
  check_array_sizes(cloud);
  for (std::size_t point = 0; point < cloud.positions.size() / 3; ++point) check_point(cloud, point);
  state_ = std::make_unique<State>(cloud, options);
}
Strips::~Strips() = default;
Strips::Strips(Strips&&) noexcept = default;
Strips& Strips::operator=(Strips&&) noexcept = default;

std::size_t Strips::point_count() const { return state_->points; }
std::span<const std::uint32_t> Strips::indices() const { return state_->indices; }
unsigned Strips::level_count() const { return static_cast<unsigned>(state_->levels.size()); }

std::span<const Node> Strips::nodes(unsigned level) const {
  check_level(level, level_count());
  return state_->levels[level].nodes;
}

Counts Strips::counts(unsigned level) const {
  Counts counts;
  check_level(level, level_count());
  for (const Patch& patch : state_->levels[level].patches) {
    counts.outer += patch.counts.outer;
    counts.redundant += patch.counts.redundant;
    counts.dual += patch.counts.dual;
    counts.valid += patch.counts.valid;
    counts.out_of_reach += patch.counts.out_of_reach;
    counts.turned += patch.counts.flipped_in_triangulation + patch.counts.flipped_in_strip;
    counts.strips += patch.strip.count > 0 ? 1 : 0;
    counts.indices += patch.strip.count;
  }
  for (const Leaf& leaf : state_->levels[level].tree.leaves)
    counts.loose_points += leaf.has_surface ? 0 : leaf.unique_count;
  return counts;
}

std::vector<Range> Strips::update(const Cloud& cloud, std::span<const std::uint32_t> moved) {
  State& state = *state_;
  check_update(cloud, moved, state.points, state.level_options.has_normals);
  const std::size_t count = cloud.positions.size() / 3;
  std::vector<std::uint32_t> points(moved.begin(), moved.end());
  for (std::size_t point = state.points; point < count; ++point) points.push_back(static_cast<std::uint32_t>(point));
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  for (const std::uint32_t point : points) check_point(cloud, point);
  return state.update(cloud, points);
}

void Strips::select(const View& view, Frame& frame) const {
  check_view(view);
  const Camera camera(view);
  frame.counts.clear();
  frame.offsets.clear();
  frame.points.clear();
  frame.level = 0;
  frame.indices = frame.strips = frame.visited = frame.out_of_frustum = frame.back_faces = 0;
  for (unsigned level = 1; level < level_count() && view.level_pixels > 0; ++level) {
    const Node& root = state_->levels[level].nodes.front();
    const Vector middle = (to_vector(root.low) + to_vector(root.high)) * 0.5F;
    const float spacing = spacing_of(root, state_->levels[level].owner.size());
    const float radius = length(to_vector(root.high) - to_vector(root.low)) * 0.5F;
    if (!(camera.projected_diameter(middle, radius) * spacing <= 2 * radius * view.level_pixels)) break;
    frame.level = level;
  }
  const Level& level = state_->levels[frame.level];
  const auto add_points = [&](std::uint32_t node, std::vector<std::uint32_t>& points) {
    for (const Surfel& surfel : level.tree.unique_surfels(level.tree.leaves[level.tree.nodes[node].leaf]))
      points.push_back(level.cloud_index(surfel.index));
  };
  select_nodes(level.nodes, view, camera, add_points, frame);
}

}  // namespace glark::surfel
