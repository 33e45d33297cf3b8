// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Depths in steps: whole levels, or morph_steps per level if refined vertices move between levels. The includer has
// pieces.glsl.h and `pool_level`, and supplies GLARK_STEPS.

const int depth_steps = GLARK_STEPS;  // per level

// `word`: the bits of a tag. Not-a-number gives 0. Compilers may assume that a float is a number, so its bits tell.
int steps_of(uint word) {
  if (int(word) <= 0 || word > 0x7f800000u) return 0;
  float tag = uintBitsToFloat(word);
  float steps = min(tag * float(depth_steps), float(pool_level * depth_steps));
  float whole = floor(steps);  // steps + 0.5 would round values just below a half up to 1
  return int(whole) + (steps - whole >= 0.5 ? 1 : 0);
}

int depth_of(int steps) { return (steps + depth_steps - 1) / depth_steps; }

// The placement of a piece. If vertices move, it also holds the steps of the three edges (docs/explanation/depths.md,
// Geomorphing).
vec4 placement_of(vec4 placed, ivec3 steps) {
  if (depth_steps == 1) {
    return placed;
  }
  vec3 added = vec3(steps);
  return vec4(64.0 * placed.xy + 128.0 * added.xy, placed.z, placed.w + 4.0 * added.z);
}
