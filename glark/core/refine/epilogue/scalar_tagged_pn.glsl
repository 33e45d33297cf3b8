// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Scalar-tagged PN triangles; include after pn.glsl. Without tags, they have the same bits as PN triangles.
// Based on: Boubekeur 2007, ch. 8.2 and 8.3.
//
// Watertight: a control point on an edge and its side of a crease depend only on the ends of the edge.

struct glark_StCorner {
  vec4 position;
  vec3 given;           // the normal as the vertex has it
  vec3 unit;            // N
  vec3 discontinuity;  // Delta: (N+ - N-) / |N+ + N-|
  float crease;         // its number; 0: all creases. An edge between two tagged corners of one crease is sharp
  bool tagged;
  float sharpness;
  float tension;
  float bias;
};

// Clamps the value. Not-a-number counts as 0.
float glark_st_within(float value, float least, float most) {
  return value >= least ? min(value, most) : (value < least ? least : 0.0);
}

glark_StCorner glark_st_corner(vec4 position, vec3 normal, vec4 discontinuity, vec3 tags) {
  glark_StCorner corner;
  float size = dot(discontinuity.xyz, discontinuity.xyz);
  corner.position = position;
  corner.given = normal;
  corner.unit = glark_pn_unit(normal);
  corner.tagged = size > 0.0 && size < 1.0e12;
  corner.discontinuity = corner.tagged ? discontinuity.xyz : vec3(0.0);
  corner.crease = discontinuity.w;
  corner.sharpness = glark_st_within(tags.x, 0.0, 65536.0);
  corner.tension = glark_st_within(tags.y, -1.0, 1.0);
  corner.bias = glark_st_within(tags.z, -1.0, 1.0);
  return corner;
}

bool glark_st_sharp(glark_StCorner near, glark_StCorner far) {
  return near.tagged && far.tagged && (near.crease == far.crease || near.crease == 0.0 || far.crease == 0.0);
}

// Negative if the edge leaves `near` on the side of N+, positive on the side of N-, 0 on neither. An arc from `near` to
// `far` makes equal angles with the normals at its ends. The one of N+ and N- that is nearer to this is the normal of
// the edge's side. A tagged `far` has a normal of neither side, so it is left out.
float glark_st_lean(glark_StCorner near, glark_StCorner far) {
  glark_precise vec3 along = glark_pn_unit(far.position.xyz - near.position.xyz);
  glark_precise vec3 both = far.tagged ? near.unit : near.unit + far.unit;
  glark_precise float lean = dot(along, near.discontinuity) * dot(along, both);
  return lean;
}

// N': the normal of one side of the crease.
vec3 glark_st_sided(glark_StCorner corner, float lean) {
  if (lean == 0.0 || corner.sharpness == 0.0 || !corner.tagged) return corner.unit;
  glark_precise vec3 sided = corner.unit + (lean < 0.0 ? corner.sharpness : -corner.sharpness) * corner.discontinuity;
  return glark_pn_unit(sided);
}

// 3 b210, as in glark_pn_tangent, with the tension of `near`. It is lifted along X off creases and along Y on creases.
vec3 glark_st_control(glark_StCorner near, glark_StCorner far) {
  vec3 measured = near.unit;
  vec3 lifted = near.unit;
  if (glark_st_sharp(near, far)) {
    glark_precise vec3 biased = near.unit + near.bias * near.discontinuity;
    if (near.bias != 0.0) lifted = glark_pn_unit(biased);
  } else {
    float lean = near.tagged ? glark_st_lean(near, far) : 0.0;
    if (lean != 0.0 && near.sharpness > 0.0) {
      float sharpness = min(near.sharpness, 1.0);
      glark_precise vec3 mixed = (1.0 - sharpness) * near.unit + sharpness * glark_st_sided(near, lean);
      measured = lifted = glark_pn_unit(mixed);
    }
  }
  glark_precise float height =
      near.position.w == far.position.w ? dot(far.position.xyz - near.position.xyz, measured) : 0.0;
  glark_precise float loose = 1.0 - near.tension;
  glark_precise vec3 control =
      ((2.0 + near.tension) * near.position.xyz + loose * far.position.xyz) - (loose * height) * lifted;
  return control;
}

// Control points, times 3, and the normals of the triangle's sides.
vec3 glark_st_b210;
vec3 glark_st_b120;
vec3 glark_st_b021;
vec3 glark_st_b012;
vec3 glark_st_b102;
vec3 glark_st_b201;
vec3 glark_st_n0;
vec3 glark_st_n1;
vec3 glark_st_n2;

void glark_st_controls(glark_StCorner c0, glark_StCorner c1, glark_StCorner c2) {
  glark_st_b210 = glark_st_control(c0, c1);
  glark_st_b120 = glark_st_control(c1, c0);
  glark_st_b021 = glark_st_control(c1, c2);
  glark_st_b012 = glark_st_control(c2, c1);
  glark_st_b102 = glark_st_control(c2, c0);
  glark_st_b201 = glark_st_control(c0, c2);
}

// Applies the tension to a welded control point. A tagged corner has one normal for both sides, so it keeps its own
// control point.
vec3 glark_st_welded_control(glark_StCorner near, glark_StCorner far, vec3 welded) {
  if (near.tagged) return glark_st_control(near, far);
  if (near.tension == 0.0) return welded;
  glark_precise vec3 flat_control = 3.0 * near.position.xyz;
  glark_precise vec3 control = flat_control + (1.0 - near.tension) * (welded - flat_control);
  return control;
}

// The position, from the control points above.
vec3 glark_st_position(vec3 weights, vec3 p0, vec3 p1, vec3 p2) {
  return glark_pn_patch(weights, p0, p1, p2, glark_st_b210, glark_st_b120, glark_st_b021, glark_st_b012, glark_st_b102, glark_st_b201);
}

// The side on which a triangle lies at `corner`: the side of its edges there that are not sharp. If both are sharp, the
// side of its plane.
float glark_st_triangle_lean(glark_StCorner corner, glark_StCorner next, glark_StCorner last, vec3 up) {
  if (!corner.tagged) return 0.0;
  float lean = (glark_st_sharp(corner, next) ? 0.0 : glark_st_lean(corner, next)) +
               (glark_st_sharp(corner, last) ? 0.0 : glark_st_lean(corner, last));
  return lean != 0.0 ? lean : -dot(corner.discontinuity, up);
}

// The normal of the triangle's side, with the length of the given normal.
vec3 glark_st_turned(glark_StCorner corner, float lean) {
  if (lean == 0.0 || corner.sharpness == 0.0 || !corner.tagged) return corner.given;
  return glark_st_sided(corner, lean) * length(corner.given);
}

vec3 glark_st_normal(vec3 weights, glark_StCorner c0, glark_StCorner c1, glark_StCorner c2) {
  vec3 p0 = c0.position.xyz;
  vec3 p1 = c1.position.xyz;
  vec3 p2 = c2.position.xyz;
  vec3 up = cross(p1 - p0, p2 - p0);
  if (dot(up, (c0.unit + c1.unit) + c2.unit) < 0.0) up = -up;
  glark_st_n0 = glark_st_turned(c0, glark_st_triangle_lean(c0, c1, c2, up));
  glark_st_n1 = glark_st_turned(c1, glark_st_triangle_lean(c1, c2, c0, up));
  glark_st_n2 = glark_st_turned(c2, glark_st_triangle_lean(c2, c0, c1, up));
  return glark_pn_normal(weights, p0, p1, p2, glark_st_n0, glark_st_n1, glark_st_n2);
}
