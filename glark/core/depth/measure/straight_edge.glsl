// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which edges of a curved surface gain nothing from depth, for measure.glsl and ordered.glsl: the curve of the edge is
// its chord, and the normal does not turn along it. A triangle with three such edges is flat. A cylinder has such edges
// along its axis; its triangles are then cut along the axis only.
//
// A straight edge depends on the values at its two ends alone: its welded control points, and the side whose normal
// turns most. All sides of the edge have the same of both. All expressions are `precise`, and give the same bits when the
// ends change places.
//
// Includes measured_edge.glsl first.

#if GLARK_STRAIGHT

// Words in a corner.
uniform int straight_position;
uniform int straight_position_words;
uniform int straight_normal;
uniform int straight_control;  // < 0: the edges are not welded

// Normals are often stored in bytes, which turns them by up to half a degree.
const float most_lean = 1.0e-4;        // square of the sine of the angle between the edge and the tangent
const float least_cosine = 0.9996954;  // square of the cosine of 1 degree

vec4 place_of(int corner) {
  int word = record_offset + corner * corner_words + straight_position;
  float w = straight_position_words > 3 ? uintBitsToFloat(records[word + 3]) : 1.0;
  return vec4(uintBitsToFloat(uvec3(records[word], records[word + 1], records[word + 2])), w);
}

// The curve at `corner` leaves the chord to `other`. Positions whose w differ have straight edges (weld/tangent.glsl).
// `behind`: words from the first control point of the corner to the one of this edge.
bool leans(int corner, int other, int behind) {
  vec4 near = place_of(corner);
  vec4 far = place_of(other);
  precise vec3 along = far.xyz - near.xyz;
  float scale = glark_scale_of(glark_largest(along));
  along = along * scale;
  if (straight_control >= 0) {
    int word = record_offset + corner * corner_words + straight_control + behind;
    vec3 control = uintBitsToFloat(uvec3(records[word], records[word + 1], records[word + 2]));
    precise vec3 offset = (control - (2.0 * near.xyz + far.xyz)) * scale;
    return glark_square(offset) > most_lean * glark_square(along);
  }
  vec3 normal = normal_at(corner, straight_normal);
  precise vec3 scaled = normal * glark_scale_of(glark_largest(normal));
  precise float height = glark_dot(along, scaled);
  return near.w == far.w && height * height > most_lean * (glark_square(along) * glark_square(scaled));
}

bool turns(int a, int b) {
  vec3 normal_a = normal_at(a, straight_normal);
  vec3 normal_b = normal_at(b, straight_normal);
  precise vec3 unit_a = normal_a * glark_scale_of(glark_largest(normal_a));
  precise vec3 unit_b = normal_b * glark_scale_of(glark_largest(normal_b));
  precise float cosine = glark_dot(unit_a, unit_b);
  precise float signed_square = cosine * abs(cosine);
  precise float unit = glark_square(unit_a) * glark_square(unit_b);
  return glark_turns_more(signed_square, unit, least_cosine);
}

// The edge from a to b, which follows a in its triangle.
bool is_straight(int a, int b) {
  bool leaning = false;
  for (int end = 0; end < loop_bound(2); ++end) {
    leaning = leaning || leans(end == 0 ? a : b, end == 0 ? b : a, 3 * end);
  }
  if (leaning) {
    return false;
  }
  ivec2 side = side_that_turns_most(a, b);
  return !turns(side.x, side.y);
}

#else

bool is_straight(int a, int b) { return false; }

#endif
