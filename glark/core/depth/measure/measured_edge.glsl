// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The measured depth, in steps, between two captured corners, for measure.glsl and ordered.glsl. Both declare
// `records`, `ends`, `corner_count()`, `loop_bound()` and the uniforms. Loops take their bounds from loop_bound(): compilers
// would unroll loops with constant ones, and the user waits for them. They supply, each 0 or 1:
//   GLARK_CURVES   curves are measured
//   GLARK_LENGTHS  the lengths of edges on the screen are measured
//   GLARK_NORMALS  the angles between normals are measured
//   GLARK_STRAIGHT straight edges have depth 0
// Processors that run both sides of a branch would pay for what is not measured, so each set has its own program.
// With GLARK_CURVES, they also supply GLARK_POINTS (of each triangle), and declare
//   void show_edge(int first, int steps)  called for each edge of a triangle that can be seen; `first` names the edge,
//                                         and the inside of the triangle needs `steps`
//   int shown_steps(int first)            after all calls of show_edge(): the most steps; -1: nobody sees the edge

#if GLARK_NORMALS
uniform int normal_offset;  // in a corner
#endif
uniform int turn_offset;  // in a corner; < 0: each side of an edge is measured by itself

#if GLARK_CURVES
#include "glark/core/depth/measure/screen_error.glsl"
#include "glark/core/depth/measure/curve_points.glsl"
#include "glark/core/depth/measure/hidden_triangle.glsl"
#else
vec4 position_of(int corner) {
  return uintBitsToFloat(uvec4(ends[4 * corner], ends[4 * corner + 1], ends[4 * corner + 2], ends[4 * corner + 3]));
}
#endif

vec3 normal_at(int corner, int offset) {
  int word = record_offset + corner * corner_words + offset;
  return uintBitsToFloat(uvec3(records[word], records[word + 1], records[word + 2]));
}

// Returns the side of the edge from `begin` to `end` that is measured, as the corners where this side begins and ends.
ivec2 side_that_turns_most(int begin, int end) {
  if (turn_offset < 0) {
    return ivec2(begin, end);
  }
  uint from = records[record_offset + begin * corner_words + turn_offset];
  if (from >= uint(corner_count())) {
    return ivec2(begin, end);  // beyond the triangles that the GPU counted
  }
  int first = int(from);
  return ivec2(first, first % 3 == 2 ? first - 2 : first + 1);
}

#if GLARK_CURVES
void show_edges(int triangle) {
  if (is_hidden(triangle)) {
    return;
  }
  int steps = steps_of_inside(triangle, half_size, pool_level);
  for (int edge = 0; edge < loop_bound(3); ++edge) {
    int from = 3 * triangle + edge;
    show_edge(side_that_turns_most(from, 3 * triangle + (edge == 2 ? 0 : edge + 1)).x, steps);
  }
}
#endif

int measured_steps(int a, int b) {
  int steps = pool_level * depth_steps;
#if GLARK_CURVES
  int inside = turn_offset >= 0 ? shown_steps(side_that_turns_most(a, b).x) : 0;
  if (inside < 0) {
    return 0;
  }
  steps = max(inside, steps_by_error(a, b, half_size, pool_level));
#endif
#if GLARK_LENGTHS
  steps = min(steps, glark_steps_on_screen(position_of(a), position_of(b), half_size, depth_of(steps)));
#endif
#if GLARK_NORMALS
  ivec2 side = side_that_turns_most(a, b);
  steps = min(steps, glark_steps_of_turn(normal_at(side.x, normal_offset), normal_at(side.y, normal_offset), depth_of(steps)));
#endif
  return steps;
}
