// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Phong tessellation, in the words of GLSL 1.10.
// Based on: T. Boubekeur, M. Alexa, Phong Tessellation, ACM Transactions on Graphics 27(5), 2008, section 3.
//
// The paper projects a refined vertex onto the tangent planes of the three corners. Here the projections follow from
// the control points of the edges, b (times 3): the projection of corner q onto the plane of p is b - 2 p. Welding
// finds the same b for all triangles at an edge, even if their normals differ.
//
// Watertight: along an edge, only its own bend remains, and all sums are symmetric in the ends.

// The sum of the offsets from the ends of an edge to their projections.
vec3 glark_phong_bend(vec3 near, vec3 far, vec3 near_control, vec3 far_control) {
  glark_precise vec3 bend = (near_control + far_control) - 3.0 * (near + far);
  return bend;
}

// The edge curve, by the same sums as in the patch.
vec3 glark_phong_curve(float shape, vec3 near, vec3 far, vec3 near_control, vec3 far_control, float w, float u) {
  glark_precise vec3 flat_position = w * near + u * far;
  glark_precise vec3 bent = (w * u) * glark_phong_bend(near, far, near_control, far_control);
  glark_precise vec3 position = flat_position + shape * bent;
  return position;
}

// A triangle with two corners in one place has no area: it collapses to its edge.
vec3 glark_phong_patch(vec3 weights, float shape, vec3 p0, vec3 p1, vec3 p2, vec3 b210, vec3 b120, vec3 b021, vec3 b012,
                       vec3 b102, vec3 b201) {
  glark_precise float w = weights.x;
  glark_precise float u = weights.y;
  glark_precise float v = weights.z;
  if (p0 == p1 && p1 == p2) return p0;
  if (p0 == p1) return glark_phong_curve(shape, p1, p2, b021, b012, w + u, v);
  if (p1 == p2) return glark_phong_curve(shape, p2, p0, b102, b201, u + v, w);
  if (p2 == p0) return glark_phong_curve(shape, p0, p1, b210, b120, v + w, u);
  glark_precise vec3 flat_position = (w * p0 + u * p1) + v * p2;
  glark_precise vec3 bent =
      ((w * u) * glark_phong_bend(p0, p1, b210, b120) + (u * v) * glark_phong_bend(p1, p2, b021, b012)) +
      (v * w) * glark_phong_bend(p2, p0, b102, b201);
  glark_precise vec3 position = flat_position + shape * bent;
  return position;
}

void glark_phong_slopes(vec3 weights, float shape, vec3 p0, vec3 p1, vec3 p2, vec3 b210, vec3 b120, vec3 b021, vec3 b012,
                        vec3 b102, vec3 b201, out vec3 along_u, out vec3 along_v) {
  vec3 bend01 = glark_phong_bend(p0, p1, b210, b120);
  vec3 bend12 = glark_phong_bend(p1, p2, b021, b012);
  vec3 bend20 = glark_phong_bend(p2, p0, b102, b201);
  along_u = (p1 - p0) + shape * ((weights.x - weights.y) * bend01 + weights.z * (bend12 - bend20));
  along_v = (p2 - p0) + shape * ((weights.x - weights.z) * bend20 + weights.y * (bend12 - bend01));
}
