// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The points of refined triangles that the point program writes to `ends` (positions.h). Point by point: first that
// point of all triangles. Vertices come in threes, so the last one or two triangles follow behind.
//
// Points of a triangle: its corners; the points at 1/4 and 3/4 of edge 0, then of edges 1 and 2; the centre; if there
// are 13, the middles of the edges. Edge 0 begins at corner 0.

const int point_count = GLARK_POINTS;  // of a triangle: 10 or 13

const int first_quarter = 3;
const int centre = 9;
const int first_middle = 10;

int word_of_point(int point, int triangle) {
  int triangles = corner_count() / 3;
  int whole = triangles - triangles % 3;
  int at = triangle < whole ? point * whole + triangle : point_count * whole + 3 * point + (triangle - whole);
  return 4 * at;
}

// x, y and w.
vec3 point_of(int point, int triangle) {
  int word = word_of_point(point, triangle);
  return uintBitsToFloat(uvec3(ends[word], ends[word + 1], ends[word + 3]));
}

vec4 position_of(int corner) { return vec4(point_of(corner % 3, corner / 3), 0.0).xywz; }

// The depth of the edge that begins at corner a and ends at corner b of its triangle.
int steps_by_error(int a, int b, vec2 half_size, int deepest) {
  int triangle = a / 3;
  int edge = a % 3;
  float eye_distance = max(half_size.x, half_size.y);
  vec3 unit = vec3(half_size, eye_distance);
  precise vec3 end_a = point_of(edge, triangle) * unit;
  precise vec3 end_b = point_of(b % 3, triangle) * unit;
  precise vec3 quarter_a = point_of(first_quarter + 2 * edge, triangle) * unit;
  precise vec3 quarter_b = point_of(first_quarter + 2 * edge + 1, triangle) * unit;
  bool has_middle = point_count > first_middle;
  precise vec3 middle = has_middle ? point_of(first_middle + edge, triangle) * unit : vec3(0.0);
  float scale = glark_scale_of(max(glark_largest(end_a), glark_largest(end_b)));
  return glark_steps_of_curve(glark_Curve(end_a * scale, end_b * scale, quarter_a * scale, quarter_b * scale,
                                          middle * scale, has_middle), eye_distance, deepest);
}

// The steps that the middle of the triangle needs beyond what its edges tell. A surface of second degree has 4/9 of the
// sum of the distances at the middles of its edges in its centre.
int steps_of_inside(int triangle, vec2 half_size, int deepest) {
  if (point_count <= first_middle) {
    return 0;  // the inside of a cubic patch follows from its edges
  }
  float eye_distance = max(half_size.x, half_size.y);
  vec3 unit = vec3(half_size, eye_distance);
  vec3 corners = vec3(0.0);
  vec3 middles = vec3(0.0);
  bool in_front = true;
  for (int i = 0; i < loop_bound(3); ++i) {
    vec3 corner = point_of(i, triangle);
    corners += corner * unit;
    middles += point_of(first_middle + i, triangle) * unit;
    in_front = in_front && corner.z > 0.0;
  }
  float scale = glark_scale_of(glark_largest(corners));
  vec3 flat_centre = corners * (scale / 3.0);
  vec3 predicted = flat_centre + (4.0 / 9.0) * scale * (middles - corners);
  vec3 bulge = point_of(centre, triangle) * unit * scale - predicted;
  return glark_steps_of_bend(0, glark_bend_at(flat_centre, (4.0 / 3.0) * bulge, vec3(0.0), eye_distance, in_front), deepest);
}
