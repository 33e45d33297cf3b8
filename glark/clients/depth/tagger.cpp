// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "glark/clients/depth/state.h"
#include "glark/clients/depth/validation.h"

namespace glark::depth {
namespace {

using common::Vector3f;
using common::vector_at;

constexpr unsigned deepest_level = 11;
constexpr std::size_t most_vertices = std::size_t{1} << 28;

}  // namespace

Tagger::Tagger(std::size_t vertices, std::span<const std::uint32_t> triangles, unsigned max_level)
    : vertices_(vertices), max_level_(max_level) {
  require(max_level <= deepest_level, "level {} exceeds {}, the deepest of the extension", max_level, deepest_level);
  require(vertices <= most_vertices, "{} vertices are more than 2^28; split the mesh", vertices);
  require(triangles.size() % 3 == 0, "{} indices are no whole number of triangles", triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    require(triangles[i] < vertices, "triangle {} has the vertex {}; there are {}", i / 3, triangles[i], vertices);
  }
  state_ = std::make_unique<State>(vertices, triangles);
}

Tagger::~Tagger() = default;
Tagger::Tagger(const Tagger& other)
    : vertices_(other.vertices_), max_level_(other.max_level_), state_(std::make_unique<State>(*other.state_)) {}
Tagger& Tagger::operator=(const Tagger& other) { return *this = Tagger(other); }
Tagger::Tagger(Tagger&& other) noexcept = default;
Tagger& Tagger::operator=(Tagger&& other) noexcept = default;

float Tagger::clamped(float tag) const { return tag > 0 ? std::min(tag, static_cast<float>(max_level_)) : 0.0F; }

void Tagger::manual(std::span<const float> wanted, std::span<float> tags) const {
  check_tags("the tag", wanted, vertices_);
  check_target(tags, vertices_);
  std::transform(wanted.begin(), wanted.end(), tags.begin(), [&](float tag) { return clamped(tag); });
}

void Tagger::by_distance(std::span<const float> positions, const DistanceRange& range, std::span<float> tags) const {
  check_positions(positions, vertices_);
  check_target(tags, vertices_);
  const Vector3f point = common::to_vector(range.point);
  require(std::isfinite(robust_length(point)), "the point that distances are measured from is not finite");
  require(range.nearest < range.farthest && std::isfinite(range.farthest - range.nearest),
          "the range of distances {} to {} is empty", range.nearest, range.farthest);
  require(std::isfinite(range.finest) && std::isfinite(range.coarsest), "the tags of the range are not finite");
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    const float distance = robust_length(vector_at(positions, vertex) - point);
    const float along = std::clamp((distance - range.nearest) / (range.farthest - range.nearest), 0.0F, 1.0F);
    tags[vertex] = clamped(range.finest + along * (range.coarsest - range.finest));
  }
}

void Tagger::State::measure_rings(std::span<const float> positions) {
  std::fill(longest.begin(), longest.end(), 0.0F);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t a = triangles[i], b = after(i);
    const float size = robust_length(vector_at(positions, b) - vector_at(positions, a));
    longest[a] = std::max(longest[a], size);
    longest[b] = std::max(longest[b], size);
  }
}

void Tagger::by_edge_length(std::span<const float> positions, const View& view, float pixels, std::span<float> tags) {
  check_positions(positions, vertices_);
  check_target(tags, vertices_);
  check_view(view);
  require(pixels > 0, "segments of {} pixels are not possible", pixels);
  std::vector<float>& longest = state_->longest;
  const Vector3f eye = common::to_vector(view.eye);
  std::fill(longest.begin(), longest.end(), 0.0F);
  for (std::size_t i = 0; i < state_->triangles.size(); ++i) {
    const std::uint32_t a = state_->triangles[i], b = state_->after(i);
    const Vector3f from = vector_at(positions, a), to = vector_at(positions, b);
    const float distance = std::max(robust_length(0.5F * (from + to) - eye), view.nearest);
    const float size = robust_length(to - from) * view.pixels_at_one / distance;
    longest[a] = std::max(longest[a], size);
    longest[b] = std::max(longest[b], size);
  }
  // The depth of an edge is the mean of the tags at its ends. The tag of each end is deep enough for the edge.
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex)
    tags[vertex] = clamped(std::log2(std::max(longest[vertex] / pixels, 1.0F)));
}

void Tagger::take_greater(std::span<const float> other, std::span<float> tags) const {
  check_tags("the other tag", other, vertices_);
  check_tags("the tag", tags, vertices_);
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    tags[vertex] = clamped(std::max(tags[vertex], other[vertex]));
  }
}

void Tagger::take_lesser(std::span<const float> other, std::span<float> tags) const {
  check_tags("the other tag", other, vertices_);
  check_tags("the tag", tags, vertices_);
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    tags[vertex] = clamped(std::min(tags[vertex], other[vertex]));
  }
}

void Tagger::blend(std::span<const float> other, float weight, std::span<float> tags) const {
  check_tags("the other tag", other, vertices_);
  check_tags("the tag", tags, vertices_);
  require(weight >= 0 && weight <= 1, "the weight {} is not in 0 to 1", weight);
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    tags[vertex] = clamped(weight * clamped(other[vertex]) + (1 - weight) * clamped(tags[vertex]));
  }
}

}  // namespace glark::depth
