// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Computes the depth of an edge from the distance between its curve and its chord on the screen. Include after
// edge_depth.glsl, whose rules hold here too: only sums and products of `precise` values, the same bits when the ends
// change places.
//
// The curve is known at its quarter points. A cubic through them leaves the chord by 3 t (1 - t) ((1 - t) d0 + t d1).
// With d0 = even + odd and d1 = even - odd, a cut into 2^depth segments leaves at most
//   3/4 |even +- share odd| / 4^depth
// between the curve and its segments. An S-shaped curve meets its chord in the middle, so `share` matters there: it
// grows from 1.2 to 3, because the end segments of a fine cut bend most.
// Based on: G. Wang, The subdivision method for finding the intersection between two Bezier curves or surfaces, 1984:
// the bound by second differences, which is `share` 3. A lesser share at the first depths saves segments.
//
// The includer declares the limit that measure.glsl makes:
//   float error_limit()  square of 4/3 times the error, in pixels

// The distances of a curve from its chord, as seen from one place. A distance squared is
// products.x + share^2 products.y + share products.z, in units of `unit`.
struct glark_Bend {
  vec3 screen;
  float screen_unit;
  vec3 angle;
  float angle_unit;
  bool in_front;
};

float glark_bend_square(vec3 products, float share) {
  precise float sum = (products.x + (share * share) * products.y) + share * products.z;
  return sum;
}

vec3 glark_bend_products(vec3 even, vec3 odd) {
  precise vec3 products = vec3(glark_square(even), glark_square(odd), 2.0 * abs(glark_dot(even, odd)));
  return products;
}

vec3 glark_across(vec3 along, vec3 place) {
  precise vec3 across = along.yzx * place.zxy - along.zxy * place.yzx;
  return across;
}

// The eye is the origin of (x, y, w).
glark_Bend glark_bend_at(vec3 place, vec3 even, vec3 odd, float eye_distance, bool in_front) {
  vec3 even_across = glark_across(even, place);
  vec3 odd_across = glark_across(odd, place);
  precise float squared_distance = eye_distance * eye_distance;
  precise float depth_squared = place.z * place.z;
  precise float square = glark_square(place);
  glark_Bend bend;
  precise vec3 screen = squared_distance * glark_bend_products(vec3(even_across.xy, 0.0), vec3(odd_across.xy, 0.0));
  precise float screen_unit = depth_squared * depth_squared;
  precise vec3 angle = (in_front ? 9.0 : 1.0) * squared_distance * glark_bend_products(even_across, odd_across);
  precise float angle_unit = square * square;
  bend.screen = screen;
  bend.screen_unit = screen_unit;
  bend.angle = angle;
  bend.angle_unit = angle_unit;
  bend.in_front = in_front;
  return bend;
}

bool glark_bend_fits(glark_Bend bend, float limit, float share) {
  vec2 sizes = vec2(glark_bend_square(bend.angle, share), glark_bend_square(bend.screen, share));
  return glark_fits(bvec2(true, bend.in_front), sizes, vec2(bend.angle_unit, bend.screen_unit), limit);
}

// `length`: of a segment, as a part of the edge.
float glark_odd_share(float length) {
  precise float share = 3.0 - 1.8 * length;
  return share;
}

// Returns `steps`, or more if the curve needs more. With one step per level, the first check at each depth is the last.
int glark_steps_of_bend(int steps, glark_Bend bend, int deepest) {
  int depth = depth_of(steps);
  float length = 1.0;
  float limit = error_limit();
  for (int i = 0; i < depth; ++i) {
    limit *= 16.0;
    length *= 0.5;
  }
  if (glark_bend_fits(bend, limit, glark_odd_share(length)) && steps == depth * depth_steps) {
    return steps;
  }
  while (depth < deepest && !glark_bend_fits(bend, limit, glark_odd_share(length))) {
    ++depth;
    length *= 0.5;
    limit *= 16.0;
  }
  if (depth_steps == 1 || depth == 0) {
    return max(steps, depth * depth_steps);
  }
  float coarse_limit = limit * 0.0625;
  float coarse_share = glark_odd_share(2.0 * length);
  int too_few = 0;
  int enough = depth_steps;
  while (enough - too_few > 1) {
    int middle = (enough + too_few) / 2;
    if (glark_bend_fits(bend, glark_limit_between(coarse_limit, limit, middle),
                        glark_limit_between(coarse_share, glark_odd_share(length), middle))) {
      enough = middle;
    } else {
      too_few = middle;
    }
  }
  return max(steps, (depth - 1) * depth_steps + enough);
}

// A curve in the space of glark_steps_on_screen. The quarter points lie next to the ends of the same names.
struct glark_Curve {
  vec3 a;
  vec3 b;
  vec3 quarter_a;
  vec3 quarter_b;
  vec3 middle;  // only if has_middle: the curve is no cubic
  bool has_middle;
};

int glark_steps_of_curve(glark_Curve curve, float eye_distance, int deepest) {
  precise vec3 near_a = curve.quarter_a - (0.75 * curve.a + 0.25 * curve.b);
  precise vec3 near_b = curve.quarter_b - (0.75 * curve.b + 0.25 * curve.a);
  precise vec3 even = (8.0 / 9.0) * (near_a + near_b);
  precise vec3 odd = (16.0 / 9.0) * (near_a - near_b);
  precise vec3 even_in_middle = (4.0 / 3.0) * (curve.middle - 0.5 * (curve.a + curve.b));
  bool in_front = curve.a.z > 0.0 && curve.b.z > 0.0 && curve.quarter_a.z > 0.0 && curve.quarter_b.z > 0.0;
  // At both ends; with a middle, at both ends again; behind the eye, where the curve may be nearer to the eye than its
  // ends, at both quarters. One loop, so that compilers have one copy of the search.
  int first_quarters = curve.has_middle ? 4 : 2;
  int places = in_front ? first_quarters : first_quarters + 2;
  int steps = 0;
  for (int i = 0; i < places; ++i) {
    bool at_quarter = i >= first_quarters;
    bool at_middle = i >= 2 && !at_quarter;
    bool second = (i & 1) == 1;
    vec3 end = second ? curve.b : curve.a;
    vec3 quarter = second ? curve.quarter_b : curve.quarter_a;
    steps = glark_steps_of_bend(steps, glark_bend_at(at_quarter ? quarter : end, at_middle ? even_in_middle : even, odd,
                                                     eye_distance, in_front), deepest);
  }
  return steps;
}
