// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Finds the sides of each edge, and ranks them. weld.glsl includes this file. An edge is known by the places of its ends.

// The word of a half-edge: 1 if it runs from the higher end to the lower one; then its slot, from 1; at the top, what
// creases.glsl knows of the triangles beyond it.
const int bits_of_slot = 29;
bool is_falling(int half_edge) { return (tables[edge_slots() + half_edge] & 1u) == 1u; }
// -1: the half-edge is no side of its edge.
int slot_of_side(int half_edge) {
  return int((tables[edge_slots() + half_edge] >> 1) & ((1u << bits_of_slot) - 1u)) - 1;
}

int first_slot_of_edge(int low_place, int high_place) {
  return slot_for(hashed(hashed(0u, uint(low_place)), uint(high_place)));
}

bool is_edge_of(int low_place, int high_place, uint side) {
  return place_of(end_of_side(side, false)) == low_place && place_of(end_of_side(side, true)) == high_place;
}

#if GLARK_PASS == 7
// The slot of the edge of a half-edge that may be no side. -1: no triangle with an area has this edge, so nothing is
// known of it.
int slot_of(int half_edge) {
  int slot = slot_of_side(half_edge);
  int from = place_of(half_edge);
  int to = place_of(next_corner(half_edge));
  if (slot >= 0 || from == to) {
    return slot;
  }
  bool falling = is_falling(half_edge);
  int low = falling ? to : from;
  int high = falling ? from : to;
  int next = first_slot_of_edge(low, high);
  uint side = tables[2 * next];
  while (side != 0u && slot < 0) {
    slot = is_edge_of(low, high, side) ? next : -1;
    next = next_slot(next);
    side = tables[2 * next];
  }
  return slot;
}
#endif

#if GLARK_PASS == 2 || GLARK_PASS == 3
int order_of_words(uvec4 own, uvec4 others) { return own == others ? 0 : before(own, others) ? -1 : 1; }

// The planes decide first, then the positions, which differ within their cells. `by_plane` chooses, so that the
// compiler has one copy of both.
uvec4 content_of(int corner, bool by_plane) {
#if GLARK_CREASED
  int offset = by_plane ? normal_offset : position_offset;
  uvec3 words = uvec3(word_of(corner, offset), word_of(corner, offset + 1), word_of(corner, offset + 2));
  uint w = !by_plane && position_words > 3 ? word_of(corner, position_offset + 3) : 0u;
  return by_plane ? plane_of_normal(words) : uvec4(words, w);
#else
  return plane_of(corner);
#endif
}

// -1: `side` comes before `other`; 1: after it; 0: they are equal.
int order_of(uint side, uint other) {
  int order = 0;
  int steps = GLARK_CREASED == 1 ? 2 * ends_of_edge : ends_of_edge;
  for (int i = 0; i < steps && order == 0; ++i) {
    bool high = (i & 1) == 1;
    order = order_of_words(content_of(end_of_side(side, high), i < 2), content_of(end_of_side(other, high), i < 2));
  }
#if GLARK_DISPLACED
  for (int end = 0; end < ends_of_edge && order == 0 && border_offset >= 0; ++end) {
    order = order_of_words(uvec4(coordinate_of(end_of_side(side, end == 1)), 0u, 0u),
                           uvec4(coordinate_of(end_of_side(other, end == 1)), 0u, 0u));
  }
#endif
  return order;
}
#endif

#if GLARK_PASS == 2
// Puts the side in the place of another that comes after it (direction -1) or before it (1).
void rank_side(int word, uint side, int direction) {
  uint now = atomicCompSwap(tables[word], 0u, side);
  while (now != 0u && now != side && order_of(side, now) == direction) {
    uint seen = atomicCompSwap(tables[word], now, side);
    if (seen == now) {
      return;
    }
    now = seen;
  }
}

int claim_slot(int low_place, int high_place, uint side) {
  int slot = -1;
  int next = first_slot_of_edge(low_place, high_place);
  while (slot < 0) {
    uint taken = atomicCompSwap(tables[2 * next], 0u, side);
    if (taken == 0u || is_edge_of(low_place, high_place, taken)) {
      slot = next;
    }
    next = next_slot(next);
  }
  return slot;
}

// A triangle with two corners in one place is not a side of its edges: its normals belong to the triangles that it
// stitches together.
void join(int half_edge) {
  int next = next_corner(half_edge);
  int from = place_of(half_edge);
  int to = place_of(next);
  int third = place_of(next_corner(next));
  bool falling = order_of_cells(next, half_edge) == -1;
  int slot = -1;
  if (from != to && to != third && third != from) {
    uint side = side_name(half_edge, falling);
    slot = claim_slot(falling ? to : from, falling ? from : to, side);
    for (int end = 0; end < ends_of_edge; ++end) {
      rank_side(2 * slot + end, side, end == 0 ? -1 : 1);
    }
  }
  tables[edge_slots() + half_edge] = uint(2 * (slot + 1)) + (falling ? 1u : 0u);
}
#endif

#if GLARK_PASS == 3
// The cosine of the turn of the normal along a side; 1 without a normal.
float turn_of(uint side) {
  vec3 a = glark_pn_unit(normal_of(end_of_side(side, false)));
  vec3 b = glark_pn_unit(normal_of(end_of_side(side, true)));
  precise float cosine = dot(a, b);
  return a != vec3(0.0) && b != vec3(0.0) && cosine < 1.0 ? cosine : 1.0;
}

void rank_turn(int half_edge) {
  int slot = slot_of_side(half_edge);
  if (slot < 0) {
    return;
  }
  int word = turn_table() + slot;
  uint side = side_name(half_edge, is_falling(half_edge));
  float cosine = turn_of(side);
  uint now = atomicCompSwap(tables[word], 0u, side);
  while (now != 0u && now != side) {
    float other = turn_of(now);
    if (!(cosine < other || (cosine == other && order_of(side, now) == -1))) {
      return;
    }
    uint seen = atomicCompSwap(tables[word], now, side);
    if (seen == now) {
      return;
    }
    now = seen;
  }
}
#endif
