// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Keeps curved triangles near their coarse ones. weld.glsl includes this file, declares the tables, and finds positions
// and edges.
// - A crease is an edge whose faces meet at more than a given angle although they share its normals. Such a normal is a
//   mean of faces, not the normal of a surface. So every edge is straight at a position where a crease ends. A normal
//   that is too steep on one of its faces has the same effect.
// - A boundary is a crease, too, where the surface does not go on smoothly beyond it: the lid of a wall may be another
//   draw.
// - The control points of an edge stay within half the least height of all triangles at this edge. Triangles without an
//   area do not count.
// - A triangle with one normal is meant to be flat. If this normal is not that of its face, its edges are straight.
// - A piece in one plane that has the normal of the plane at a corner is the face of a body. Its boundary is straight.
//
// Angles come from the positions alone: a triangle lies on one side of its edge, in a direction that its winding does
// not change. Two triangles in one plane have opposite directions, folded triangles have the same.

uniform float crease_cosine;    // of two directions: more is a crease
uniform float steepest_cosine;  // of a normal and the normal of its face: less is too steep

int crease_table() { return border_table() + (border_offset >= 0 ? 5 * slot_count : 0); }
int first_side(int slot) { return crease_table() + 2 * slot; }
int height_of(int slot) { return crease_table() + 2 * slot + 1; }
int next_side(int half_edge) { return crease_table() + 2 * slot_count + half_edge; }
int steepness(int corner) { return vertex_table() + 2 * slot_of_place(corner) + 1; }

vec3 place_of(int corner) { return uintBitsToFloat(position_of(corner).xyz); }
float largest(vec3 v) { return max(max(abs(v.x), abs(v.y)), abs(v.z)); }

// The direction in which a triangle lies, seen from its edge: a unit vector across the edge. Zero if the corners are
// almost in one line.
vec3 across(uint side) {
  int low = end_of_side(side, false);
  int high = end_of_side(side, true);
  int half_edge = int(side - 1u) >> 1;
  vec3 from = place_of(low);
  vec3 edge = place_of(high) - from;
  vec3 to_third = place_of(next_corner(next_corner(half_edge))) - from;
  vec3 along = glark_pn_unit(edge);
  precise vec3 apart = to_third - dot(to_third, along) * along;
  bool has_area = largest(apart) > 1.0e-4 * max(largest(to_third), largest(edge));
  return has_area ? glark_pn_unit(apart) : vec3(0.0);
}

struct Face {
  float least_height;
  vec3 normal;  // of any length, of either direction; zero if the triangle has no area but for rounding
};

// The face has the same bits whichever corner comes first, but for the sign of the normal: the sums begin at the least
// corner.
Face face_of(int half_edge) {
  const float rounding = 1.0e-6;  // of the longest edge
  uvec4 a = position_of(half_edge);
  uvec4 b = position_of(next_corner(half_edge));
  uvec4 c = position_of(next_corner(next_corner(half_edge)));
  bool b_first = before(b, a);
  uvec4 least = b_first ? b : a;
  uvec4 other = b_first ? a : b;
  bool c_first = before(c, least);
  vec3 from = uintBitsToFloat((c_first ? c : least).xyz);
  precise vec3 first = uintBitsToFloat((c_first ? least : c).xyz) - from;
  precise vec3 second = uintBitsToFloat(other.xyz) - from;
  float scale = max(largest(first), largest(second));
  if (!(scale > 0.0)) {
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

// Returns whether a triangle has one normal, which leans away from the normal of its face. Such a triangle is meant to
// be flat; the lean is a mistake, or does not matter to the program. A lid with its own normal does not lean, so that
// its edge follows the wall.
bool is_flat_but_leans(int half_edge, vec3 normal_of_face) {
  const float least_cosine = 0.9994;  // 2 degrees: normals have few digits
  uvec4 plane = plane_of(half_edge);
  int next = next_corner(half_edge);
  if (plane == uvec4(0u) || plane != plane_of(next) || plane != plane_of(next_corner(next))) {
    return false;
  }
  precise float cosine = dot(glark_pn_unit(uintBitsToFloat(plane.xyz)), glark_pn_unit(normal_of_face));
  return abs(cosine) < least_cosine;
}

// Adds a side to the list of its edge, and its height to the least one. Bits of positive numbers are in the order of
// the numbers. They are stored inverted, because the tables begin with 0. A height of 0 keeps the edge straight.
void insert_limits(int half_edge, int slot, uint side) {
  tables[next_side(half_edge)] = atomicExchange(tables[first_side(slot)], side);
  Face face = face_of(half_edge);
  if (face.normal != vec3(0.0)) {
    float height = is_flat_but_leans(half_edge, face.normal) ? 0.0 : face.least_height;
    atomicMax(tables[height_of(slot)], ~floatBitsToUint(height));
  }
}

// Two faces share their normals at a corner if these differ by less than half of the angle of the faces. Opposite
// normals are the same.
bool share_normals(int corner, int other, float cosine_of_faces) {
  vec3 a = glark_pn_unit(normal_of(corner));
  vec3 b = glark_pn_unit(normal_of(other));
  float cosine = dot(a, b);
  return a == vec3(0.0) || b == vec3(0.0) || cosine * cosine > 0.5 + 0.5 * abs(cosine_of_faces);
}

// The face beyond a boundary belongs to another draw. If its angle to this face is that of a crease, then a normal of
// both lies half of this angle away from this face.
bool is_mean_of_crease(int corner, vec3 along, vec3 direction) {
  vec3 normal = glark_pn_unit(normal_of(corner));
  float out_of_face = dot(normal, cross(along, direction));
  float in_face = dot(normal, direction);
  float square = out_of_face * out_of_face;
  float size = square + in_face * in_face;
  return size > 0.0 && 1.0 - 2.0 * square / size > crease_cosine;
}

// A surface that goes on smoothly beyond a boundary makes the normals of the boundary lean out of this face, by half of
// the angle of both faces. Without that, a wall ends here, and another draw may have its lid: the edge must stay on it.
// Exact normals of a cone lean a little, too, with the square of the angle between its corners.
bool ends_at(int corner, vec3 along, vec3 direction, float turn) {
  const float least_turn = 1.0e-3;  // 2 (1 - cos): shorter edges hardly leave their chord
  const float least_lean = 0.035;
  const float lean_of_cone = 0.26;
  vec3 normal = glark_pn_unit(normal_of(corner));
  float out_of_face = dot(normal, cross(along, direction));
  float in_face = dot(normal, direction);
  float most = max(least_lean, lean_of_cone * turn);
  return turn > least_turn && in_face * in_face <= most * most * (out_of_face * out_of_face + in_face * in_face);
}

// Returns whether the normal is that of its face. Opposite normals are the same.
bool is_normal_of(int corner, vec3 face) {
  const float least_cosine = 0.9994;  // 2 degrees: normals have few digits
  precise float cosine = dot(glark_pn_unit(normal_of(corner)), face);
  return abs(cosine) >= least_cosine;
}

// Returns whether a normal leans out of the face of a body by more than a quarter of the angle of a crease. Panels that
// lean less belong to a rounded body, whose other draws curve at the common edge.
bool leans_off(int corner, vec3 face) {
  float half_cosine = sqrt(max(0.5 - 0.5 * crease_cosine, 0.0));  // of the angle of a crease
  float cosine = dot(glark_pn_unit(normal_of(corner)), face);
  return cosine * cosine < 0.5 + 0.5 * half_cosine;
}

// What the triangles beyond an edge say about a piece in one plane.
struct Beyond {
  bool bends;    // one of them lies in another plane
  bool has_own;  // one of them has the normal of the plane at its third corner
};

Beyond beyond(int half_edge, vec3 face) {
  const int most_sides = 8;
  const float same = 0.999999;
  const float opposite = -0.9998;  // 1 degree
  Beyond found = Beyond(false, false);
  vec3 direction = across(side_name(half_edge, before(cell_of(next_corner(half_edge)), cell_of(half_edge))));
  uint side = tables[first_side(int(tables[edge_slots() + half_edge]))];
  for (int count = 0; side != 0u && count < most_sides; ++count) {
    vec3 other = across(side);
    float cosine = dot(direction, other);
    int place = int(side - 1u) >> 1;
    if (other != vec3(0.0) && cosine < same) {
      found.bends = found.bends || cosine > opposite;
      found.has_own = found.has_own || is_normal_of(next_corner(next_corner(place)), face);
    }
    side = tables[next_side(place)];
  }
  found.bends = found.bends || side != 0u;
  return found;
}

// A piece in one plane stands alone if all its other edges are boundaries. A facet of a smooth surface then leans away
// from all of its normals, because the surface bends at each corner. The face of a body, as the roof of a house, has
// some normals of its own, and others that are means with the walls.
bool is_face_of_body(int half_edge, vec3 face) {
  bool has_own = false;
  int at = half_edge;
  for (int i = 0; i < 3; ++i) {
    if (!is_side(at)) {
      return false;
    }
    Beyond found = beyond(at, face);
    if (found.bends) {
      return false;
    }
    has_own = has_own || found.has_own || is_normal_of(at, face);
    at = next_corner(at);
  }
  return has_own;
}

// Finds the side that continues this one with the least angle. Sides that lie upon this one, as in sheets with two
// faces, do not count. Without another side, the edge is a boundary.
void mark_crease(uint own, vec3 direction) {
  const int most_sides = 32;
  const float same = 0.999999;
  const float none = 2.0;
  float straightest = none;
  bool shared_low = false;
  bool shared_high = false;
  int count = 0;
  int low = end_of_side(own, false);
  int high = end_of_side(own, true);
  uint side = tables[first_side(int(tables[edge_slots() + (int(own - 1u) >> 1)]))];
  for (; side != 0u && count < most_sides; ++count) {
    vec3 other = across(side);
    float cosine = dot(direction, other);
    if (other != vec3(0.0) && cosine < same && cosine <= straightest) {
      bool equal = cosine == straightest;
      shared_low = (equal && shared_low) || share_normals(low, end_of_side(side, false), cosine);
      shared_high = (equal && shared_high) || share_normals(high, end_of_side(side, true), cosine);
      straightest = cosine;
    }
    side = tables[next_side(int(side - 1u) >> 1)];
  }
  if (straightest == none) {
    vec3 along = glark_pn_unit(place_of(high) - place_of(low));
    float turn = 2.0 - 2.0 * dot(glark_pn_unit(normal_of(low)), glark_pn_unit(normal_of(high)));
    shared_low = is_mean_of_crease(low, along, direction) || ends_at(low, along, direction, turn);
    shared_high = is_mean_of_crease(high, along, direction) || ends_at(high, along, direction, turn);
    if (!(shared_low && shared_high)) {
      int half_edge = int(own - 1u) >> 1;
      vec3 face = glark_pn_unit(face_of(half_edge).normal);
      bool leans_low = leans_off(low, face);
      bool leans_high = leans_off(high, face);
      bool ends = (leans_low || leans_high) && is_face_of_body(half_edge, face);
      shared_low = shared_low || (ends && leans_low);
      shared_high = shared_high || (ends && leans_high);
    }
  }
  if (side != 0u || (straightest > crease_cosine && shared_low)) {
    tables[steepness(low)] = 1u;
  }
  if (side != 0u || (straightest > crease_cosine && shared_high)) {
    tables[steepness(high)] = 1u;
  }
}

void mark(int half_edge) {
  if (!is_side(half_edge)) {
    return;
  }
  uint side = side_name(half_edge, before(cell_of(next_corner(half_edge)), cell_of(half_edge)));
  vec3 direction = across(side);
  if (direction == vec3(0.0)) {
    return;
  }
  vec3 normal = glark_pn_unit(normal_of(half_edge));
  vec3 along = glark_pn_unit(place_of(next_corner(half_edge)) - place_of(half_edge));
  if (plane_of(half_edge) != uvec4(0u) && abs(dot(normal, cross(along, direction))) < steepest_cosine) {
    tables[steepness(half_edge)] = 1u;
  }
  mark_crease(side, direction);
}

bool is_straight_at(int corner) { return tables[steepness(corner)] != 0u; }

// Control points are kept multiplied by 3. The edge then stays within 3/8 of the height, the triangle within half of it.
// No limit is known if no triangle at the edge has an area.
vec3 limited(vec3 control, vec4 near, vec4 far, int slot) {
  if (tables[height_of(slot)] == 0u) {
    return control;
  }
  precise vec3 straight = 2.0 * near.xyz + far.xyz;
  precise vec3 offset = control - straight;
  precise float most = 1.5 * uintBitsToFloat(~tables[height_of(slot)]);
  float scale = largest(offset);
  precise float size = scale * length(offset / scale);  // no square under- or overflows
  if (!(size > most)) {
    return control;
  }
  precise vec3 shortened = straight + (most / size) * offset;
  return shortened;
}

void clear_limits(int slot) {
  tables[first_side(slot)] = 0u;
  tables[height_of(slot)] = 0u;
}
