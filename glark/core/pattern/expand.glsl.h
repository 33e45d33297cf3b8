// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The rule from the depths of three edges to instances of pieces, once for C++ and for GLSL 4.30 / ES 3.10.
//
// The includer defines, before the #include:
//   GLARK_EMIT(piece, ou, ov, s, r)  takes one instance: int piece; float ou, ov, s, r (architecture.md, *patch*)
//   GLARK_SINK_PARAMETER             C++: "Sink& sink," for GLARK_EMIT to use; GLSL: leave undefined
//   GLARK_SINK_ARGUMENT              C++: "sink,"; GLSL: leave undefined
// and calls expand_pattern(GLARK_SINK_ARGUMENT e0, e1, e2, interior). C++ code includes expand.h instead.
//
// Based on: Boubekeur 2007, ch. 7.2.3, Algorithm 5 (interior at the minimum depth, the border split). The thesis keeps
// one pattern for every triple. Here the border is cut at the corners, so that 278 pieces make all 1728 triples: the
// pool is 1.2 MB at level 10 instead of 26 MB. Only shallow patterns are pieces of their own, because they have few
// triangles for the cost of an instance. The ring of triangles along an edge is zipped, not split triangle by
// triangle. Splitting leaves the corner triangles undefined, which belong to two edges, and its angles are worse.
#pragma once

#include "glark/core/pattern/pieces.glsl.h"

#ifdef __cplusplus
namespace glark::pattern {
#define GLARK_EXPAND_FUNCTION static  // not inline: what GLARK_EMIT does may differ from file to file
#else
#define GLARK_EXPAND_FUNCTION
#ifndef GLARK_SINK_PARAMETER
#define GLARK_SINK_PARAMETER
#define GLARK_SINK_ARGUMENT
#endif
#endif

// The values of pattern::Interior, for GLSL.
const int minimum_interior = 0;
const int smooth_interior = 1;
const int morphing_interior = 2;

const int interior_of_parts = 3;

GLARK_SHARED_FUNCTION int lesser(int a, int b) { return a < b ? a : b; }
GLARK_SHARED_FUNCTION int greater(int a, int b) { return a < b ? b : a; }

// A smooth interior is at level 2 even if an edge has depth 0, when another edge is much deeper.
GLARK_SHARED_FUNCTION bool lifts_interior(int least, int most, int interior) {
  return interior == smooth_interior && least == 0 && most >= smooth_difference;
}

// While morphing, a single shallow edge does not remove the interior: the row beside this edge merges
// (refine/epilogue/morph.cpp).
GLARK_SHARED_FUNCTION int morphing_level(int d0, int d1, int d2) {
  int least = lesser(d0, lesser(d1, d2));
  int middle = greater(lesser(d0, d1), lesser(greater(d0, d1), d2));
  return greater(least, lesser(middle, lifted_interior));
}

GLARK_SHARED_FUNCTION int skirt_of(int level, int d, int interior) {
  return interior == smooth_interior && d >= level + smooth_difference ? smooth_skirt_piece(level, d)
                                                                       : skirt_piece(level, d);
}

// A pattern that is one piece (whole_piece).
GLARK_SHARED_FUNCTION bool is_whole(int least, int most, int interior) {
  return interior == minimum_interior && least > 0 && least < most && most <= deepest_whole;
}

// Expands one tile. All its depths are equal and at most 8, or the least depth is 0 or 2..6. The upside-down tile to the
// right, if there is one, has three edges of depth `beside`, because it touches no edge of the whole triangle; -1: there
// is none. GLARK_EMIT stands here only once: compilers inline it, and processors that run both sides of a branch pay for
// each place.
GLARK_EXPAND_FUNCTION void expand_tile(GLARK_SINK_PARAMETER int d0, int d1, int d2, int interior, float ou, float ov,
                                       float s, int beside) {
  int least = lesser(d0, lesser(d1, d2));
  int most = greater(d0, greater(d1, d2));
  // Skirts cut the corners in another way than a regular pattern. While morphing, equal depths have skirts, too.
  bool regular = least == most && (interior != morphing_interior || least == 0);
  int inner = interior == morphing_interior ? morphing_level(d0, d1, d2) : least;
  bool entire = is_whole(least, most, interior);
  bool skirted = !regular && !entire && (inner >= shallowest_interior || lifts_interior(least, most, interior));
  bool centred = !regular && !skirted && interior == morphing_interior;
  int level = greater(inner, shallowest_interior);
  int short_edge = d0 == least ? 0 : d1 == least ? 1 : 2;  // edge 0 of a fan or a whole pattern
  int after = short_edge == 0 ? d1 : short_edge == 1 ? d2 : d0;
  int before = short_edge == 0 ? d2 : short_edge == 1 ? d0 : d1;
  bool turned = !regular && !skirted && !centred;
  int whole = entire ? whole_piece(least, after, before) : fan_piece(after, before);
  int first = regular ? uniform_piece(least) : skirted ? interior_piece(level) : centred ? centre_skirt_piece(d0) : whole;
  // Part 0 is the first piece, part k the one along edge k - 1, and the last part the upside-down tile.
  int parts = skirted || centred ? 4 : 1;
  int end = beside >= 0 ? parts + 1 : parts;
  for (int part = 0; part < end; ++part) {
    bool over = part == parts;
    int edge = part - 1;
    int d = edge == 0 ? d0 : edge == 1 ? d1 : d2;
    int skirt = centred ? centre_skirt_piece(d) : skirt_of(level, d, interior);
    int piece = over ? uniform_piece(beside) : part == 0 ? first : skirt;
    int turn = over ? 0 : part > 0 ? edge : turned ? short_edge : 0;
    bool drawn = !(centred && part == 1);  // the first piece is the skirt of edge 0
    float size = over ? -s : s;
    if (drawn) GLARK_EMIT(piece, over ? ou + s : ou, over ? ov + s : ov, size, float(turn));
  }
}

// How often the whole triangle is halved into tiles (4^halvings of them), so that every piece that a tile needs exists.
// Least depth 1 has neither a fan nor an interior. It becomes four tiles of least depth 0, and the smooth interior
// lifts the steep ones. This gives better angles than one lifted interior: for depths 1, 1, 4,
// 10.9 degrees instead of 4.7.
GLARK_SHARED_FUNCTION int tile_halvings(int least, int most, int interior) {
  if (interior == morphing_interior && least <= tile_level) return 0;
  if (is_whole(least, most, interior)) return 0;
  if (least == most) return greater(least - deepest_uniform, 0);
  return least == 1 ? 1 : greater(least - tile_level, 0);
}

// Emits the instances of the pattern with 2^e0, 2^e1 and 2^e2 segments on edges 0, 1 and 2; depths are 0..11.
// interior 0: at the least depth; 1: wider transitions where depths differ by 3 or more; 2: morphing; 3: as 0, but no
// piece is a whole pattern. With 2, patterns whose least depth is above tile_level are as with 0, and their tiles have no centre.
GLARK_EXPAND_FUNCTION void expand_pattern(GLARK_SINK_PARAMETER int e0, int e1, int e2, int interior) {
  int least = lesser(e0, lesser(e1, e2));
  int most = greater(e0, greater(e1, e2));
  int halvings = tile_halvings(least, most, interior);
  int tiles = 1 << halvings;
  float s = 1.0f / float(tiles);
  int tile_interior = interior == morphing_interior && least > tile_level ? 0 : interior;
  int inner = least - halvings;  // depth of the edges between tiles
  for (int j = 0; j < tiles; ++j) {
    for (int i = 0; i + j < tiles; ++i) {
      bool last = i + j + 1 == tiles;
      float ou = float(i) * s;
      float ov = float(j) * s;
      expand_tile(GLARK_SINK_ARGUMENT j == 0 ? e0 - halvings : inner, last ? e1 - halvings : inner,
                  i == 0 ? e2 - halvings : inner, tile_interior, ou, ov, s, last ? -1 : inner);
    }
  }
}

#ifdef __cplusplus
}  // namespace glark::pattern
#endif
