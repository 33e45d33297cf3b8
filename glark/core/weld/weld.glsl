// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Joins coarse triangles by position. Hash tables find what the sides of an edge and the triangles about a vertex must
// share; the results go into the coarse records. The includer supplies #version and:
//   GLARK_PASS       0 clear the tables, 1 find the places of vertices, 2 join edges, 3 rank the turns of sides, 4 measure
//                    faces, 5 look beyond edges, 6 mark creases, 7 write. Passes 4 to 6 need GLARK_CREASED
//   GLARK_GROUP      size of a work group
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

int place_of(int corner) { return int(tables[vertex_slots() + corner]); }

// The tangent plane of the normal. Of the two opposite directions, it is the one whose first nonzero component is
// positive. Zero if the normal is zero or not finite.
uvec4 plane_of_normal(uvec3 words) {
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

uvec3 normal_words(int corner) {
  return uvec3(word_of(corner, normal_offset), word_of(corner, normal_offset + 1), word_of(corner, normal_offset + 2));
}

uvec4 plane_of(int corner) { return plane_of_normal(normal_words(corner)); }

vec3 normal_of(int corner) {
  int word = record_offset + corner * corner_words + normal_offset;
  return uintBitsToFloat(uvec3(records[word], records[word + 1], records[word + 2]));
}

uvec2 coordinate_of(int corner) { return uvec2(word_of(corner, coordinate_offset), word_of(corner, coordinate_offset + 1)); }

#include "glark/core/weld/edges.glsl"
#if GLARK_DISPLACED
#include "glark/core/weld/border.glsl"
#endif
#if GLARK_CREASED
#include "glark/core/weld/creases.glsl"
#endif

#if GLARK_PASS == 0
void clear(int slot) {
  for (int word = slot; word < edge_slots(); word += slot_count) {
    tables[word] = 0u;
  }
}
#elif GLARK_PASS == 1
// Corners are in one place if they have the same cell and the same key. A place is named by its slot.
void find_place(int corner) {
  int slot = -1;
  int next = first_slot(hash_of_cell(corner), corner);
  while (slot < 0) {
    uint taken = atomicCompSwap(tables[vertex_table() + 2 * next], 0u, uint(corner + 1));
    int other = int(taken) - 1;
    if (taken == 0u || (order_of_cells(corner, other) == 0 && same_key(corner, other))) {
      slot = next;
    }
    next = next_slot(next);
  }
  if (tag_offset >= 0) {
    float tag = uintBitsToFloat(word_of(corner, tag_offset));
    atomicMax(tables[vertex_table() + 2 * slot + 1], tag > 0.0 ? floatBitsToUint(tag) : 0u);
  }
  tables[vertex_slots() + corner] = uint(slot);
}
#elif GLARK_PASS == 7
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

void write_turn(int half_edge, int slot) {
  uint most = slot >= 0 ? tables[turn_table() + slot] : side_name(half_edge, false);
  records[record_offset + half_edge * corner_words + turn_offset] = (most - 1u) >> 1;
}

// Every side computes both control points, from the same words in the same way: positions and normals are those of the
// least side.
void write_edge(int half_edge, int slot) {
  bool falling = is_falling(half_edge);
  uint least = side_name(half_edge, falling);
  uint greatest = least;
  if (slot >= 0) {
    least = tables[2 * slot];
    greatest = tables[2 * slot + 1];
  }
  for (int end = 0; end < ends_of_edge; ++end) {
    bool high = end == 1;
    vec4 near = uintBitsToFloat(position_of(end_of_side(least, high)));
    vec4 far = uintBitsToFloat(position_of(end_of_side(least, !high)));
    uvec4 least_plane = plane_of(end_of_side(least, high));
    uvec4 greatest_plane = plane_of(end_of_side(greatest, high));
    int corner = high == falling ? half_edge : next_corner(half_edge);
    bool straight = slot < 0;
#if GLARK_CREASED
    straight = straight || is_straight_at(corner);
#endif
    if (straight) {
      least_plane = greatest_plane = uvec4(0u);
    }
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
  records[record_offset + corner * corner_words + tag_offset] = tables[vertex_table() + 2 * place_of(corner) + 1];
}

void write(int corner) {
  int slot = joins_edges() ? slot_of(corner) : -1;
  if (control_offset >= 0) {
    write_edge(corner, slot);
  }
  if (turn_offset >= 0) {
    write_turn(corner, slot);
  }
#if GLARK_DISPLACED
  if (border_offset >= 0) {
    write_border(corner, slot);
  }
#endif
  if (tag_offset >= 0) {
    write_tag(corner);
  }
}
#endif

void main() {
  int bound = count_on_gpu != 0 ? min(triangle_bound, int(count_command[1])) : triangle_bound;
  int i = int(gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * uint(GLARK_GROUP));
#if GLARK_PASS == 0
  if (i < slot_count) {
    clear(i);
  }
#endif
  if (i >= 3 * bound) {
    return;
  }
#if GLARK_PASS == 0 && GLARK_CREASED
  extend(i);
#elif GLARK_PASS == 1
  find_cells();
  find_place(i);
#elif GLARK_PASS == 2
  find_cells();
  join(i);
#if GLARK_DISPLACED
  if (border_offset >= 0) {
    insert_border(i);
  }
#endif
#elif GLARK_PASS == 3
  rank_turn(i);
#elif GLARK_PASS == 4
  measure_face(i);
#elif GLARK_PASS == 5
  look_beyond(i);
#elif GLARK_PASS == 6
  mark(i);
#elif GLARK_PASS == 7
  write(i);
#endif
}
