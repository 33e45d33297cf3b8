// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Decides which draws transparent refinement leaves unrefined: user interfaces, full-screen passes, and draws that the
// user names. No GL.
//
// A draw that neither reads nor writes depth cannot meet another draw by its depth values. If it stays unrefined, the
// other passes over the same triangles still fit. All default rules rely on this, with one exception: drawings in the
// plane are exempt because of their matrices, which are the same in all passes.
#pragma once

#include <cstdint>
#include <optional>

#include "glark/core/report/cause.h"
#include "glark/core/state/bindings.h"
#include "glark/core/state/fixed_function/matrices.h"

namespace glark::core {

struct ExemptionFacts {
  unsigned rules = 0;  // bits of left_draws
  const Bindings& bindings;
  bool depth_buffer = true;     // the framebuffer has one; without it, depth is neither tested nor written
  bool left_alone = false;      // the user named the program
  bool conventional = false;    // the program multiplies by the current projection matrix
  std::uint64_t triangles = 0;  // 0: not counted yet
  MatrixTraits matrices = {};   // read only if needs_matrices()
};

bool needs_matrices(const ExemptionFacts& facts);
std::optional<Cause> exemption(const ExemptionFacts& facts);

}  // namespace glark::core
