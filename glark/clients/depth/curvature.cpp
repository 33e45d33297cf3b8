// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <tuple>

#include "glark/clients/depth/state.h"
#include "glark/clients/depth/validation.h"

namespace glark::depth {
namespace {

// Returns the height of the arc over an edge, with the larger principal curvature. Each level divides the height by
// four.
float sagitta(std::pair<float, float> curvatures, float edge) {
  return std::max(std::abs(curvatures.first), std::abs(curvatures.second)) * edge * edge / 8;
}

}  // namespace

void Tagger::principal_curvatures(std::span<const float> positions, std::span<const float> normals,
                                  std::span<float> greater, std::span<float> lesser) {
  check_positions(positions, vertices_);
  check_normals(normals, vertices_);
  check_target(greater, vertices_);
  check_target(lesser, vertices_);
  state_->curvature.find(state_->triangles, positions, normals);
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex)
    std::tie(greater[vertex], lesser[vertex]) = state_->curvature.principal(vertex);
}

void Tagger::by_curvature(std::span<const float> positions, std::span<const float> normals, float tolerance,
                          std::span<float> tags) {
  check_positions(positions, vertices_);
  check_normals(normals, vertices_);
  check_target(tags, vertices_);
  require(tolerance > 0, "the tolerance {} is not above 0", tolerance);
  state_->curvature.find(state_->triangles, positions, normals);
  state_->measure_rings(positions);
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    const float height = sagitta(state_->curvature.principal(vertex), state_->longest[vertex]);
    tags[vertex] = clamped(0.5F * std::log2(std::max(height / tolerance, 1.0F)));
  }
}

void Tagger::by_curvature(std::span<const float> positions, std::span<const float> normals, const View& view,
                          float pixels, std::span<float> tags) {
  check_positions(positions, vertices_);
  check_normals(normals, vertices_);
  check_target(tags, vertices_);
  check_view(view);
  require(pixels > 0, "the tolerance of {} pixels is not above 0", pixels);
  state_->curvature.find(state_->triangles, positions, normals);
  state_->measure_rings(positions);
  const common::Vector3f eye = common::to_vector(view.eye);
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    const float distance = std::max(robust_length(common::vector_at(positions, vertex) - eye), view.nearest);
    const float height = sagitta(state_->curvature.principal(vertex), state_->longest[vertex]);
    tags[vertex] = clamped(0.5F * std::log2(std::max(height * view.pixels_at_one / distance / pixels, 1.0F)));
  }
}

}  // namespace glark::depth
