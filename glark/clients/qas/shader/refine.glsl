// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The quadratic through three corners and three edge midpoints, for positions and for normals. Its control points
// follow from the six points (9.2.3). Substituting them gives these weights of the points themselves, which makes the
// fit unnecessary. On an edge, products of barycentric coordinates are exact, the terms of other edges are zero, and
// the terms of the two ends are added first. So the sum is the same from both sides of the edge, if no operations are
// fused.
//
// Based on: Boubekeur 2007, ch. 9.2.4, with the edge indices that the text of the chapter means.
#include "glark/clients/qas/shader/precise.glsl"
vec3 glark_qas_quadratic(vec3 c0, vec3 c1, vec3 c2, vec3 e01, vec3 e12, vec3 e20) {
  float w = ark_barycentric.x;
  float u = ark_barycentric.y;
  float v = ark_barycentric.z;
  glark_qas_precise vec3 corners = ((w * (2.0 * w - 1.0)) * c0 + (u * (2.0 * u - 1.0)) * c1) + (v * (2.0 * v - 1.0)) * c2;
  glark_qas_precise vec3 edges = ((4.0 * (w * u)) * e01 + (4.0 * (u * v)) * e12) + (4.0 * (v * w)) * e20;
  glark_qas_precise vec3 sum = corners + edges;
  return sum;
}
