// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Keeps curved triangles near their coarse ones. weld.glsl includes this file, declares the tables, and finds positions
// and edges.
// - A crease is an edge whose faces meet at more than a given angle although they share its normals. Such a normal is a
//   mean of faces, not the normal of a surface. So every edge is straight at a position where a crease ends. A normal
//   that is too steep on one of its faces has the same effect.
// - A boundary is a crease, too, unless the surface continues smoothly beyond it. For example, another draw may contain
//   the lid of a wall.
// - The control points of an edge stay within half the least height of all triangles at this edge. Triangles without an
//   area do not count.
// - If the normals of a triangle lean away from its face by more than they differ from each other, they are not the
//   normals of a surface there. The edges of this triangle are straight.
// - A flat piece whose plane has the same normal as one of its corners is the face of a body, for example a roof. Its
//   boundary is straight.
//
// Angles come from the positions alone: a triangle lies on one side of its edge, in a direction that its winding does
// not change. Two triangles in one plane have opposite directions, folded triangles have the same.

uniform float crease_cosine;    // of two directions: more is a crease
uniform float steepest_cosine;  // of a normal and the normal of its face: less is too steep

int first_side(int slot) { return crease_table() + 2 * slot; }
int height_of(int slot) { return crease_table() + 2 * slot + 1; }
int next_side(int half_edge) { return side_list() + half_edge; }
int steepness(int corner) { return vertex_table() + 2 * place_of(corner) + 1; }

vec3 point_of(int corner) { return uintBitsToFloat(position_of(corner).xyz); }
float largest(vec3 v) { return max(max(abs(v.x), abs(v.y)), abs(v.z)); }

// Until the last pass, the words of a half-edge's control points hold what later passes need of its triangle:
//   the direction in which the triangle lies, seen from its edge: a unit vector across the edge. Zero if the corners are
//   almost in one line
//   the unit normal of the triangle, of either direction. Zero if the triangle has no area
int note_of(int half_edge) { return record_offset + half_edge * corner_words + control_offset; }
vec3 note_at(int word) { return uintBitsToFloat(uvec3(records[word], records[word + 1], records[word + 2])); }
vec3 direction_of(int half_edge) { return note_at(note_of(half_edge)); }
vec3 face_normal_of(int half_edge) { return note_at(note_of(half_edge) + 3); }
// Bits of the word of a half-edge.
const uint bends_beyond = 1u << 30;
const uint has_own_normal = 1u << 31;
int half_edge_of(uint side) { return int(side - 1u) >> 1; }

#if GLARK_PASS == 4
vec3 across(vec3 from, vec3 to, vec3 third) {
  vec3 edge = to - from;
  vec3 to_third = third - from;
  vec3 along = glark_pn_unit(edge);
  precise vec3 apart = to_third - dot(to_third, along) * along;
  bool has_area = largest(apart) > 1.0e-4 * max(largest(to_third), largest(edge));
  return has_area ? glark_pn_unit(apart) : vec3(0.0);
}

struct Face {
  float least_height;
  vec3 normal;  // of any length, of either direction; zero if the triangle has no area but for rounding
};

// A triangle gives the same bits whichever corner comes first, except for the sign of the normal: all differences start
// at the least corner.
Face face_of(uvec4 a, uvec4 b, uvec4 c) {
  const float rounding = 1.0e-6;  // of the longest edge
  bool b_first = before(b, a);
  uvec4 least = b_first ? b : a;
  uvec4 other = b_first ? a : b;
  bool c_first = before(c, least);
  vec3 from = uintBitsToFloat((c_first ? c : least).xyz);
  precise vec3 first = uintBitsToFloat((c_first ? least : c).xyz) - from;
  precise vec3 second = uintBitsToFloat(other.xyz) - from;
  float scale = max(largest(first), largest(second));
  if (scale == 0.0) {
    return Face(0.0, vec3(0.0));
  }
  first /= scale;
  second /= scale;
  precise vec3 third = second - first;
  float longest = max(max(dot(first, first), dot(second, second)), dot(third, third));
  precise vec3 twice_area = cross(first, second);
  precise float height = sqrt(dot(twice_area, twice_area) / longest);
  bool has_area = height > rounding * sqrt(longest);
  return Face(scale * height, has_area ? twice_area : vec3(0.0));
}

// Returns whether the normals of a triangle are not those of a surface near its face: the normal of the face lies farther
// away from each of them than they lie apart. The normals of a surface turn about that of the face. Such a triangle stays
// flat; the lean is a mistake, or does not matter to the program. With one normal it is meant to be flat. A lid with its
// own normal does not lean, so that its edge follows the wall. Opposite normals are the same.
bool leans_away(int half_edge, vec3 unit_normal_of_face) {
  const vec2 two_degrees = vec2(0.9994, 0.0349);  // cosine and sine: normals have few digits
  const vec2 twenty_degrees = vec2(0.9397, 0.3420);
  uvec4 plane = plane_of(half_edge);
  bool one_normal = true;
  float nearest = 0.0;  // cosine of the least angle between a normal and that of the face
  float spread = 1.0;   // cosine of the greatest angle between two normals
  int corner = half_edge;
  for (int i = 0; i < corners_of_triangle; ++i) {
    corner = next_corner(corner);
    uvec4 next = plane_of(corner);
    if (next == uvec4(0u)) {
      return false;
    }
    vec3 normal = glark_pn_unit(uintBitsToFloat(next.xyz));
    precise float of_face = abs(dot(normal, unit_normal_of_face));
    precise float of_both = abs(dot(normal, glark_pn_unit(uintBitsToFloat(plane.xyz))));
    nearest = max(nearest, of_face);
    spread = min(spread, of_both);
    one_normal = one_normal && next == plane;
    plane = next;
  }
  vec2 more = one_normal ? two_degrees : twenty_degrees;
  precise float of_sum = spread * more.x - sqrt(max(1.0 - spread * spread, 0.0)) * more.y;
  return nearest < of_sum;
}

// Adds a side to the list of its edge, and its height to the least one. Bits of positive numbers are in the order of
// the numbers. They are stored inverted, because the tables begin with 0. A height of 0 keeps the edge straight.
void measure_face(int half_edge) {
  int slot = slot_of_side(half_edge);
  if (slot < 0) {
    return;
  }
  bool falling = is_falling(half_edge);
  uvec4 from = position_of(half_edge);
  uvec4 to = position_of(next_corner(half_edge));
  uvec4 third = position_of(next_corner(next_corner(half_edge)));
  vec3 direction = across(uintBitsToFloat((falling ? to : from).xyz), uintBitsToFloat((falling ? from : to).xyz),
                          uintBitsToFloat(third.xyz));
  Face face = face_of(from, to, third);
  vec3 unit_normal = glark_pn_unit(face.normal);
  for (int i = 0; i < corners_of_triangle; ++i) {
    records[note_of(half_edge) + i] = floatBitsToUint(direction[i]);
    records[note_of(half_edge) + 3 + i] = floatBitsToUint(unit_normal[i]);
  }
  tables[next_side(half_edge)] = atomicExchange(tables[first_side(slot)], side_name(half_edge, falling));
  if (face.normal != vec3(0.0)) {
    float height = leans_away(half_edge, unit_normal) ? 0.0 : face.least_height;
    atomicMax(tables[height_of(slot)], ~floatBitsToUint(height));
  }
}
#elif GLARK_PASS == 5
// Returns whether the normal is that of its face. Opposite normals are the same.
bool is_normal_of(int corner, vec3 face) {
  const float least_cosine = 0.9994;  // 2 degrees: normals have few digits
  precise float cosine = dot(glark_pn_unit(normal_of(corner)), face);
  return abs(cosine) >= least_cosine;
}

// Finds out about the triangles beyond a half-edge: whether one of them lies in another plane, and whether one of them, or
// this triangle, has the normal of the plane at its corner.
void look_beyond(int half_edge) {
  const int most_sides = 8;
  const float same = 0.999999;
  const float opposite = -0.9998;  // 1 degree
  int slot = slot_of_side(half_edge);
  if (slot < 0) {
    return;
  }
  vec3 direction = direction_of(half_edge);
  vec3 face = face_normal_of(half_edge);
  bool bends = false;
  bool has_own = false;
  bool counts = true;
  int corner = half_edge;
  uint side = tables[first_side(slot)];
  for (int left = most_sides; corner >= 0; --left) {
    bool own = is_normal_of(corner, face);
    has_own = has_own || (own && counts);
    corner = -1;
    if (side != 0u && left > 0) {
      int other_half_edge = half_edge_of(side);
      vec3 other = direction_of(other_half_edge);
      float cosine = dot(direction, other);
      counts = other != vec3(0.0) && cosine < same;
      bends = bends || (counts && cosine > opposite);
      corner = next_corner(next_corner(other_half_edge));
      side = tables[next_side(other_half_edge)];
    }
  }
  tables[edge_slots() + half_edge] |= (bends || side != 0u ? bends_beyond : 0u) | (has_own ? has_own_normal : 0u);
}
#elif GLARK_PASS == 6
// Two faces share their normals at a corner if these differ by less than half of the angle of the faces. Opposite
// normals are the same.
bool share_normals(vec3 a, vec3 b, float cosine_of_faces) {
  float cosine = dot(a, b);
  return a == vec3(0.0) || b == vec3(0.0) || cosine * cosine > 0.5 + 0.5 * abs(cosine_of_faces);
}

// The face beyond a boundary belongs to another draw. If its angle to this face is that of a crease, then a normal of
// both lies half of this angle away from this face.
bool is_mean_of_crease(float out_of_face, float in_face) {
  float square = out_of_face * out_of_face;
  float size = square + in_face * in_face;
  return size > 0.0 && 1.0 - 2.0 * square / size > crease_cosine;
}

struct Ends {
  vec3 low;
  vec3 high;
};

// A surface that continues smoothly beyond a boundary makes the normals of the boundary lean out of this face. If they do
// not lean, a wall ends here. Its lid may be another draw, so the edge must stay straight. Exact normals of a coarse cone
// lean a little, too, with the square of the angle between its corners.
bool leans_little(float out_of_face, float in_face, float turn) {
  const float least_lean = 0.035;  // sine: 2 degrees
  const float lean_of_cone = 0.26;
  float most = max(least_lean, lean_of_cone * turn);
  return in_face * in_face <= most * most * (out_of_face * out_of_face + in_face * in_face);
}

// How much a normal leans along a side of this triangle does not depend on how coarse a cone or a ball is. The more upright
// side tells: the normals of cylinders and cones do not lean along it, and those of a ball lean alike in the rings on both
// sides of the boundary. If the third normal is the mean of the others, no side is upright.
bool may_end_wall(int half_edge, vec3 along, Ends normals) {
  const float same = 0.9998;         // 1 degree
  const float upright_lean = 0.02;
  bool falling = is_falling(half_edge);
  int third = next_corner(next_corner(half_edge));
  vec3 from_low = glark_pn_unit(point_of(third) - point_of(falling ? next_corner(half_edge) : half_edge));
  vec3 from_high = glark_pn_unit(point_of(third) - point_of(falling ? half_edge : next_corner(half_edge)));
  bool low_is_upright = abs(dot(from_low, along)) <= abs(dot(from_high, along));
  float lean = low_is_upright ? dot(from_low, normals.low) : dot(from_high, normals.high);
  vec3 mean = glark_pn_unit(normals.low + normals.high);
  return abs(lean) <= upright_lean || dot(mean, glark_pn_unit(normal_of(third))) >= same;
}

// Returns whether a normal leans out of the face of a body by more than a quarter of the angle of a crease. Panels that
// lean less belong to a rounded body, whose other draws curve at the common edge.
bool leans_off(vec3 unit_normal, vec3 face) {
  float half_cosine = sqrt(max(0.5 - 0.5 * crease_cosine, 0.0));  // of the angle of a crease
  float cosine = dot(unit_normal, face);
  return cosine * cosine < 0.5 + 0.5 * half_cosine;
}

// A piece in one plane stands alone if all its other edges are boundaries. A facet of a smooth surface then leans away
// from all of its normals, because the surface bends at each corner. The face of a body, as the roof of a house, has
// some normals of its own, and others that are means with the walls.
bool is_face_of_body(int half_edge) {
  uint found = 0u;
  int at = half_edge;
  for (int i = 0; i < corners_of_triangle; ++i) {
    found |= tables[edge_slots() + at];
    at = next_corner(at);
  }
  return (found & bends_beyond) == 0u && (found & has_own_normal) != 0u;
}

// Marks the ends of a boundary where it is a crease.
bvec2 is_crease_of_boundary(int half_edge, vec3 along, vec3 direction, Ends normals) {
  const float least_turn = 1.0e-3;  // shorter edges hardly leave their chord
  float turn = 2.0 - 2.0 * dot(normals.low, normals.high);
  bool ends_wall = turn > least_turn && may_end_wall(half_edge, along, normals);
  bool lean_alike = abs(dot(normals.high - normals.low, direction)) <= 0.01;  // as in each ring of a cone or a ball
  vec3 out_of_face = cross(along, direction);
  vec3 face = face_normal_of(half_edge);
  bvec2 creased = bvec2(false);
  bvec2 leaning = bvec2(false);
  for (int end = 0; end < ends_of_edge; ++end) {
    vec3 normal = end == 0 ? normals.low : normals.high;
    float outwards = dot(normal, out_of_face);
    float inwards = dot(normal, direction);
    creased[end] = is_mean_of_crease(outwards, inwards) || (ends_wall && (lean_alike || leans_little(outwards, inwards, turn)));
    leaning[end] = leans_off(normal, face);
  }
  if (!all(creased) && any(leaning) && is_face_of_body(half_edge)) {
    creased = bvec2(creased.x || leaning.x, creased.y || leaning.y);
  }
  return creased;
}

// Finds the side that continues this one with the least angle. Sides that lie upon this one, as in sheets with two
// faces, do not count. Without another side, the edge is a boundary.
bvec2 is_crease(int half_edge, vec3 along, vec3 direction, Ends normals) {
  const int most_sides = 32;
  const float same = 0.999999;
  const float none = 2.0;
  float straightest = none;
  bvec2 shared_normal = bvec2(false);
  int count = 0;
  uint side = tables[first_side(slot_of_side(half_edge))];
  for (; side != 0u && count < most_sides; ++count) {
    vec3 other = direction_of(half_edge_of(side));
    float cosine = dot(direction, other);
    if (other != vec3(0.0) && cosine < same && cosine <= straightest) {
      bool equal = cosine == straightest;
      for (int end = 0; end < ends_of_edge; ++end) {
        vec3 normal = glark_pn_unit(normal_of(end_of_side(side, end == 1)));
        shared_normal[end] = (equal && shared_normal[end]) || share_normals(end == 0 ? normals.low : normals.high, normal, cosine);
      }
      straightest = cosine;
    }
    side = tables[next_side(half_edge_of(side))];
  }
  if (straightest == none) {
    shared_normal = is_crease_of_boundary(half_edge, along, direction, normals);
  }
  return bvec2(side != 0u || (straightest > crease_cosine && shared_normal.x),
               side != 0u || (straightest > crease_cosine && shared_normal.y));
}

void mark(int half_edge) {
  vec3 direction = slot_of_side(half_edge) >= 0 ? direction_of(half_edge) : vec3(0.0);
  if (direction == vec3(0.0)) {
    return;
  }
  bool falling = is_falling(half_edge);
  int low = falling ? next_corner(half_edge) : half_edge;
  int high = falling ? half_edge : next_corner(half_edge);
  Ends normals = Ends(glark_pn_unit(normal_of(low)), glark_pn_unit(normal_of(high)));
  vec3 along = glark_pn_unit(point_of(high) - point_of(low));
  bvec2 marked = is_crease(half_edge, along, direction, normals);
  vec3 normal = falling ? normals.high : normals.low;
  bool steep = plane_of(half_edge) != uvec4(0u) && abs(dot(normal, cross(along, direction))) < steepest_cosine;
  for (int end = 0; end < ends_of_edge; ++end) {
    if (marked[end] || (steep && (end == 1) == falling)) {
      tables[steepness(end == 0 ? low : high)] = 1u;
    }
  }
}
#elif GLARK_PASS == 7
bool is_straight_at(int corner) { return tables[steepness(corner)] != 0u; }

// Control points are kept multiplied by 3. The edge then stays within 3/8 of the height, the triangle within half of it.
// No limit is known if no triangle at the edge has an area.
vec3 limited(vec3 control, vec4 near, vec4 far, int slot) {
  uint height = tables[height_of(slot)];
  if (height == 0u) {
    return control;
  }
  precise vec3 straight = 2.0 * near.xyz + far.xyz;
  precise vec3 offset = control - straight;
  precise float most = 1.5 * uintBitsToFloat(~height);
  float scale = largest(offset);
  if (scale == 0.0) {
    return control;  // no comparison below may meet a number that is none: NVIDIA turns !(a > b) into a <= b
  }
  precise float size = scale * length(offset / scale);  // no square under- or overflows
  precise vec3 shortened = straight + (most / size) * offset;
  return size > most ? shortened : control;
}
#endif
