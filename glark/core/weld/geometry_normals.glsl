// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Makes corner normals from positions, for meshes without normals. The includer supplies #version and:
//   GLARK_PASS       0 clear the table, 1 link the corners at each position, 2 write the normals
//   GLARK_GROUP      size of a work group
//
// The normal of a corner is the mean of the faces around its position, weighted by their angles there. Only faces count
// that a fan of triangles joins to the corner's own one: neighbours share an edge and meet at no more than the crease
// angle. So the faces of a cube keep their own normals, and those of a ball join.
//
// The results do not depend on the order of the lists, to the bit: the fan is a set, and its sum is of whole numbers.
// Based on: G. Thuermer, C. Wuethrich, Computing Vertex Normals from Polygonal Facets, 1998 (the weights).
#define glark_precise precise
#define GLARK_DISPLACED 0
#define GLARK_CREASED 1
#include "glark/core/weld/tables.glsl"
#include "glark/core/weld/tangent.glsl"

layout(local_size_x = GLARK_GROUP) in;

uniform float least_cosine;  // of the normals of two faces: less is a crease

// The table has two words for each slot: a corner at the position, from 1, and the first corner of the list of all.
// Then come the slot of each corner, and the next corner of its list, from 1.
int list_of(int slot) { return 2 * slot + 1; }
int place_of(int corner) { return 2 * slot_count + corner; }
int next_in_list(int corner) { return 2 * slot_count + 3 * triangle_bound + corner; }

void clear(int slot) {
  tables[2 * slot] = 0u;
  tables[2 * slot + 1] = 0u;
}

void link(int corner) {
  uvec4 position = position_of(corner);
  int slot = first_slot(hashed(0u, position), corner);
  for (;; slot = next_slot(slot)) {
    uint taken = atomicCompSwap(tables[2 * slot], 0u, uint(corner + 1));
    int other = int(taken) - 1;
    if (taken == 0u || (position == position_of(other) && same_key(corner, other))) {
      break;
    }
  }
  tables[place_of(corner)] = uint(slot);
  tables[next_in_list(corner)] = atomicExchange(tables[list_of(slot)], uint(corner + 1));
}

vec3 point_of(int corner) { return uintBitsToFloat(position_of(corner).xyz); }

// The unit normal of the corner's face; zero if its corners are in one line. All corners of a face give the same bits.
vec3 face_normal(int corner) {
  int first = corner - corner % 3;
  vec3 from = point_of(first);
  vec3 a = glark_pn_unit(point_of(first + 1) - from);
  vec3 b = glark_pn_unit(point_of(first + 2) - from);
  vec3 normal = cross(a, b);
  return dot(normal, normal) > 1.0e-10 ? glark_pn_unit(normal) : vec3(0.0);
}

// The face's normal times its angle at the corner, in whole numbers.
ivec3 weighted_normal(int corner) {
  vec3 from = point_of(corner);
  vec3 a = glark_pn_unit(point_of(next_corner(corner)) - from);
  vec3 b = glark_pn_unit(point_of(next_corner(next_corner(corner))) - from);
  float angle = acos(clamp(dot(a, b), -1.0, 1.0));
  return ivec3(round(65536.0 * angle * face_normal(corner)));
}

// Two faces around one position share a second corner, and meet without a crease.
bool joins(int corner, int other) {
  uvec4 after = position_of(next_corner(corner));
  uvec4 before_it = position_of(next_corner(next_corner(corner)));
  uvec4 others_after = position_of(next_corner(other));
  uvec4 others_before = position_of(next_corner(next_corner(other)));
  bool share = after == others_before || before_it == others_after || after == others_after || before_it == others_before;
  return share && dot(face_normal(corner), face_normal(other)) > least_cosine;
}

// Sums the faces that a fan joins to the corner's own. `first`: of the list.
ivec3 sum_of_fan(int corner, uint first) {
  const int most_faces = 32;
  int faces[most_faces];
  int count = 0;
  uint members = 0u;
  for (uint next = first; next != 0u; next = tables[next_in_list(int(next) - 1)]) {
    faces[count] = int(next) - 1;
    members |= faces[count] == corner ? 1u << count : 0u;
    ++count;
  }
  uint before_it = 0u;
  while (members != before_it) {
    before_it = members;
    for (int i = 0; i < count; ++i) {
      for (int k = 0; k < count && (members & (1u << i)) == 0u; ++k) {
        if ((members & (1u << k)) != 0u && joins(faces[i], faces[k])) {
          members |= 1u << i;
        }
      }
    }
  }
  ivec3 sum = ivec3(0);
  for (int i = 0; i < count; ++i) {
    sum += (members & (1u << i)) != 0u ? weighted_normal(faces[i]) : ivec3(0);
  }
  return sum;
}

// Where many faces meet, as at the pole of a ball: all that are near to the corner's own one.
ivec3 sum_of_near_faces(int corner, uint first) {
  vec3 own = face_normal(corner);
  ivec3 sum = ivec3(0);
  for (uint next = first; next != 0u; next = tables[next_in_list(int(next) - 1)]) {
    int face = int(next) - 1;
    sum += face == corner || dot(own, face_normal(face)) > least_cosine ? weighted_normal(face) : ivec3(0);
  }
  return sum;
}

void write(int corner) {
  uint first = tables[list_of(int(tables[place_of(corner)]))];
  int count = 0;
  for (uint next = first; next != 0u; next = tables[next_in_list(int(next) - 1)]) {
    ++count;
  }
  ivec3 sum = count <= 32 ? sum_of_fan(corner, first) : sum_of_near_faces(corner, first);
  vec3 normal = face_normal(corner) == vec3(0.0) ? vec3(0.0) : glark_pn_unit(vec3(sum));
  int to = record_offset + corner * corner_words + normal_offset;
  records[to] = floatBitsToUint(normal.x);
  records[to + 1] = floatBitsToUint(normal.y);
  records[to + 2] = floatBitsToUint(normal.z);
}

void main() {
  int bound = count_on_gpu != 0 ? min(triangle_bound, int(count_command[1])) : triangle_bound;
  int i = int(gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * uint(GLARK_GROUP));
#if GLARK_PASS == 0
  if (i < slot_count) {
    clear(i);
  }
#elif GLARK_PASS == 1
  if (i < 3 * bound) {
    link(i);
  }
#else
  if (i < 3 * bound) {
    write(i);
  }
#endif
}
