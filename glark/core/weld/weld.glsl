// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Joins coarse triangles by position. Hash tables find what the sides of an edge and the triangles about a vertex must
// share; the results go into the coarse records. The includer supplies #version and:
//   GLARK_PASS       0 clear the tables, 1 insert, 2 mark creases, 3 write, 4 all in one work group
//   GLARK_GROUP      size of a work group
//   GLARK_KEY_WORDS  most words of a key besides the position
//   GLARK_DISPLACED  1 if records have border words. Where it is 0, the pass compiles faster
//   GLARK_CREASED    1 if curved triangles stay near their coarse ones
//
// The results do not depend on the order, to the bit. A slot keeps the least and the greatest of its sides by content,
// the greatest tag, and sums of whole numbers. Neither the order of insertion nor duplicates change these.
// Based on: J. McDonald, M. Kilgard, Crack-Free Point-Normal Triangles Using Adjacent Edge Normals, 2010 (the normals
// of all sides bend an edge). The paper finds the sides by an index buffer that is made beforehand; here hashing finds
// them. Across an angle, the paper takes the mean of the control points; here the edge follows the line in which the
// tangent planes meet.
#define glark_precise precise
#include "glark/core/weld/tables.glsl"
#include "glark/core/weld/cells.glsl"
#include "glark/core/weld/tangent.glsl"

layout(local_size_x = GLARK_GROUP) in;

int bound;  // of triangles

// The tangent plane of the normal. Of the two opposite directions, it is the one whose first nonzero component is
// positive. Zero if the normal is zero or not finite.
uvec4 plane_of(int corner) {
  uvec3 words = uvec3(word_of(corner, normal_offset), word_of(corner, normal_offset + 1), word_of(corner, normal_offset + 2));
  if (any(greaterThanEqual(words & 0x7fffffffu, uvec3(0x7f800000u)))) {
    return uvec4(0u);
  }
  uint leading = words.x != 0u ? words.x : words.y != 0u ? words.y : words.z;
  if (leading >= 0x80000000u) {
    words = uvec3(words.x != 0u ? words.x ^ 0x80000000u : 0u, words.y != 0u ? words.y ^ 0x80000000u : 0u,
                  words.z != 0u ? words.z ^ 0x80000000u : 0u);
  }
  return uvec4(words, 0u);
}

// An edge, with the values of one of its sides at the ends.
struct Edge {
  uvec4 low;  // cells
  uvec4 high;
  uvec4 low_plane;
  uvec4 high_plane;
  uint side;
};

bool is_edge_of(Edge edge, uint side) {
  int low = end_of_side(side, false);
  return cell_of(low) == edge.low && cell_of(end_of_side(side, true)) == edge.high &&
         same_key(low, end_of_side(edge.side, false));
}

uvec2 coordinate_of(int corner) { return uvec2(word_of(corner, coordinate_offset), word_of(corner, coordinate_offset + 1)); }

uvec4 coordinates_of(uint side) {
  return border_offset < 0 ? uvec4(0u) : uvec4(coordinate_of(end_of_side(side, false)), coordinate_of(end_of_side(side, true)));
}

// -1: the edge's own side comes before the other; 1: after it; 0: they are equal.
int order_of(Edge edge, uint other) {
  uvec4 low = plane_of(end_of_side(other, false));
  uvec4 high = plane_of(end_of_side(other, true));
  if (low != edge.low_plane) {
    return before(edge.low_plane, low) ? -1 : 1;
  }
  if (high != edge.high_plane) {
    return before(edge.high_plane, high) ? -1 : 1;
  }
  uvec4 own = coordinates_of(edge.side);
  uvec4 others = coordinates_of(other);
  if (own != others) {
    return before(own, others) ? -1 : 1;
  }
  return GLARK_CREASED == 1 ? order_in_cells(edge.side, other) : 0;
}

// Puts the side in the place of another that comes after it (direction -1) or before it (1).
void rank_side(int word, Edge edge, uint now, int direction) {
  while (now == 0u || (now != edge.side && order_of(edge, now) == direction)) {
    uint seen = atomicCompSwap(tables[word], now, edge.side);
    if (seen == now) {
      return;
    }
    now = seen;
  }
}

uvec3 normal_words(int corner) {
  return uvec3(word_of(corner, normal_offset), word_of(corner, normal_offset + 1), word_of(corner, normal_offset + 2));
}

vec3 normal_of(int corner) {
  int word = record_offset + corner * corner_words + normal_offset;
  return uintBitsToFloat(uvec3(records[word], records[word + 1], records[word + 2]));
}

// The cosine of the turn of the normal along a side; 1 without a normal.
float turn_of(uint side) {
  vec3 a = glark_pn_unit(normal_of(end_of_side(side, false)));
  vec3 b = glark_pn_unit(normal_of(end_of_side(side, true)));
  precise float cosine = dot(a, b);
  return a != vec3(0.0) && b != vec3(0.0) && cosine < 1.0 ? cosine : 1.0;
}

void rank_turn(int word, Edge edge) {
  float cosine = turn_of(edge.side);
  uint now = atomicCompSwap(tables[word], 0u, edge.side);
  while (now != 0u && now != edge.side) {
    float other = turn_of(now);
    if (!(cosine < other || (cosine == other && order_of(edge, now) == -1))) {
      return;
    }
    uint seen = atomicCompSwap(tables[word], now, edge.side);
    if (seen == now) {
      return;
    }
    now = seen;
  }
}

// A triangle with two corners in one place is not a side of its edges: its normals belong to the triangles that it
// stitches together.
bool is_side(int half_edge) {
  int next = next_corner(half_edge);
  uvec4 from = cell_of(half_edge);
  uvec4 to = cell_of(next);
  uvec4 third = cell_of(next_corner(next));
  return from != to && to != third && third != from;
}

#if GLARK_CREASED
void insert_limits(int half_edge, int slot, uint side);
#endif

void insert_edge(int half_edge) {
  if (!is_side(half_edge)) {
    return;
  }
  int next = next_corner(half_edge);
  uvec4 from = cell_of(half_edge);
  uvec4 to = cell_of(next);
  bool falling = before(to, from);
  int low = falling ? next : half_edge;
  int high = falling ? half_edge : next;
  Edge edge = Edge(falling ? to : from, falling ? from : to, plane_of(low), plane_of(high), side_name(half_edge, falling));
  int slot = first_slot(hashed(hashed(0u, edge.low), edge.high), half_edge);
  uint taken = atomicCompSwap(tables[2 * slot], 0u, edge.side);
  while (taken != 0u && !is_edge_of(edge, taken)) {
    slot = next_slot(slot);
    taken = atomicCompSwap(tables[2 * slot], 0u, edge.side);
  }
  if (taken != 0u) {
    rank_side(2 * slot, edge, taken, -1);
  }
  rank_side(2 * slot + 1, edge, atomicCompSwap(tables[2 * slot + 1], 0u, edge.side), 1);
  if (turn_offset >= 0) {
    rank_turn(turn_table() + slot, edge);
  }
  tables[edge_slots() + half_edge] = uint(slot);
#if GLARK_CREASED
  insert_limits(half_edge, slot, edge.side);
#endif
}

// -1: no triangle with an area has this edge, so nothing is known of it. Call it after all insertions.
int slot_of(int half_edge) {
  if (is_side(half_edge)) {
    return int(tables[edge_slots() + half_edge]);
  }
  int next = next_corner(half_edge);
  uvec4 from = cell_of(half_edge);
  uvec4 to = cell_of(next);
  if (from == to) {
    return -1;
  }
  bool falling = before(to, from);
  Edge edge = Edge(falling ? to : from, falling ? from : to, uvec4(0u), uvec4(0u), side_name(half_edge, falling));
  int slot = first_slot(hashed(hashed(0u, edge.low), edge.high), half_edge);
  while (tables[2 * slot] != 0u) {
    if (is_edge_of(edge, tables[2 * slot])) {
      return slot;
    }
    slot = next_slot(slot);
  }
  return -1;
}

void insert_vertex(int corner) {
  uvec4 cell = cell_of(corner);
  int slot = first_slot(hashed(0u, cell), corner);
  for (;; slot = next_slot(slot)) {
    uint taken = atomicCompSwap(tables[vertex_table() + 2 * slot], 0u, uint(corner + 1));
    int other = int(taken) - 1;
    if (taken == 0u || (cell == cell_of(other) && same_key(corner, other))) {
      break;
    }
  }
  if (tag_offset >= 0) {
    float tag = uintBitsToFloat(word_of(corner, tag_offset));
    atomicMax(tables[vertex_table() + 2 * slot + 1], tag > 0.0 ? floatBitsToUint(tag) : 0u);
  }
  tables[vertex_slots() + corner] = uint(slot);
}

int slot_of_place(int corner) { return int(tables[vertex_slots() + corner]); }

#if GLARK_DISPLACED
#include "glark/core/weld/border.glsl"
#endif
#if GLARK_CREASED
#include "glark/core/weld/creases.glsl"
#endif

vec3 unit_of(uvec4 plane) { return glark_pn_unit(uintBitsToFloat(plane.xyz)); }

// 3 b210 where tangent planes a and b meet at `near`: in their common line if they differ, else in the plane. The sum
// of the unit normals is perpendicular to their difference, so both components are removed in turn. A short vector
// counts for less, because its direction means little. The shortest that counts in full is that of normals 20 degrees
// apart.
vec3 tangent(vec4 near, uvec4 a, uvec4 b, vec4 far) {
  const float shortest = 0.12;
  if (a == uvec4(0u)) {
    a = b;
  }
  if (b == uvec4(0u)) {
    b = a;
  }
  if (a == b) {
    return glark_pn_tangent(near, unit_of(a), far);
  }
  precise vec3 both = unit_of(a) + unit_of(b);
  precise vec3 apart = unit_of(a) - unit_of(b);
  precise vec3 along = near.w == far.w ? far.xyz - near.xyz : vec3(0.0);
  precise float in_both = dot(along, both) / max(dot(both, both), shortest);
  precise float in_apart = dot(along, apart) / max(dot(apart, apart), shortest);
  precise vec3 control = (2.0 * near.xyz + far.xyz) - (in_both * both + in_apart * apart);
  return control;
}

void write_control(int corner, int behind, vec3 control) {
  int to = record_offset + corner * corner_words + control_offset + behind;
  records[to] = floatBitsToUint(control.x);
  records[to + 1] = floatBitsToUint(control.y);
  records[to + 2] = floatBitsToUint(control.z);
}

void write_turn(int half_edge) {
  uint most = side_name(half_edge, false);
  int slot = slot_of(half_edge);
  if (slot >= 0) {
    most = tables[turn_table() + slot];
  }
  records[record_offset + half_edge * corner_words + turn_offset] = (most - 1u) >> 1;
}

// Every side computes both control points, from the same words in the same way: positions and normals are those of the
// least side.
void write_edge(int half_edge) {
  int next = next_corner(half_edge);
  uvec4 from = cell_of(half_edge);
  uvec4 to = cell_of(next);
  bool falling = before(to, from);
  uint least = side_name(half_edge, falling);
  uint greatest = least;
  int slot = slot_of(half_edge);
  if (slot >= 0) {
    least = tables[2 * slot];
    greatest = tables[2 * slot + 1];
  }
  for (int end = 0; end < 2; ++end) {
    bool high = end == 1;
    vec4 near = uintBitsToFloat(position_of(end_of_side(least, high)));
    vec4 far = uintBitsToFloat(position_of(end_of_side(least, !high)));
    uvec4 least_plane = slot < 0 ? uvec4(0u) : plane_of(end_of_side(least, high));  // straight
    uvec4 greatest_plane = slot < 0 ? uvec4(0u) : plane_of(end_of_side(greatest, high));
    int corner = high == falling ? half_edge : next;
#if GLARK_CREASED
    if (is_straight_at(corner)) {
      least_plane = greatest_plane = uvec4(0u);
    }
#endif
    vec3 control = tangent(near, least_plane, greatest_plane, far);
#if GLARK_CREASED
    if (slot >= 0) {
      control = limited(control, near, far, slot);
    }
#endif
    write_control(corner, high == falling ? 0 : 3, control);
  }
}

void write_tag(int corner) {
  records[record_offset + corner * corner_words + tag_offset] = tables[vertex_table() + 2 * slot_of_place(corner) + 1];
}

void clear(int slot) {
  if (joins_edges()) {
    tables[2 * slot] = 0u;
    tables[2 * slot + 1] = 0u;
  }
  if (turn_offset >= 0) {
    tables[turn_table() + slot] = 0u;
  }
  if (joins_vertices()) {
    tables[vertex_table() + 2 * slot] = 0u;
    tables[vertex_table() + 2 * slot + 1] = 0u;
  }
#if GLARK_DISPLACED
  for (int i = 0; border_offset >= 0 && i < 5; ++i) {
    tables[border_table() + 5 * slot + i] = 0u;
  }
#endif
#if GLARK_CREASED
  clear_limits(slot);
#endif
}

void insert(int corner) {
  if (joins_edges()) {
    insert_edge(corner);
  }
  if (joins_vertices()) {
    insert_vertex(corner);
  }
#if GLARK_DISPLACED
  if (border_offset >= 0) {
    insert_border(corner);
  }
#endif
}

void write(int corner) {
  if (control_offset >= 0) {
    write_edge(corner);
  }
  if (turn_offset >= 0) {
    write_turn(corner);
  }
#if GLARK_DISPLACED
  if (border_offset >= 0) {
    write_border(corner);
  }
#endif
  if (tag_offset >= 0) {
    write_tag(corner);
  }
}

void main() {
  bound = count_on_gpu != 0 ? min(triangle_bound, int(count_command[1])) : triangle_bound;
#if GLARK_PASS == 4
#if GLARK_CREASED
  for (int i = int(gl_LocalInvocationID.x); i < extent_words; i += GLARK_GROUP) {
    tables[extent_offset + i] = 0u;
  }
  memoryBarrierBuffer();
  barrier();
  for (int i = int(gl_LocalInvocationID.x); i < 3 * bound; i += GLARK_GROUP) {
    extend(i);
  }
#endif
  for (int i = int(gl_LocalInvocationID.x); i < slot_count; i += GLARK_GROUP) {
    clear(i);
  }
  memoryBarrierBuffer();
  barrier();
  find_cells();
  for (int i = int(gl_LocalInvocationID.x); i < 3 * bound; i += GLARK_GROUP) {
    insert(i);
  }
  memoryBarrierBuffer();
  barrier();
#if GLARK_CREASED
  for (int i = int(gl_LocalInvocationID.x); i < 3 * bound; i += GLARK_GROUP) {
    mark(i);
  }
  memoryBarrierBuffer();
  barrier();
#endif
  for (int i = int(gl_LocalInvocationID.x); i < 3 * bound; i += GLARK_GROUP) {
    write(i);
  }
#else
  int i = int(gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * uint(GLARK_GROUP));
#if GLARK_PASS == 0
  if (i < slot_count) {
    clear(i);
  }
#if GLARK_CREASED
  if (i < 3 * bound) {
    extend(i);
  }
#endif
#elif GLARK_PASS == 1
  find_cells();
  if (i < 3 * bound) {
    insert(i);
  }
#elif GLARK_PASS == 2
  find_cells();
  if (i < 3 * bound) {
    mark(i);
  }
#else
  find_cells();
  if (i < 3 * bound) {
    write(i);
  }
#endif
#endif
}
