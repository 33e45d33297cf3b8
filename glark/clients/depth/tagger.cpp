// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>

#include "glark/clients/depth/vector.h"

namespace glark::tagging {
namespace {

constexpr unsigned deepest_level = 11;

// The text is made only where it is needed: updates allocate nothing.
template <class Text>
void require(bool holds, const Text& otherwise) {
  if (!holds) throw Error("glark: " + std::string(otherwise()));
}

void check_length(const char* what, std::size_t length, std::size_t vertices, std::size_t components) {
  require(length == vertices * components, [&] {
    return std::string(what) + " has " + std::to_string(length) + " floats; " + std::to_string(vertices) +
           " vertices need " + std::to_string(vertices * components);
  });
}

void check_finite(const char* what, std::span<const float> values, std::size_t components) {
  const auto bad = std::find_if(values.begin(), values.end(), [](float value) { return !std::isfinite(value); });
  if (bad == values.end()) return;
  const auto vertex = static_cast<std::size_t>(bad - values.begin()) / components;
  throw Error("glark: " + std::string(what) + " of vertex " + std::to_string(vertex) + " is not a finite number");
}

}  // namespace

Tagger::Tagger(std::size_t vertices, std::span<const std::uint32_t> triangles, unsigned max_level)
    : vertices_(vertices), max_level_(max_level), triangles_(triangles.begin(), triangles.end()) {
  require(max_level <= deepest_level, [&] {
    return "level " + std::to_string(max_level) + " exceeds " + std::to_string(deepest_level) +
           ", the deepest of the extension";
  });
  require(triangles.size() % 3 == 0,
          [&] { return std::to_string(triangles.size()) + " indices are no whole number of triangles"; });
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    require(triangles[i] < vertices, [&] {
      return "triangle " + std::to_string(i / 3) + " has the vertex " + std::to_string(triangles[i]) + "; there are " +
             std::to_string(vertices);
    });
  }
  longest_.resize(vertices);
  normals_.resize(vertices);
  first_axes_.resize(vertices);
  second_axes_.resize(vertices);
  tensors_.resize(vertices);
  areas_.resize(vertices);
  corner_areas_.resize(triangles.size() / 3);
}

void Tagger::check_tags(const char* what, std::span<const float> tags) const {
  check_length(what, tags.size(), vertices_, 1);
  check_finite(what, tags, 1);
}

void Tagger::check_target(std::span<const float> tags) const {
  check_length("the array of tags", tags.size(), vertices_, 1);
}

void Tagger::check_positions(std::span<const float> positions) const {
  check_length("the array of positions", positions.size(), vertices_, 3);
  check_finite("the position", positions, 3);
}

void Tagger::check_normals(std::span<const float> normals) const {
  if (normals.empty()) return;
  check_length("the array of normals", normals.size(), vertices_, 3);
  check_finite("the normal", normals, 3);
}

float Tagger::limited(float tag) const { return tag > 0 ? std::min(tag, static_cast<float>(max_level_)) : 0.0F; }

void Tagger::manual(std::span<const float> wanted, std::span<float> tags) const {
  check_tags("the tag", wanted);
  check_target(tags);
  std::transform(wanted.begin(), wanted.end(), tags.begin(), [&](float tag) { return limited(tag); });
}

void Tagger::by_distance(std::span<const float> positions, const DistanceRange& range, std::span<float> tags) const {
  check_positions(positions);
  check_target(tags);
  require(std::isfinite(length(range.point)), [&] { return "the point that distances are taken from is not finite"; });
  require(range.nearest < range.farthest && std::isfinite(range.farthest - range.nearest), [&] {
    return "the range of distances " + std::to_string(range.nearest) + " to " + std::to_string(range.farthest) +
           " is empty";
  });
  require(std::isfinite(range.finest) && std::isfinite(range.coarsest),
          [&] { return "the tags of the range are not finite"; });
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    const float distance = length(minus(vector_at(positions, vertex), range.point));
    const float along = std::clamp((distance - range.nearest) / (range.farthest - range.nearest), 0.0F, 1.0F);
    tags[vertex] = limited(range.finest + along * (range.coarsest - range.finest));
  }
}

void Tagger::measure_rings(std::span<const float> positions) {
  std::fill(longest_.begin(), longest_.end(), 0.0F);
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const std::uint32_t a = triangles_[i];
    const std::uint32_t b = triangles_[i % 3 == 2 ? i - 2 : i + 1];
    const float size = length(minus(vector_at(positions, b), vector_at(positions, a)));
    longest_[a] = std::max(longest_[a], size);
    longest_[b] = std::max(longest_[b], size);
  }
}

void Tagger::by_edge_length(std::span<const float> positions, const View& view, float pixels, std::span<float> tags) {
  check_positions(positions);
  check_target(tags);
  require(view.pixels_at_one > 0 && view.nearest > 0 && std::isfinite(length(view.eye)),
          [&] { return "the view needs a finite eye, and pixels and a nearest distance above 0"; });
  require(pixels > 0, [&] { return "segments of " + std::to_string(pixels) + " pixels are no measure"; });
  std::fill(longest_.begin(), longest_.end(), 0.0F);
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const std::uint32_t a = triangles_[i];
    const std::uint32_t b = triangles_[i % 3 == 2 ? i - 2 : i + 1];
    const Vector from = vector_at(positions, a);
    const Vector to = vector_at(positions, b);
    const float distance = std::max(length(minus(times(0.5F, plus(from, to)), view.eye)), view.nearest);
    const float size = length(minus(to, from)) * view.pixels_at_one / distance;
    longest_[a] = std::max(longest_[a], size);
    longest_[b] = std::max(longest_[b], size);
  }
  // An edge takes the mean of its ends, each of which is deep enough for it.
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    tags[vertex] = limited(std::log2(std::max(longest_[vertex] / pixels, 1.0F)));
  }
}

void Tagger::take_greater(std::span<const float> other, std::span<float> tags) const {
  check_tags("the other tag", other);
  check_tags("the tag", tags);
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    tags[vertex] = limited(std::max(tags[vertex], other[vertex]));
  }
}

void Tagger::take_lesser(std::span<const float> other, std::span<float> tags) const {
  check_tags("the other tag", other);
  check_tags("the tag", tags);
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    tags[vertex] = limited(std::min(tags[vertex], other[vertex]));
  }
}

void Tagger::blend(std::span<const float> other, float weight, std::span<float> tags) const {
  check_tags("the other tag", other);
  check_tags("the tag", tags);
  require(weight >= 0 && weight <= 1, [&] { return "the weight " + std::to_string(weight) + " is not in 0 to 1"; });
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    tags[vertex] = limited(weight * limited(other[vertex]) + (1 - weight) * limited(tags[vertex]));
  }
}

}  // namespace glark::tagging
