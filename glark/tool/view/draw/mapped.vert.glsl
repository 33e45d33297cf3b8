// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The surface of a model with maps. Where OpenGL displaces it, gl_Vertex and gl_Normal are those of the displaced surface.
// The normal map is relative to the surface that is not displaced, so its normal comes a second time.
#version 130
in vec3 base_direction;
in vec4 tangent;

out vec3 surface_normal;
out vec3 base_normal;
out vec4 base_tangent;
out vec2 place;

void main() {
  gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
  surface_normal = gl_NormalMatrix * gl_Normal;
  base_normal = gl_NormalMatrix * base_direction;
  base_tangent = vec4(gl_NormalMatrix * tangent.xyz, tangent.w);
  place = gl_MultiTexCoord0.xy;
}
