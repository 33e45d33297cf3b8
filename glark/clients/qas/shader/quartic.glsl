// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The quartic through 15 points, for positions and for normals. Each corner has a matrix: its columns are the point of
// the corner and the points at 1/4, 2/4 and 3/4 of the edge to the next corner; its last row is the inner point next to
// the corner. On an edge, the terms of other edges are zero, and the terms of the two ends are added first. So the sum
// is the same from both sides.
#include "glark/clients/qas/shader/precise.glsl"
// Returns the weights 1 to 4 of quartic_weights() in quartic.h.
vec4 glark_qas_weights(float x) {
  glark_qas_precise float x4 = 4.0 * x;
  glark_qas_precise float second = 0.5 * x4 * (x4 - 1.0);
  glark_qas_precise float third = second * (x4 - 2.0) / 3.0;
  glark_qas_precise float fourth = third * (x4 - 3.0) / 4.0;
  return vec4(x4, second, third, fourth);
}
vec3 glark_qas_edge(mat4 from, vec4 a, vec4 b) {
  glark_qas_precise vec3 sum =
      ((a.z * b.x) * from[1].xyz + (a.x * b.z) * from[3].xyz) + (a.y * b.y) * from[2].xyz;
  return sum;
}
vec3 glark_qas_inner(mat4 c) { return vec3(c[0].w, c[1].w, c[2].w); }
vec3 glark_qas_quartic(mat4 c0, mat4 c1, mat4 c2) {
  vec4 w = glark_qas_weights(ark_barycentric.x);
  vec4 u = glark_qas_weights(ark_barycentric.y);
  vec4 v = glark_qas_weights(ark_barycentric.z);
  glark_qas_precise vec3 corners = (w.w * c0[0].xyz + u.w * c1[0].xyz) + v.w * c2[0].xyz;
  glark_qas_precise vec3 edges = (glark_qas_edge(c0, w, u) + glark_qas_edge(c1, u, v)) + glark_qas_edge(c2, v, w);
  glark_qas_precise vec3 inside =
      ((w.y * (u.x * v.x)) * glark_qas_inner(c0) + (u.y * (v.x * w.x)) * glark_qas_inner(c1)) +
      (v.y * (w.x * u.x)) * glark_qas_inner(c2);
  glark_qas_precise vec3 sum = (corners + edges) + inside;
  return sum;
}
