// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The text of the passes in measure.glsl.
#pragma once

#include <cstdint>

#include "glark/core/capture/layout.h"
#include "glark/core/objects/compute_pass.h"

namespace glark::depth {

inline constexpr unsigned limit_depths = core::max_supported_level + 1;

// `pass`: GLARK_PASS. `curves`: the pass measures curves.
core::ComputeText measuring_pass(capture::Language language, std::uint64_t pass, bool curves);

}  // namespace glark::depth
