// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Sorts the instances of a draw into bins by piece (counting sort). GLARK_PASS: 0 count, 1 scan, 2 scatter.
// The includer supplies #version and GLARK_PASS; for the passes 0 and 2 also GLARK_INTERIOR (pattern::Interior),
// GLARK_STEPS (edge_steps.glsl) and GLARK_PACKED_BITS.
// Based on: Boubekeur 2007, ch. 7.2.2-7.2.3 (edge depths select the pattern). The thesis draws triangle by triangle;
// the sort is ours.
#include "glark/core/pattern/pieces.glsl.h"

#if GLARK_PASS == 1
layout(local_size_x = 32) in;
const int scanners = 32;
#else
layout(local_size_x = 64) in;
#endif

layout(std430, binding = 0) readonly buffer Records { uint records[]; };
// Sorted by piece: the corners of instance_capacity coarse triangles (3 words each), then as many patches (4 words
// each).
layout(std430, binding = 1) writeonly buffer Instances { uint instances[]; };
// Words (uint):
//   0, 1     number of refined triangles, low and high word
//   2        refined triangles of this frame that count for the budget (measure.glsl)
//   3        flat triangles of this draw
//   4 to 8   the DrawElementsIndirectCommand of all instances
//   9 to 11  unused
// Then counts, cursors, pieces (4 words each:
// index count, first index, base vertex, 0) and the DrawElementsIndirectCommands of the pieces (5 words each). The passes
// write only how many instances a command has, and the first of them.
layout(std430, binding = 2) buffer Work { uint work[]; };
layout(std430, binding = 3) readonly buffer Count { uint count_command[]; };

const int all_instances = 4;
const int counts = 12;
const int cursors = counts + piece_count;
const int pieces = cursors + piece_count;
const int commands = pieces + 4 * piece_count;

uniform int record_offset;     // in words
uniform int corner_words;
uniform int tag_offset;        // in a corner; < 0: every tag is uniform_tag
uniform int uniform_tag;
uniform int triangle_bound;
uniform int count_on_gpu;
uniform int pool_level;
uniform int tags_are_edge_depths;  // corner k holds the depth of edge k
uniform int instance_capacity;
uniform int counted;  // the triangles count for the budget

#if GLARK_PASS == 1

shared uint wanted_by[scanners];  // instances of the pieces of each invocation
shared uint triangles_low;
shared uint triangles_high;

void add_triangles() {
  uint low = work[0] + triangles_low;
  work[1] += triangles_high + (low < work[0] ? 1u : 0u);
  work[0] = low;
  uint used = work[2] + (counted != 0 ? triangles_low : 0u);
  work[2] = used - min(used, work[3]);
  work[3] = 0u;
}

void main() {
  int self = int(gl_LocalInvocationID.x);
  int share = (piece_count + scanners - 1) / scanners;
  int first = share * self;
  int end = min(first + share, piece_count);
  uint wanted = 0u;
  for (int piece = first; piece < end; ++piece) {
    wanted += work[counts + piece];
  }
  wanted_by[self] = wanted;
  triangles_low = 0u;
  triangles_high = 0u;
  barrier();
  uint capacity = uint(instance_capacity);
  uint base = 0u;
  uint all = 0u;
  for (int i = 0; i < scanners; ++i) {
    base += i < self ? wanted_by[i] : 0u;
    all += wanted_by[i];
  }
  base = min(base, capacity);
  uint triangles = 0u;
  uint overflows = 0u;
  for (int piece = first; piece < end; ++piece) {
    uint count = min(work[counts + piece], capacity - base);
    work[counts + piece] = 0u;
    work[cursors + piece] = base;
    work[commands + 5 * piece + 1] = count;
    work[commands + 5 * piece + 4] = base;
    uint more = count * (work[pieces + 4 * piece] / 3u);
    triangles += more;
    overflows += triangles < more ? 1u : 0u;
    base += count;
  }
  uint low = atomicAdd(triangles_low, triangles);
  atomicAdd(triangles_high, overflows + (low + triangles < low ? 1u : 0u));
  barrier();
  if (self == 0) {
    work[all_instances] = 3u * min(all, capacity);
    work[all_instances + 1] = 1u;
    add_triangles();
  }
}

#else

#include "glark/core/depth/edge_steps.glsl"

const int interior = GLARK_INTERIOR;
const int packed_bits = GLARK_PACKED_BITS;  // > 0: records has a word per triangle, this many bits per edge, edge 0 lowest

int triangle;
ivec3 edge_steps;

int tag_of(int corner) {
  if (tag_offset < 0) {
    return uniform_tag * depth_steps;
  }
  return steps_of(records[record_offset + (3 * triangle + corner) * corner_words + tag_offset]);
}

void emit_instance(int piece, float ou, float ov, float s, float r) {
#if GLARK_PASS == 0
  atomicAdd(work[counts + piece], 1u);
#else
  int slot = int(atomicAdd(work[cursors + piece], 1u));
  if (slot >= instance_capacity) {
    return;
  }
  for (int corner = 0; corner < 3; ++corner) {
    instances[3 * slot + corner] = uint(3 * triangle + corner);
  }
  int to = 3 * instance_capacity + 4 * slot;
  uvec4 words = floatBitsToUint(placement_of(vec4(ou, ov, s, r), edge_steps));
  for (int i = 0; i < 4; ++i) {
    instances[to + i] = words[i];
  }
#endif
}

#define GLARK_EMIT(piece, ou, ov, s, r) emit_instance(piece, ou, ov, s, r)
#include "glark/core/pattern/expand.glsl.h"

void main() {
  int bound = triangle_bound;
  if (count_on_gpu != 0) {
    bound = min(bound, int(count_command[1]));
  }
  triangle = int(gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x);
  if (triangle >= bound) {
    return;
  }
  if (packed_bits > 0) {
    uint word = records[record_offset + triangle];
    uint mask = (1u << packed_bits) - 1u;
    edge_steps = ivec3(word & mask, (word >> packed_bits) & mask, (word >> (2 * packed_bits)) & mask);
#if GLARK_PASS == 0
    if (counted != 0 && word >= 0x80000000u) {
      atomicAdd(work[3], 1u);
    }
#endif
  } else {
    ivec3 tags = ivec3(tag_of(0), tag_of(1), tag_of(2));
    // Erratum 1: the mean of two tags may lie between two steps. Any rule that uses only the two ends is crack-free.
    edge_steps = tags_are_edge_depths != 0 ? tags : (tags + tags.yzx) >> 1;
  }
  expand_pattern(depth_of(edge_steps.x), depth_of(edge_steps.y), depth_of(edge_steps.z), interior);
}

#endif
