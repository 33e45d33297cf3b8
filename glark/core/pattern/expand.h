// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The instances that make up the pattern of three edge depths, on the CPU. The GPU runs the same rule: expand.glsl.h.
#pragma once

#include <vector>

namespace glark::pattern {

enum class Interior {
  minimum = 0,   // as deep as the shallowest edge
  smooth = 1,    // the same with wider transitions where depths differ by 3 or more; more triangles, better angles
  morphing = 2,  // for a nested pool, while vertices move between levels
  parts = 3,  // the triangles of minimum, without pieces that are whole patterns: whole_pieces.cpp makes these of them
};

// One piece and where it lies: with local barycentrics l, tile weights t[(k + r) mod 3] = l[k], and then
// u = ou + s t[1], v = ov + s t[2], w = 1 - u - v, all exact. s < 0: the tile is upside down. r is 0, 1 or 2.
struct Instance {
  int piece;
  float ou, ov, s, r;
};

// The instances of the pattern with 2^e0, 2^e1, 2^e2 segments on its edges. Throws std::invalid_argument for a depth
// outside 0..11.
std::vector<Instance> expand(int e0, int e1, int e2, Interior interior);

}  // namespace glark::pattern
