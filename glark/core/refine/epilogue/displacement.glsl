// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Displacement along the normal; include after pn.glsl and scalar_tagged_pn.glsl. The including unit defines
// glark_texel(coordinate), the scaled and biased texel, and glark_texel_size().
// Based on: J. F. Blinn, Simulation of wrinkled surfaces, SIGGRAPH 1978: the normal of P + D N, from the derivatives of
// P, D and N.
//
// Watertight: the displaced position depends on the refined inputs, which triangles share along edges. Where normals or
// texture coordinates jump, it depends on the border values that welding has found.

bool glark_on_border(vec3 weights) { return weights.x == 0.0 || weights.y == 0.0 || weights.z == 0.0; }

// `at0` to `at2`: the coordinates at the corners' positions; `along0` to `along2`: the coordinates at the ends of each
// edge.
vec2 glark_border_coordinate(vec3 weights, vec2 at0, vec2 at1, vec2 at2, vec4 along0, vec4 along1, vec4 along2) {
  if (weights.x == 1.0) return at0;
  if (weights.y == 1.0) return at1;
  if (weights.z == 1.0) return at2;
  vec4 along = weights.z == 0.0 ? along0 : (weights.x == 0.0 ? along1 : along2);
  vec2 ends = weights.z == 0.0 ? weights.xy : (weights.x == 0.0 ? weights.yz : weights.zx);
  glark_precise vec2 coordinate = ends.x * along.xy + ends.y * along.zw;
  return coordinate;
}

vec3 glark_displaced_position(vec3 position, vec3 normal, vec2 coordinate) {
  glark_precise vec3 displaced = position + glark_texel(coordinate) * glark_pn_unit(normal);
  return displaced;
}

// Derivatives by u and v (w = 1 - u - v): of the surface before displacement, and of a field of length `size` that is
// parallel to its normal.
struct glark_Slopes {
  vec3 position_u;
  vec3 position_v;
  vec3 normal_u;
  vec3 normal_v;
  float size;
};

glark_Slopes glark_linear_slopes(vec3 weights, glark_StCorner c0, glark_StCorner c1, glark_StCorner c2) {
  glark_Slopes slopes;
  slopes.position_u = c1.position.xyz - c0.position.xyz;
  slopes.position_v = c2.position.xyz - c0.position.xyz;
  slopes.normal_u = c1.given - c0.given;
  slopes.normal_v = c2.given - c0.given;
  slopes.size = length((weights.x * c0.given + weights.y * c1.given) + weights.z * c2.given);
  return slopes;
}

// Slopes of the patch that glark_st_position and glark_st_normal have evaluated. Points are relative to corner 0, which
// keeps errors small.
glark_Slopes glark_curved_slopes(vec3 weights, glark_StCorner c0, glark_StCorner c1, glark_StCorner c2) {
  float w = weights.x;
  float u = weights.y;
  float v = weights.z;
  vec3 origin = c0.position.xyz;
  vec3 p1 = c1.position.xyz - origin;
  vec3 p2 = c2.position.xyz - origin;
  vec3 b210 = glark_st_b210 - 3.0 * origin;
  vec3 b120 = glark_st_b120 - 3.0 * origin;
  vec3 b021 = glark_st_b021 - 3.0 * origin;
  vec3 b012 = glark_st_b012 - 3.0 * origin;
  vec3 b102 = glark_st_b102 - 3.0 * origin;
  vec3 b201 = glark_st_b201 - 3.0 * origin;
  vec3 middle = 0.5 * (((b210 + b120) + (b021 + b012)) + (b102 + b201)) - (p1 + p2);
  vec3 by_w = 2.0 * w * (u * b210 + v * b201) + (u * u) * b120 + (v * v) * b102 + (u * v) * middle;
  vec3 by_u = 3.0 * (u * u) * p1 + 2.0 * u * (w * b120 + v * b021) + (w * w) * b210 + (v * v) * b012 + (w * v) * middle;
  vec3 by_v = 3.0 * (v * v) * p2 + 2.0 * v * (u * b012 + w * b102) + (u * u) * b021 + (w * w) * b201 + (w * u) * middle;
  vec3 n0 = glark_pn_unit(glark_st_n0);
  vec3 n1 = glark_pn_unit(glark_st_n1);
  vec3 n2 = glark_pn_unit(glark_st_n2);
  vec3 n110 = glark_pn_edge_normal(vec3(0.0), n0, p1, n1);
  vec3 n011 = glark_pn_edge_normal(p1, n1, p2, n2);
  vec3 n101 = glark_pn_edge_normal(p2, n2, vec3(0.0), n0);
  vec3 normal_by_w = 2.0 * w * n0 + u * n110 + v * n101;
  vec3 normal_by_u = 2.0 * u * n1 + w * n110 + v * n011;
  vec3 normal_by_v = 2.0 * v * n2 + u * n011 + w * n101;
  glark_Slopes slopes;
  slopes.position_u = by_u - by_w;
  slopes.position_v = by_v - by_w;
  slopes.normal_u = normal_by_u - normal_by_w;
  slopes.normal_v = normal_by_v - normal_by_w;
  slopes.size = 0.5 * length((w * normal_by_w + u * normal_by_u) + v * normal_by_v);
  return slopes;
}

// The derivative of the unit normal, from the derivative of a field of length `size`.
vec3 glark_turn(vec3 unit_normal, vec3 slope, float size) {
  return size > 0.0 ? (slope - dot(unit_normal, slope) * unit_normal) / size : vec3(0.0);
}

// `along_u`, `along_v`: the texture coordinates of corners 1 and 2, less that of corner 0.
vec3 glark_displaced_normal(glark_Slopes slopes, vec3 normal, vec2 coordinate, vec2 along_u, vec2 along_v) {
  vec3 n = glark_pn_unit(normal);
  float displacement = glark_texel(coordinate);
  vec3 tangent_u = slopes.position_u + displacement * glark_turn(n, slopes.normal_u, slopes.size);
  vec3 tangent_v = slopes.position_v + displacement * glark_turn(n, slopes.normal_v, slopes.size);
  vec2 texel = glark_texel_size();
  vec2 half_s = vec2(0.5 * texel.x, 0.0);
  vec2 half_t = vec2(0.0, 0.5 * texel.y);
  vec2 slope = vec2(glark_texel(coordinate + half_s) - glark_texel(coordinate - half_s),
                    glark_texel(coordinate + half_t) - glark_texel(coordinate - half_t)) / texel;
  float area = dot(n, cross(tangent_u, tangent_v));
  vec3 rise = dot(slope, along_u) * cross(tangent_v, n) + dot(slope, along_v) * cross(n, tangent_u);
  // If there is no area, or if the surface stands on its edge, the normal stays.
  if (!(abs(area) > 1.0e-6 * length(tangent_u) * length(tangent_v))) return normal;
  return glark_pn_unit(n - rise / area) * length(normal);
}
