// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The edge depths that the measuring pass writes, and the input of that pass.
#pragma once

#include "glark/gl/types.h"

namespace glark::depth {

// The input of the measuring pass: the positions of the captured corners (vec4), and the limits of this frame.
struct EdgeEnds {
  GLuint positions = 0;
  GLuint limits = 0;
};

// Bits for the depth of an edge: for whole levels, or for steps.
constexpr int measured_bits(bool morphing) { return morphing ? 10 : 4; }

// One word per coarse triangle, with some bits for the depth of each edge, edge 0 in the lowest. Depths are whole
// levels in 4 bits, or steps in 10 bits (pattern::morph_steps per level). The highest bit is set if all three edges are
// straight, where the budget does not pay for them (BudgetPlan).
struct MeasuredDepths {
  GLuint buffer = 0;  // 0: none
  GLintptr offset = 0;
};

}  // namespace glark::depth
