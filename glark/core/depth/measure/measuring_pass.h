// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The text of the passes in measure.glsl, and what each of their programs measures.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "glark/core/capture/layout.h"
#include "glark/core/depth/depth_plan.h"
#include "glark/core/objects/programs/compute_pass.h"

namespace glark::depth {

inline constexpr unsigned limit_depths = core::max_supported_level + 1;

// What the depths of a draw depend on. Each set of measures has programs of its own, because software renderers run both
// sides of every branch.
struct Measures {
  bool tags = false;      // of the vertices; nothing is measured
  bool lengths = false;   // of edges on the screen
  bool normals = false;   // angles between them
  bool straight = false;  // straight edges have depth 0
  int points = 0;         // ScreenProgram::points
  int depth_steps = 1;
  bool curves() const { return points > corners_only; }
  auto operator<=>(const Measures&) const = default;
};
Measures measures_of(const DepthPlan& plan, const capture::Layout& layout);
std::vector<core::ComputeText::Define> defines_of(const Measures& measures);

// `pass`: GLARK_PASS.
core::ComputeText measuring_pass(capture::Language language, std::uint64_t pass, const Measures& measures);

}  // namespace glark::depth
