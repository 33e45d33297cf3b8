// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The values that displacement uses on edges and at corners. An edge gets the texture coordinates of its least side. A
// position gets its least texture coordinate and one normal. weld.glsl includes this file, declares the tables, and
// finds positions and edges.

int border_of(int corner) { return border_table() + 5 * place_of(corner); }

#if GLARK_PASS == 2
// The angle of the triangle at a corner; 0 without an area.
float angle_at(int corner) {
  int next = next_corner(corner);
  vec3 at = uintBitsToFloat(position_of(corner).xyz);
  vec3 a = glark_pn_unit(uintBitsToFloat(position_of(next).xyz) - at);
  vec3 b = glark_pn_unit(uintBitsToFloat(position_of(next_corner(next)).xyz) - at);
  float cosine = dot(a, b);
  return a != vec3(0.0) && b != vec3(0.0) && abs(cosine) <= 1.0 ? acos(cosine) : 0.0;
}

// Inserts a texture coordinate and a normal into the slot of the position. The slot keeps the least coordinate and the
// sum of the unit normals. Each normal is weighted by the angle of its triangle, in whole numbers, so that the order
// does not matter.
void insert_border(int corner) {
  int word = border_of(corner);
  uint own = uint(corner + 1);
  uint now = atomicCompSwap(tables[word], 0u, own);
  while (now != 0u && now != own && before(uvec4(coordinate_of(corner), 0u, 0u), uvec4(coordinate_of(int(now) - 1), 0u, 0u))) {
    uint seen = atomicCompSwap(tables[word], now, own);
    if (seen == now) {
      break;
    }
    now = seen;
  }
  int first = int(tables[vertex_table() + 2 * place_of(corner)]) - 1;
  if (normal_words(corner) != normal_words(first)) {
    atomicOr(tables[word + 1], 1u);
  }
  if (plane_of(corner) != uvec4(0u)) {
    ivec3 share = ivec3(round(65536.0 * angle_at(corner) * glark_pn_unit(normal_of(corner))));
    for (int i = 0; i < 3; ++i) {
      atomicAdd(tables[word + 2 + i], uint(share[i]));
    }
  }
}
#elif GLARK_PASS == 7
// The normal of a position: the common normal of all corners there, else the direction of their sum. Zero if the sum is
// almost zero.
vec3 normal_of_place(int corner) {
  int word = border_of(corner);
  if (tables[word + 1] == 0u) {
    return uintBitsToFloat(normal_words(corner));
  }
  ivec3 sum = ivec3(int(tables[word + 2]), int(tables[word + 3]), int(tables[word + 4]));
  return all(lessThan(abs(sum), ivec3(64))) ? vec3(0.0) : glark_pn_unit(vec3(sum));
}

void write_border(int half_edge, int slot) {
  int to = record_offset + half_edge * corner_words + border_offset;
  int next = next_corner(half_edge);
  uvec2 own = coordinate_of(int(tables[border_of(half_edge)]) - 1);
  uvec3 normal = floatBitsToUint(normal_of_place(half_edge));
  uvec2 near = own;
  uvec2 far = coordinate_of(int(tables[border_of(next)]) - 1);
  if (slot >= 0) {
    bool falling = is_falling(half_edge);
    near = coordinate_of(end_of_side(tables[2 * slot], falling));
    far = coordinate_of(end_of_side(tables[2 * slot], !falling));
  }
  uint words[9] = uint[9](normal.x, normal.y, normal.z, own.x, own.y, near.x, near.y, far.x, far.y);
  for (int i = 0; i < 9; ++i) {
    records[to + i] = words[i];
  }
}
#endif
