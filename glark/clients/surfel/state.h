// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glark/surfel.h>

#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/surfel/layer.h"

namespace glark::surfel {

struct Strips::State {
  Options options;
  LayerOptions layer_options;
  Workers workers;
  std::size_t points = 0;
  std::vector<Layer> layers;  // the finest first
  std::vector<std::uint32_t> indices;

  State(const Cloud& cloud, const Options& chosen);
  void build(std::vector<Surfel> surfels);
  std::vector<Range> update(const Cloud& cloud, std::span<const std::uint32_t> moved);
  bool tidy_indices();
};

// Throws Error.
void check_options(const Options& options);
void check_shape(const Cloud& cloud);
void check_point(const Cloud& cloud, std::size_t point);

// A power of two that brings coordinates below 1, so that products neither overflow nor vanish.
float unit_of(float greatest_coordinate);
Surfel surfel_of(const Cloud& cloud, std::size_t point, float unit);

}  // namespace glark::surfel
