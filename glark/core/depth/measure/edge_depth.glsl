// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Computes the depth of an edge from its two ends. For GLSL 4.30 and ES 3.20.
//
// Watertight: every expression gives the same bits when the ends change places, in every program that includes this
// file. So it uses only sums and products of `precise` values: no division, no root, no function that compilers may
// approximate in different ways.
//
// Steps divide the interval between the limits of two levels linearly. The includer has edge_steps.glsl, and declares,
// before the #include, the table that measure.glsl makes:
//   float pixel_limit(int depth)   square of the length that 2^depth segments may cover, in pixels
//   float cosine_limit(int depth)  c |c|, c the cosine of the angle that 2^depth segments may cover

// The power of two that brings `largest` into 1..2, for finite numbers that are not tiny.
float glark_scale_of(float largest) {
  uint exponent = (floatBitsToUint(largest) >> 23) & 255u;
  return exponent > 0u && exponent < 254u ? uintBitsToFloat((254u - exponent) << 23) : 1.0;
}

float glark_largest(vec3 v) { return max(max(abs(v.x), abs(v.y)), abs(v.z)); }

float glark_square(vec3 v) {
  precise float sum = (v.x * v.x + v.y * v.y) + v.z * v.z;
  return sum;
}

float glark_dot(vec3 a, vec3 b) {
  precise float sum = (a.x * b.x + a.y * b.y) + a.z * b.z;
  return sum;
}

// The limit of a depth in steps, for 1 step and more.
float glark_limit_between(float coarse, float fine, int step) {
  precise float limit = coarse + (fine - coarse) * (float(step) / float(depth_steps));
  return limit;
}

// Returns whether one of the counted sizes (squared, in their units) is within the limit.
bool glark_fits(bvec2 counts, vec2 sizes, vec2 units, float limit) {
  precise vec2 longest = limit * units;
  return (counts.x && !(sizes.x > longest.x)) || (counts.y && !(sizes.y > longest.y));
}

// Ends are in clip coordinates; half_size is half of the viewport, in pixels.
// If both ends lie in front of the eye, the size is the lesser of the length on the screen and three times the length
// as an angle. The angle is the lesser one only far outside of the screen.
// If an end lies behind the eye, there is no length on the screen, and only the angle is used. The eye is the origin of
// (x, y, w).
int glark_steps_on_screen(vec4 end_a, vec4 end_b, vec2 half_size, int deepest) {
  float eye_distance = max(half_size.x, half_size.y);  // of the screen, in pixels, for a view of 90 degrees
  precise vec3 a = end_a.xyw * vec3(half_size, eye_distance);
  precise vec3 b = end_b.xyw * vec3(half_size, eye_distance);
  float scale = glark_scale_of(max(glark_largest(a), glark_largest(b)));
  a = a * scale;
  b = b * scale;
  precise vec3 along = b - a;
  precise vec3 across = a.yzx * b.zxy - a.zxy * b.yzx;
  precise float squared_distance = eye_distance * eye_distance;
  precise float depths = a.z * b.z;
  precise float screen_length = squared_distance * (across.x * across.x + across.y * across.y);
  precise float screen_unit = depths * depths;
  // The point of the edge nearest to the eye lies within the edge, or it is an end.
  precise float length_squared = glark_square(along);
  bool within = glark_dot(a, along) < 0.0 && glark_dot(b, along) > 0.0;
  precise float angle = squared_distance * (within ? length_squared * length_squared : length_squared);
  precise float angle_unit = within ? glark_square(across) : min(glark_square(a), glark_square(b));
  bool in_front = a.z > 0.0 && b.z > 0.0;
  precise float tolerant_angle = in_front ? 9.0 * angle : angle;
  bvec2 counts = bvec2(true, in_front);
  vec2 sizes = vec2(tolerant_angle, screen_length);
  vec2 units = vec2(angle_unit, screen_unit);
  int depth = 0;
  while (depth < deepest && !glark_fits(counts, sizes, units, pixel_limit(depth))) {
    ++depth;
  }
  if (depth_steps == 1 || depth == 0) {
    return depth * depth_steps;
  }
  int too_few = 0;
  int steps = depth_steps;
  while (steps - too_few > 1) {
    int middle = (steps + too_few) / 2;
    float limit = glark_limit_between(pixel_limit(depth - 1), pixel_limit(depth), middle);
    if (glark_fits(counts, sizes, units, limit)) {
      steps = middle;
    } else {
      too_few = middle;
    }
  }
  return (depth - 1) * depth_steps + steps;
}

bool glark_turns_more(float signed_square, float unit, float limit) {
  precise float least = limit * unit;
  return signed_square < least;
}

int glark_steps_of_turn(vec3 normal_a, vec3 normal_b, int deepest) {
  precise vec3 a = normal_a * glark_scale_of(glark_largest(normal_a));
  precise vec3 b = normal_b * glark_scale_of(glark_largest(normal_b));
  precise float cosine = glark_dot(a, b);
  precise float signed_square = cosine * abs(cosine);
  precise float unit = glark_square(a) * glark_square(b);
  int depth = 0;
  while (depth < deepest && glark_turns_more(signed_square, unit, cosine_limit(depth))) {
    ++depth;
  }
  if (depth_steps == 1 || depth == 0) {
    return depth * depth_steps;
  }
  int too_few = 0;
  int steps = depth_steps;
  while (steps - too_few > 1) {
    int middle = (steps + too_few) / 2;
    float limit = glark_limit_between(cosine_limit(depth - 1), cosine_limit(depth), middle);
    if (glark_turns_more(signed_square, unit, limit)) {
      too_few = middle;
    } else {
      steps = middle;
    }
  }
  return (depth - 1) * depth_steps + steps;
}
