// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The instances of a measured draw that is seen from the same place again: its depths are the same, too.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "glark/core/context_options.h"
#include "glark/core/depth/binned_instances.h"
#include "glark/core/objects/gpu_buffer.h"

namespace glark::core {

// What measured depths depend on, besides the key of the draw that they belong to, and the values of uniforms.
struct ViewKey {
  std::uint64_t program = 0;  // number of the program that gives positions on the screen; 0: the screen is not measured
  EdgeMeasure measure;
  float shape_number = 0;
  std::array<float, 2> viewport{};
  int culled_side = 0;
  unsigned deepest = 0;
  int depth_steps = 1;
  int interior = 0;
  int points = 0;
  bool operator==(const ViewKey&) const = default;
};

// The uniforms that positions depend on. Their values are compared only if they were set again.
struct ViewUniforms {
  std::uint64_t changes = 0;  // calls that set one of them
  std::vector<std::uint32_t> values;
  unsigned moves = 0;  // how often the values have differed
  unsigned pause = 0;  // draws without a comparison: the values have changed all the time
};

struct KeptView {
  ViewKey key;
  ViewUniforms uniforms;
  bool followed = false;     // the key and the uniforms are those of the last draw
  bool refused = false;      // in this view: there is no memory
  std::uint64_t number = 0;  // tells the views of all draws apart; 0: no instances are kept
  GpuBuffer buffer;
  depth::BinnedInstances bins;
  std::uint64_t refined_triangles = 0;

  bool kept() const { return number != 0; }
};

}  // namespace glark::core
