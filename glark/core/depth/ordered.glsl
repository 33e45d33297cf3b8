// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Computes edge depths, instances and commands of a draw of few triangles in one work group. The order of the triangles
// is kept: each triangle has an invocation, each instance a command.
// The includer supplies #version, GLARK_DEPTHS, GLARK_GROUP (size of the work group), GLARK_TRIANGLES (greatest size of
// a work group), GLARK_INSTANCES (most instances of one triangle), GLARK_TAGS (1: nothing is measured, vertices have
// tags), and what measured_edge.glsl needs.
#include "glark/core/pattern/pieces.glsl.h"

layout(local_size_x = GLARK_GROUP) in;

layout(std430, binding = 0) readonly buffer Records { uint records[]; };
// First DrawElementsIndirectCommands (5 words each), then patches (4 words each), then records. There is room for
// GLARK_TRIANGLES * GLARK_INSTANCES instances.
layout(std430, binding = 1) writeonly buffer Output { uint result[]; };
layout(std430, binding = 2) buffer Work { uint work[]; };           // see bins.glsl
layout(std430, binding = 3) readonly buffer Ends { uint ends[]; };  // see measure.glsl
layout(std430, binding = 4) readonly buffer Limits { float limits[]; };

const int pieces = 12 + 2 * piece_count;
const int patches = 5 * GLARK_TRIANGLES * GLARK_INSTANCES;
const int moved_records = patches + 4 * GLARK_TRIANGLES * GLARK_INSTANCES;

uniform int record_offset;  // in words
uniform int corner_words;
uniform int tag_offset;  // in a corner
uniform int tags_are_edge_depths;
uniform int triangle_count;
uniform int pool_level;
uniform int counted;  // the triangles count for the budget
uniform vec2 half_size;
#if GLARK_CURVES
shared uint shown[3 * GLARK_GROUP];  // by edge: 0, or 1 and the steps for the inside of its triangles

void show_edge(int first, int steps) { atomicMax(shown[first], uint(1 + steps)); }
int shown_steps(int first) { return int(shown[first]) - 1; }
#endif

int corner_count() { return 3 * triangle_count; }
int loop_bound(int count) { return min(count, corner_count() * count); }  // is `count`, but not a constant

#include "glark/core/depth/edge_steps.glsl"
#if !GLARK_TAGS
#include "glark/core/depth/measure/limits.glsl"
#include "glark/core/depth/measure/edge_depth.glsl"
#include "glark/core/depth/measure/measured_edge.glsl"
#include "glark/core/depth/measure/straight_edge.glsl"
#endif

shared uint instance_count[GLARK_GROUP];
shared uint refined_triangles;
shared uint budget_triangles;

int emitted = 0;
bool is_flat = false;  // BudgetPlan
ivec3 edge_steps;
int emitted_piece[GLARK_INSTANCES];
vec4 emitted_patch[GLARK_INSTANCES];

void emit_instance(int piece, float ou, float ov, float s, float r) {
  if (emitted < GLARK_INSTANCES) {
    emitted_piece[emitted] = piece;
    emitted_patch[emitted] = placement_of(vec4(ou, ov, s, r), edge_steps);
    ++emitted;
  }
}

#define GLARK_EMIT(piece, ou, ov, s, r) emit_instance(piece, ou, ov, s, r)
#include "glark/core/pattern/expand.glsl.h"

int tag_of(int corner) {
  return steps_of(records[record_offset + corner * corner_words + tag_offset]);
}

void expand(int triangle) {
  for (int edge = 0; edge < loop_bound(3); ++edge) {
    int from = 3 * triangle + edge;
    int to = 3 * triangle + (edge == 2 ? 0 : edge + 1);
#if GLARK_TAGS
    edge_steps[edge] = tags_are_edge_depths != 0 ? tag_of(from) : (tag_of(from) + tag_of(to)) >> 1;
#else
    bool straight = is_straight(from, to);
    edge_steps[edge] = straight ? 0 : measured_steps(from, to);
    is_flat = straight && (is_flat || edge == 0);
#endif
  }
  expand_pattern(depth_of(edge_steps.x), depth_of(edge_steps.y), depth_of(edge_steps.z),
                 depth_steps == 1 ? 0 : morphing_interior);
}

void write_instance(int triangle, int slot, int piece, vec4 placement) {
  uint index_count = work[pieces + 4 * piece];
  result[5 * slot] = index_count;
  result[5 * slot + 1] = 1u;
  result[5 * slot + 2] = work[pieces + 4 * piece + 1];
  result[5 * slot + 3] = work[pieces + 4 * piece + 2];
  result[5 * slot + 4] = uint(slot);
  uvec4 words = floatBitsToUint(placement);
  for (int i = 0; i < 4; ++i) {
    result[patches + 4 * slot + i] = words[i];
  }
  int size = 3 * corner_words;
  for (int i = 0; i < size; ++i) {
    result[moved_records + slot * size + i] = records[record_offset + triangle * size + i];
  }
  atomicAdd(refined_triangles, index_count / 3u);
  atomicAdd(budget_triangles, counted != 0 && !is_flat ? index_count / 3u : 0u);
}

void main() {
  int triangle = int(gl_LocalInvocationID.x);
  if (triangle == 0) {
    refined_triangles = 0u;
    budget_triangles = 0u;
  }
#if GLARK_CURVES
  for (int edge = 0; edge < 3; ++edge) {
    shown[3 * triangle + edge] = 0u;
  }
  barrier();
  if (triangle < triangle_count) {
    show_edges(triangle);
  }
  barrier();
#endif
  if (triangle < triangle_count) {
    expand(triangle);
  }
  instance_count[triangle] = uint(emitted);
  barrier();
  int first = 0;
  int all = 0;
  for (int i = 0; i < triangle_count; ++i) {
    first += i < triangle ? int(instance_count[i]) : 0;
    all += int(instance_count[i]);
  }
  for (int i = 0; i < emitted; ++i) {
    write_instance(triangle, first + i, emitted_piece[i], emitted_patch[i]);
  }
  // Only the GPU knows the number of commands, so the unused commands draw nothing.
  for (int slot = all + triangle; slot < GLARK_INSTANCES * triangle_count; slot += GLARK_GROUP) {
    for (int i = 0; i < 5; ++i) {
      result[5 * slot + i] = 0u;
    }
  }
  barrier();
  if (triangle == 0) {
    uint low = work[0] + refined_triangles;
    work[1] += low < work[0] ? 1u : 0u;
    work[0] = low;
    work[2] += budget_triangles;
  }
}
