// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Curved PN triangles. This text is valid from GLSL 1.10 on. The unit that includes this defines the macro glark_precise.
// Based on: A. Vlachos, J. Peters, C. Boyd, J. L. Mitchell, Curved PN Triangles, I3D 2001, section 3.
//
// A refinement with the word W that curves positions defines two functions, with a number before p0 if its row has one:
//   vec3 glark_W_patch(vec3 weights, vec3 p0, vec3 p1, vec3 p2,
//                      vec3 b210, vec3 b120, vec3 b021, vec3 b012, vec3 b102, vec3 b201)
//     the position. The b are the control points of the edges times 3, which neighbours share. pn.glsl comes first.
//   void glark_W_slopes(the same, out vec3 along_u, out vec3 along_v)
//     its derivatives by u and v (w = 1 - u - v); not needed if the row has displaced_as.
//
// Watertight: a point on an edge depends only on the ends of this edge, by expressions that give the same bits when the
// ends change places. The centre is kept multiplied by 6.

#include "glark/core/weld/tangent.glsl"

// Weights w of corner `near`, u of corner `far`; symmetric in the ends.
vec3 glark_pn_edge(vec3 near_control, vec3 far_control, float w, float u) {
  glark_precise float near_weight = (w * w) * u;
  glark_precise float far_weight = (u * u) * w;
  glark_precise vec3 sum = near_control * near_weight + far_control * far_weight;
  return sum;
}

// The edge curve, by the same sums as in the patch.
vec3 glark_pn_curve(vec3 near, vec3 far, vec3 near_control, vec3 far_control, float w, float u) {
  glark_precise vec3 position = (near * ((w * w) * w) + far * ((u * u) * u)) + glark_pn_edge(near_control, far_control, w, u);
  return position;
}

// The position, from the corners and the control points of the edges, which neighbours share. A triangle with two
// corners in one place, as in stitched strips, has no area: it collapses to its edge.
vec3 glark_pn_patch(vec3 weights, vec3 p0, vec3 p1, vec3 p2, vec3 b210, vec3 b120, vec3 b021, vec3 b012, vec3 b102, vec3 b201) {
  glark_precise float w = weights.x;
  glark_precise float u = weights.y;
  glark_precise float v = weights.z;
  if (p0 == p1 && p1 == p2) return p0;
  if (p0 == p1) return glark_pn_curve(p1, p2, b021, b012, w + u, v);
  if (p1 == p2) return glark_pn_curve(p2, p0, b102, b201, u + v, w);
  if (p2 == p0) return glark_pn_curve(p0, p1, b210, b120, v + w, u);
  glark_precise vec3 corners = (p0 * ((w * w) * w) + p1 * ((u * u) * u)) + p2 * ((v * v) * v);
  glark_precise vec3 edges = (glark_pn_edge(b210, b120, w, u) + glark_pn_edge(b021, b012, u, v)) + glark_pn_edge(b102, b201, v, w);
  // b111 = E + (E - V) / 2 with E the mean of the six b, V that of the corners.
  glark_precise vec3 middle = 0.5 * (((b210 + b120) + (b021 + b012)) + (b102 + b201)) - ((p0 + p1) + p2);
  glark_precise vec3 position = (corners + edges) + middle * ((w * u) * v);
  return position;
}

// n110: the mean of the ends' normals, reflected in the plane across the edge.
vec3 glark_pn_edge_normal(vec3 near, vec3 unit_normal_near, vec3 far, vec3 unit_normal_far) {
  glark_precise vec3 along = glark_pn_unit(far - near);
  glark_precise vec3 both = unit_normal_near + unit_normal_far;
  glark_precise float tilt = 2.0 * dot(along, both);
  glark_precise vec3 reflected = both - tilt * along;
  return glark_pn_unit(reflected);
}

// The same, but the mean is not reflected on a straight edge: welding keeps some edges straight whose normals lean along
// them, and the reflection would make the light wave.
vec3 glark_pn_creased_normal(vec3 near, vec3 unit_normal_near, vec3 far, vec3 unit_normal_far, vec3 near_control, vec3 far_control) {
  glark_precise vec3 near_third = 2.0 * near + far;
  glark_precise vec3 far_third = 2.0 * far + near;
  if (near_control == near_third && far_control == far_third) return glark_pn_unit(unit_normal_near + unit_normal_far);
  return glark_pn_edge_normal(near, unit_normal_near, far, unit_normal_far);
}

// The normal is as long as the linear interpolation of the corners' lengths. It is linear where the construction gives
// no direction. n0, n1, n2: the corners' unit normals; n110, n011, n101: the normals of the edges.
vec3 glark_pn_mixed_normal(vec3 weights, vec3 normal0, vec3 normal1, vec3 normal2, vec3 n0, vec3 n1, vec3 n2, vec3 n110, vec3 n011, vec3 n101) {
  glark_precise float w = weights.x;
  glark_precise float u = weights.y;
  glark_precise float v = weights.z;
  if (w == 1.0) return normal0;
  if (u == 1.0) return normal1;
  if (v == 1.0) return normal2;
  glark_precise vec3 corners = (n0 * (w * w) + n1 * (u * u)) + n2 * (v * v);
  glark_precise vec3 edges = (n110 * (w * u) + n011 * (u * v)) + n101 * (v * w);
  vec3 direction = glark_pn_unit(corners + edges);
  glark_precise vec3 linear = (normal0 * w + normal1 * u) + normal2 * v;
  glark_precise float size = (length(normal0) * w + length(normal1) * u) + length(normal2) * v;
  glark_precise vec3 normal = direction * size;
  return direction == vec3(0.0) ? linear : normal;
}

vec3 glark_pn_normal(vec3 weights, vec3 p0, vec3 p1, vec3 p2, vec3 normal0, vec3 normal1, vec3 normal2) {
  vec3 n0 = glark_pn_unit(normal0);
  vec3 n1 = glark_pn_unit(normal1);
  vec3 n2 = glark_pn_unit(normal2);
  return glark_pn_mixed_normal(weights, normal0, normal1, normal2, n0, n1, n2, glark_pn_edge_normal(p0, n0, p1, n1),
                               glark_pn_edge_normal(p1, n1, p2, n2), glark_pn_edge_normal(p2, n2, p0, n0));
}

vec3 glark_pn_normal_beside_creases(vec3 weights, vec3 p0, vec3 p1, vec3 p2, vec3 normal0, vec3 normal1, vec3 normal2, vec3 b210, vec3 b120, vec3 b021, vec3 b012, vec3 b102, vec3 b201) {
  vec3 n0 = glark_pn_unit(normal0);
  vec3 n1 = glark_pn_unit(normal1);
  vec3 n2 = glark_pn_unit(normal2);
  return glark_pn_mixed_normal(weights, normal0, normal1, normal2, n0, n1, n2, glark_pn_creased_normal(p0, n0, p1, n1, b210, b120),
                               glark_pn_creased_normal(p1, n1, p2, n2, b021, b012), glark_pn_creased_normal(p2, n2, p0, n0, b102, b201));
}
