// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The measured depth, in steps, between two captured corners, for measure.glsl and ordered.glsl, which declare `records`, `ends` and the
// uniforms.

vec4 position_of(int corner) {
  return uintBitsToFloat(uvec4(ends[4 * corner], ends[4 * corner + 1], ends[4 * corner + 2], ends[4 * corner + 3]));
}

vec3 normal_of(int corner) {
  int word = record_offset + corner * corner_words + normal_offset;
  return uintBitsToFloat(uvec3(records[word], records[word + 1], records[word + 2]));
}

int measured_steps(int a, int b) {
  int steps = pool_level * depth_steps;
  if (on_screen != 0) {
    steps = glark_steps_on_screen(position_of(a), position_of(b), half_size, pool_level);
  }
  if (normal_offset >= 0) {
    steps = min(steps, glark_steps_of_turn(normal_of(a), normal_of(b), depth_of(steps)));
  }
  return steps;
}
