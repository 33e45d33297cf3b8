// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The state of a Strips object.
#pragma once

#include <glark/surfel.h>

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/surfel/level/level.h"

namespace glark::surfel {

struct Strips::State {
  Options options;
  LevelOptions level_options;
  common::Workers workers;
  std::size_t points = 0;
  std::vector<Level> levels;  // the finest first
  std::vector<std::uint32_t> indices;

  State(const Cloud& cloud, const Options& chosen);
  void build(std::vector<Surfel> surfels);
  // moved: ascending, without duplicates. It includes new points.
  std::vector<Range> update(const Cloud& cloud, std::span<const std::uint32_t> moved);

 private:
  void update_level_of(Level& level, std::span<const Surfel> moved, std::vector<Range>& changed);
  bool compact_indices();
};

}  // namespace glark::surfel
