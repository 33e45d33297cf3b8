// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Edge depths as the measuring pass leaves them, and what it reads.
#pragma once

#include "glark/gl/types.h"

namespace glark::depth {

// The input of the measuring pass: the positions of the captured corners (vec4), and the limits of this frame.
struct EdgeEnds {
  GLuint positions = 0;
  GLuint limits = 0;
};

// A word for each coarse triangle: some bits for the depth of each edge, edge 0 in the lowest; whole levels in 4 bits, or steps of
// pattern::morph_steps to a level in 10.
struct MeasuredDepths {
  GLuint buffer = 0;  // 0: none
  GLintptr offset = 0;
  int bits = 4;
};

}  // namespace glark::depth
