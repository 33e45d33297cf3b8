// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/depth/validation.h"

#include <algorithm>
#include <cmath>

#include "glark/clients/common/vector.h"

namespace glark::depth {

void check_length(const char* what, std::size_t length, std::size_t vertices, std::size_t components) {
  require(length == vertices * components, "{} has {} floats; {} vertices need {}", what, length, vertices,
          vertices * components);
}

void check_finite(const char* what, std::span<const float> values, std::size_t components) {
  const auto bad = std::find_if(values.begin(), values.end(), [](float value) { return !std::isfinite(value); });
  require(bad == values.end(), "{} of vertex {} is not a finite number", what,
          static_cast<std::size_t>(bad - values.begin()) / components);
}

void check_tags(const char* what, std::span<const float> tags, std::size_t vertices) {
  check_length(what, tags.size(), vertices, 1);
  check_finite(what, tags, 1);
}

void check_target(std::span<const float> tags, std::size_t vertices) {
  check_length("the array of tags", tags.size(), vertices, 1);
}

void check_positions(std::span<const float> positions, std::size_t vertices) {
  check_length("the array of positions", positions.size(), vertices, 3);
  check_finite("the position", positions, 3);
}

void check_normals(std::span<const float> normals, std::size_t vertices) {
  if (normals.empty()) return;
  check_length("the array of normals", normals.size(), vertices, 3);
  check_finite("the normal", normals, 3);
}

void check_view(const View& view) {
  require(view.pixels_at_one > 0 && view.nearest > 0 && std::isfinite(robust_length(common::to_vector(view.eye))),
          "the view needs a finite eye, and pixels and a nearest distance above 0");
}

}  // namespace glark::depth
