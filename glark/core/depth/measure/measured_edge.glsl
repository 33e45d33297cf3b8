// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The measured depth, in steps, between two captured corners, for measure.glsl and ordered.glsl. Both declare
// `records`, `ends`, `corner_count()` and the uniforms.

uniform int turn_offset;  // in a corner; < 0: each side of an edge is measured by itself

vec4 position_of(int corner) {
  return uintBitsToFloat(uvec4(ends[4 * corner], ends[4 * corner + 1], ends[4 * corner + 2], ends[4 * corner + 3]));
}

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

int measured_steps(int a, int b) {
  int steps = pool_level * depth_steps;
  if (on_screen != 0) {
    steps = glark_steps_on_screen(position_of(a), position_of(b), half_size, pool_level);
  }
  if (normal_offset >= 0) {
    ivec2 side = side_that_turns_most(a, b);
    steps = min(steps, glark_steps_of_turn(normal_at(side.x, normal_offset), normal_at(side.y, normal_offset), depth_of(steps)));
  }
  return steps;
}
