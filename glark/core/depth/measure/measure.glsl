// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Edge depths without tags. GLARK_PASS: 0 the limits of this frame, 1 the depths of the edges of one draw, 2 the edges
// of triangles that can be seen. The includer supplies #version, GLARK_PASS and, for the passes 1 and 2, what
// measured_edge.glsl needs.
//
// The limits: word 0 is the coarseness (float: how many depths the budget takes away). Then come for each depth a pixel
// limit and a cosine limit (edge_depth.glsl), and one error limit (screen_error.glsl). Then comes the rule that the limits
// follow, in the order of LimitRule (measure.cpp). Uniforms would not do: with zink (Mesa 22), this pass never sees that
// they change.
#if GLARK_PASS == 0

layout(local_size_x = 1) in;

layout(std430, binding = 0) buffer Limits { float limits[]; };
layout(std430, binding = 1) buffer Work { uint work[]; };  // bins.glsl; word 2 counts the triangles of the last frame

const int rule = 2 + 2 * GLARK_DEPTHS;

const float pi = 3.14159265;
// A fraction of the budget. If a frame uses fewer triangles, depths grow again. All edges may grow by one depth at
// once, which takes four times the triangles. A greater value would make the depths oscillate from frame to frame.
const float least_use = 0.25;
// A fraction of the budget. Beyond it, keeping the budget is more important than smooth changes. Edges that cross a
// depth all at once stay below it.
const float most_use = 4.0;

float next_coarseness(float coarseness, float use) {
  if (use > 1.0) {
    return coarseness + 0.5 * log2(use) + 0.125;  // a small margin: without it, reaching the budget takes many frames
  }
  return use < least_use ? coarseness + 0.5 * log2(max(2.0 * use, 0.015625)) : coarseness;
}

void main() {
  float pixels = limits[rule];
  float radians_of_turn = limits[rule + 1];
  float error = limits[rule + 2];  // in pixels
  float budget = limits[rule + 3];  // 0: none
  float most_change = limits[rule + 4];  // of the coarseness, from one frame to the next; 0: no limit
  bool restart = limits[rule + 5] != 0.0;
  float coarseness = 0.0;
  if (budget > 0.0 && !restart) {
    float use = float(work[2]) / budget;
    coarseness = next_coarseness(limits[0], use);
    if (most_change > 0.0 && use <= most_use) {
      coarseness = clamp(coarseness, limits[0] - most_change, limits[0] + most_change);
    }
    coarseness = clamp(coarseness, 0.0, float(GLARK_DEPTHS));
  }
  work[2] = 0u;
  limits[rule + 5] = 0.0;
  limits[0] = coarseness;
  for (int depth = 0; depth < GLARK_DEPTHS; ++depth) {
    float segments = exp2(float(depth) + coarseness);
    float longest = min(pixels * segments, 1e9);
    float cosine = cos(min(radians_of_turn * segments, pi));
    limits[1 + depth] = longest * longest;
    limits[1 + GLARK_DEPTHS + depth] = radians_of_turn * segments < pi ? cosine * abs(cosine) : -2.0;
  }
  float farthest = min(error * (4.0 / 3.0) * exp2(2.0 * coarseness), 1e9);
  limits[1 + 2 * GLARK_DEPTHS] = farthest * farthest;
}

#else

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Records { uint records[]; };
layout(std430, binding = 1) buffer Ends { uint ends[]; };  // gl_Position of each corner, then the words of MeasuredDepths
layout(std430, binding = 2) readonly buffer Limits { float limits[]; };

uniform int record_offset;  // in words
uniform int corner_words;
uniform int first_depth;    // word of `ends`
uniform int triangle_bound;
uniform int pool_level;
uniform vec2 half_size;
#if GLARK_CURVES
uniform int shown_stamp;
// For each edge: the stamp of the last draw that showed it, and below it the steps for the inside of its triangles.
layout(std430, binding = 3) buffer Shown { uint shown[]; };

const int step_bits = 10;

void show_edge(int first, int steps) { atomicMax(shown[first], (uint(shown_stamp) << step_bits) + uint(steps)); }
int shown_steps(int first) {
  uint word = shown[first];
  return word >> step_bits == uint(shown_stamp) ? int(word & ((1u << step_bits) - 1u)) : -1;
}
#endif

const int packed_bits = GLARK_STEPS == 1 ? 4 : 10;

int corner_count() { return 3 * triangle_bound; }
int loop_bound(int count) { return min(count, corner_count() * count); }  // is `count`, but not a constant

#include "glark/core/depth/edge_steps.glsl"
#include "glark/core/depth/measure/limits.glsl"
#include "glark/core/depth/measure/edge_depth.glsl"
#include "glark/core/depth/measure/measured_edge.glsl"
#include "glark/core/depth/measure/straight_edge.glsl"

void main() {
  int triangle = int(gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x);
  if (triangle >= triangle_bound) {
    return;
  }
#if GLARK_PASS == 2
  if (shown_stamp == 0) {  // the stamps begin again
    shown[3 * triangle] = shown[3 * triangle + 1] = shown[3 * triangle + 2] = 0u;
    return;
  }
  show_edges(triangle);
#else
  uint depths = 0u;
  bool is_flat = true;
  for (int edge = 0; edge < loop_bound(3); ++edge) {
    int from = 3 * triangle + edge;
    int to = 3 * triangle + (edge == 2 ? 0 : edge + 1);
    if (!is_straight(from, to)) {
      is_flat = false;
      depths |= uint(measured_steps(from, to)) << (packed_bits * edge);
    }
  }
  ends[first_depth + triangle] = depths | (is_flat ? 0x80000000u : 0u);
#endif
}

#endif
