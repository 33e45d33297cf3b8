// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The numbering of the pieces that patterns are put together from, for C++ and for GLSL 4.30 / ES 3.10. It does not
// depend on the pool's level: pieces that a pool does not reach are empty there.
#pragma once

#ifdef __cplusplus
#define GLARK_SHARED_FUNCTION constexpr
namespace glark::pattern {
#else
#define GLARK_SHARED_FUNCTION
#endif

const int deepest_level = 11;       // 2^11 segments on an edge
const int deepest_uniform = 8;      // deeper uniform patterns are tiles of uniform(8)
const int tile_level = 6;           // deepest interior; deeper patterns are tiles whose inner edges have this depth
const int shallowest_interior = 2;  // uniform(1) has no triangle that keeps clear of the border
const int lifted_interior = 3;      // while morphing: interior depth, or the second least edge depth if that is less
const int smooth_difference = 3;    // from this many levels on, a smooth interior puts a row between edge and interior
const int morph_steps = 64;         // of a level, where refined vertices morph between levels
const int lattice_one = 32768;      // the lattice coordinate (16-bit, unsigned) that stands for a barycentric of 1

const int first_uniform = 0;
const int first_interior = 9;       // first_uniform + deepest_uniform + 1
const int first_skirt = 14;         // first_interior + tile_level - shallowest_interior + 1
const int first_smooth_skirt = 74;  // first_skirt + 5 * 12
const int first_fan = 134;          // first_smooth_skirt + 5 * 12
const int first_whole = 278;        // first_fan + 12 * 12
const int deepest_whole = 5;        // up to here, a pattern of the minimum interior is one piece
const int piece_count = 333;        // first_whole + 5 * 5 + 4 * 4 + 3 * 3 + 2 * 2 + 1

// m = 0..8: 2^m segments on every edge.
GLARK_SHARED_FUNCTION int uniform_piece(int m) { return first_uniform + m; }

// m = 2..6: the triangles of uniform(m) that do not touch the border.
GLARK_SHARED_FUNCTION int interior_piece(int m) { return first_interior + m - shallowest_interior; }

// m = 2..6, d = 0..11: from 2^d segments on edge 0 to the first inner row of interior(m). Empty where d < m, except
// with m = 2.
GLARK_SHARED_FUNCTION int skirt_piece(int m, int d) {
  return first_skirt + (m - shallowest_interior) * (deepest_level + 1) + d;
}

// The same through one middle row. Empty where d < m + smooth_difference.
GLARK_SHARED_FUNCTION int smooth_skirt_piece(int m, int d) {
  return first_smooth_skirt + (m - shallowest_interior) * (deepest_level + 1) + d;
}

// d = 0..11: from 2^d segments on edge 0 to the centre point. Only nested pools have these pieces, in place of smooth
// skirts.
GLARK_SHARED_FUNCTION int centre_skirt_piece(int d) { return first_smooth_skirt + d; }

// b, c = 0..11: 1 segment on edge 0, 2^b on edge 1, 2^c on edge 2.
GLARK_SHARED_FUNCTION int fan_piece(int b, int c) { return first_fan + b * (deepest_level + 1) + c; }

// m = 1..5, b, c = m..5: a whole pattern, with 2^m segments on edge 0, 2^b on edge 1, 2^c on edge 2. Empty where all
// three are equal. Nested pools have none of these pieces.
GLARK_SHARED_FUNCTION int whole_piece(int m, int b, int c) {
  int n = deepest_whole - m + 1;
  return piece_count - n * (n + 1) * (2 * n + 1) / 6 + (b - m) * n + (c - m);
}

#ifdef __cplusplus
}  // namespace glark::pattern
#endif
