// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The coarse records and the hash tables of welding: what a corner holds, which slot a content gets, and how a side of
// an edge is named. weld.glsl and geometry_normals.glsl include this file.
//
// These shaders must compile fast, because the user waits for them. When the compiler inlines functions and unrolls
// loops, its time grows faster than the number of buffer accesses. So what is read for two corners or two ends is read
// in a loop, and the compiler cannot unroll it because its bound is not a constant.

layout(std430, binding = 0) buffer Records { uint records[]; };
// First come the parts that begin with 0, where they are needed:
//   for each slot of edges: least and greatest side (0: empty)
//   for each slot of vertices: a corner, from 1; the bits of the greatest tag, or 1 if the edges are straight there
//   for each slot of edges: the side that turns most
//   for each slot of vertices, 5 words for displacement: the corner, from 1, with the least texture coordinate; 1 if the
//   normals differ; their sum in fixed point
//   for each slot of edges: the first side of the list of its sides; the inverted bits of the least height
// Then come the slot of each half-edge (edges.glsl), the slot of each corner, and the next side in the list of each
// half-edge.
layout(std430, binding = 1) coherent buffer Tables { uint tables[]; };
layout(std430, binding = 2) readonly buffer Count { uint count_command[]; };

uniform int record_offset;  // in words
uniform int corner_words;
uniform int triangle_bound;
uniform int count_on_gpu;
uniform int position_offset;
uniform int position_words;
uniform int normal_offset;
uniform int control_offset;  // in a corner; < 0: the edges have no control points
uniform int turn_offset;     // in a corner; < 0: the turns of the sides are not measured
#if GLARK_DISPLACED
uniform int border_offset;  // in a corner; < 0: nothing is displaced
#else
const int border_offset = -1;
#endif
uniform int coordinate_offset;
#if GLARK_CREASED
const int tag_offset = -1;
#else
uniform int tag_offset;  // in a corner; < 0: the tags are not welded
#endif
uniform int slot_count;  // of either table
uniform int key_count;
uniform int key_offset;  // in the tables: words of a corner. Vertices with different values there are never welded
uniform int ends_of_edge;                // 2
uniform int corners_of_triangle;         // 3

uint word_of(int corner, int word) {
  uint value = records[record_offset + corner * corner_words + word];
  return value == 0x80000000u ? 0u : value;  // zero has one sign
}

uvec4 position_of(int corner) {
  uint w = position_words > 3 ? word_of(corner, position_offset + 3) : floatBitsToUint(1.0);
  return uvec4(word_of(corner, position_offset), word_of(corner, position_offset + 1), word_of(corner, position_offset + 2), w);
}

bool same_key(int a, int b) {
  for (int i = 0; i < key_count; ++i) {
    int word = int(tables[key_offset + i]);
    if (word_of(a, word) != word_of(b, word)) {
      return false;
    }
  }
  return true;
}

uint hashed(uint hash, uint word) {
  word *= 0xcc9e2d51u;
  word = (word << 15) | (word >> 17);
  hash ^= word * 0x1b873593u;
  hash = (hash << 13) | (hash >> 19);
  return hash * 5u + 0xe6546b64u;
}

uint hashed(uint hash, uvec4 words) { return hashed(hashed(hashed(hashed(hash, words.x), words.y), words.z), words.w); }

int slot_for(uint hash) {
  hash = (hash ^ (hash >> 16)) * 0x85ebca6bu;
  hash = (hash ^ (hash >> 13)) * 0xc2b2ae35u;
  uint slot;
  uint rest;
  umulExtended(hash ^ (hash >> 16), uint(slot_count), slot, rest);
  return int(slot);
}

int first_slot(uint hash, int corner) {
  for (int i = 0; i < key_count; ++i) {
    hash = hashed(hash, word_of(corner, int(tables[key_offset + i])));
  }
  return slot_for(hash);
}

int next_slot(int slot) { return slot + 1 < slot_count ? slot + 1 : 0; }

// Lexicographic order.
bool before(uvec4 a, uvec4 b) {
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z != b.z ? a.z < b.z : a.w < b.w;
}

bool joins_edges() { return control_offset >= 0 || turn_offset >= 0 || border_offset >= 0; }
int vertex_table() { return joins_edges() ? 2 * slot_count : 0; }
int turn_table() { return vertex_table() + 2 * slot_count; }
int border_table() { return turn_table() + (turn_offset >= 0 ? slot_count : 0); }
int crease_table() { return border_table() + (border_offset >= 0 ? 5 * slot_count : 0); }
int edge_slots() { return crease_table() + (GLARK_CREASED == 1 ? 2 * slot_count : 0); }  // the parts before it are cleared
int vertex_slots() { return edge_slots() + (joins_edges() ? 3 * triangle_bound : 0); }
int side_list() { return vertex_slots() + 3 * triangle_bound; }

// A side of an edge is named by its half-edge (the number of the corner where it begins), and by whether this corner is
// the higher end. All sides have the lower end first.
int next_corner(int corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
uint side_name(int half_edge, bool falling) { return uint(2 * half_edge) + (falling ? 2u : 1u); }
int end_of_side(uint side, bool high) {
  int half_edge = int(side - 1u) >> 1;
  bool begin = ((side - 1u) & 1u) == (high ? 1u : 0u);
  return begin ? half_edge : next_corner(half_edge);
}
