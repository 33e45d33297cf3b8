// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which triangles cannot be seen: they lie outside the view, or GL culls them. An edge has depth 0 if all triangles on
// it are hidden. A triangle that is seen has the full depth on all of its edges, so no picture changes, and nothing
// pops up when a triangle comes into view. Needs the sides of each edge (turn_offset). Include after curve_points.glsl.

uniform float culled_side;  // 1: GL culls triangles that go clockwise on the screen; -1: counter-clockwise; 0: none

// Between its known points, a triangle may reach further out. The margin is a part of its extent.
const float margin_of_extent = 0.25;
// Sine of the angle between two edges of a triangle on the screen. Triangles seen end-on are not known to face away.
const float least_sine = 0.02;

bool is_outside(int triangle) {
  vec4 least = vec4(3.0e38);
  vec4 most = vec4(-3.0e38);
  for (int point = 0; point < loop_bound(point_count); ++point) {
    vec3 p = point_of(point, triangle);
    vec4 inside = vec4(p.z + p.x, p.z - p.x, p.z + p.y, p.z - p.y);
    if (!all(lessThan(abs(inside), vec4(1.0e30)))) {
      return false;  // not a number, or too large
    }
    least = min(least, inside);
    most = max(most, inside);
  }
  return any(lessThan(most + margin_of_extent * (most - least), vec4(0.0)));
}

bool faces_away(vec2 a, vec2 b, vec2 c) {
  vec2 ab = b - a;
  vec2 ac = c - a;
  float turn = culled_side * (ab.x * ac.y - ab.y * ac.x);
  return turn < -least_sine * length(ab) * length(ac);
}

bool is_culled(int triangle) {
  if (culled_side == 0.0) {
    return false;
  }
  vec2 on_screen[10];
  for (int point = 0; point <= loop_bound(centre); ++point) {
    vec3 p = point_of(point, triangle);
    if (!(p.z > 0.0)) {
      return false;
    }
    on_screen[point] = p.xy * half_size / p.z;
  }
  bool away = true;
  for (int edge = 0; edge < loop_bound(3); ++edge) {
    int first = first_quarter + 2 * edge;
    int next = edge == 2 ? first_quarter : first + 2;
    int corner = edge == 2 ? 0 : edge + 1;
    away = away && faces_away(on_screen[first], on_screen[first + 1], on_screen[centre]) &&
           faces_away(on_screen[first + 1], on_screen[next], on_screen[centre]) &&
           faces_away(on_screen[first + 1], on_screen[corner], on_screen[next]);
  }
  return away;
}

bool is_hidden(int triangle) { return is_outside(triangle) || is_culled(triangle); }
