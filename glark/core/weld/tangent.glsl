// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The control points of the edges of curved PN triangles, in the words of GLSL 1.10. The unit that includes this
// defines the macro glark_precise. Control points are kept multiplied by 3, which saves the division.
// Based on: A. Vlachos, J. Peters, C. Boyd, J. L. Mitchell, Curved PN Triangles, I3D 2001, section 3.

// Zero where the vector is zero; scaled first, so that no square over- or underflows.
vec3 glark_pn_unit(vec3 v) {
  glark_precise float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
  if (!(largest > 0.0)) return vec3(0.0);
  glark_precise vec3 scaled = v / largest;
  glark_precise vec3 unit = scaled * inversesqrt(dot(scaled, scaled));
  return unit;
}

// 3 b210: the point a third of the way from `near` to `far`, projected into the tangent plane of `near`. The edge stays
// straight if the ends' w differ.
vec3 glark_pn_tangent(vec4 near, vec3 unit_normal, vec4 far) {
  glark_precise float height = near.w == far.w ? dot(far.xyz - near.xyz, unit_normal) : 0.0;
  glark_precise vec3 control = (2.0 * near.xyz + far.xyz) - height * unit_normal;
  return control;
}
