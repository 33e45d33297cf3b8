// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Lights a model with maps as the fixed functions light plain ones: one light at infinity, the eye at infinity, both
// sides. Colours are used as they are stored, like the colours of points.
#version 130
uniform sampler2D colours, normals;
uniform bool has_colours, has_normals;
uniform vec3 colour;  // without a texture

in vec3 surface_normal;
in vec3 base_normal;
in vec4 base_tangent;
in vec2 place;

// The normal map's x is along the tangent, its y along the bitangent: up in the picture. Tangent, bitangent and normal
// are scaled to unit length between the vertices, as glark bake assumes.
vec3 mapped_normal() {
  vec3 texel = texture(normals, place).xyz * 2.0 - 1.0;
  vec3 normal = normalize(base_normal), tangent = normalize(base_tangent.xyz);
  vec3 bitangent = base_tangent.w * normalize(cross(normal, tangent));
  return texel.x * tangent + texel.y * bitangent + texel.z * normal;
}

void main() {
  vec3 n = normalize(has_normals ? mapped_normal() : surface_normal);
  if (!gl_FrontFacing) n = -n;
  vec3 to_light = normalize(gl_LightSource[0].position.xyz);
  vec3 base = has_colours ? texture(colours, place).xyz : colour;
  float diffuse = dot(n, to_light);
  vec3 lit = base * (gl_LightModel.ambient.xyz + max(diffuse, 0.0));
  if (diffuse > 0.0) {
    vec3 halfway = normalize(to_light + vec3(0.0, 0.0, 1.0));
    lit += gl_FrontMaterial.specular.xyz * pow(max(dot(n, halfway), 0.0), gl_FrontMaterial.shininess);
  }
  gl_FragColor = vec4(lit, 1.0);
}
