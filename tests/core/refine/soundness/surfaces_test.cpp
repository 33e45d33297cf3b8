// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Vertex stages that are functions on a surface, and must stay refined by their inputs.
#include "tests/core/refine/soundness/soundness_harness.h"

namespace glark::refine {
namespace {

TEST(Surfaces, LightingByVertex) {
  const std::string source = R"(#version 120
varying vec3 eye;
void main() {
  vec3 n = normalize(gl_NormalMatrix * gl_Normal);
  eye = vec3(gl_ModelViewMatrix * gl_Vertex);
  vec3 l = normalize(gl_LightSource[0].position.xyz - eye);
  float diffuse = max(dot(n, l), 0.0);
  vec4 color = gl_FrontLightModelProduct.sceneColor + gl_FrontLightProduct[0].diffuse * diffuse;
  if (diffuse > 0.0) {
    vec3 h = normalize(l - normalize(eye));
    color += gl_FrontLightProduct[0].specular * pow(max(dot(n, h), 0.0), gl_FrontMaterial.shininess);
  }
  gl_FrontColor = color;
  gl_TexCoord[0] = gl_TextureMatrix[0] * gl_MultiTexCoord0;
  gl_Position = ftransform();
})";
  const StageVariation stage = variation_of({source});
  EXPECT_EQ(output_of(stage, "gl_Position"), Variation::affine);
  EXPECT_EQ(output_of(stage, "eye"), Variation::affine);
  EXPECT_EQ(output_of(stage, "gl_TexCoord"), Variation::affine);
  EXPECT_EQ(output_of(stage, "gl_FrontColor"), Variation::switched);
}

TEST(Surfaces, SkinningByMatricesOfTheVertex) {
  EXPECT_EQ(position_of(R"(#version 330
in vec3 p; in vec2 weights; uniform mat4 upper, lower, projection;
void main() { gl_Position = projection * (weights.x * (upper * vec4(p, 1)) + weights.y * (lower * vec4(p, 1))); })"),
            Variation::continuous);
}

TEST(Surfaces, Instances) {
  EXPECT_EQ(position_of(R"(#version 330
in vec3 p; in vec3 n; uniform mat4 camera; uniform samplerBuffer places; out vec3 normal;
void main() {
  vec4 offset = texelFetch(places, gl_InstanceID);
  normal = n;
  gl_Position = camera * vec4(p * offset.w + offset.xyz, 1.0);
})"),
            Variation::affine);
  EXPECT_EQ(position_of(R"(#version 330
layout(location = 0) in vec3 p; layout(location = 4) in mat4 model; uniform mat4 camera;
void main() { gl_Position = camera * model * vec4(p, 1.0); })"),
            Variation::continuous);
}

TEST(Surfaces, MorphTargets) {
  EXPECT_EQ(position_of(R"(#version 330
in vec3 p; in vec3 n; in vec3 target[4]; uniform float weight[4]; uniform mat4 m;
void main() {
  vec3 at = p;
  for (int i = 0; i < 4; ++i) at += weight[i] * (target[i] - p);
  gl_Position = m * vec4(at, 1.0);
})"),
            Variation::affine);
  EXPECT_EQ(position_of(R"(#version 110
attribute vec3 next; uniform float time;
void main() { gl_Position = gl_ModelViewProjectionMatrix * mix(gl_Vertex, vec4(next, 1.0), time); })"),
            Variation::affine);
}

TEST(Surfaces, Wind) {
  EXPECT_EQ(position_of(R"(#version 330
in vec3 p; in vec3 n; in vec2 uv; in float stiffness; uniform float time; uniform mat4 m; out vec2 at;
vec3 sway(vec3 v, float amount) { return v + vec3(sin(time + v.x * 0.3), 0.0, cos(time * 0.7 + v.z)) * amount; }
void main() { at = uv; gl_Position = m * vec4(sway(p, (1.0 - stiffness) * uv.y), 1.0); })"),
            Variation::continuous);
}

TEST(Surfaces, HeightMaps) {
  EXPECT_EQ(position_of(R"(#version 330
in vec2 at; uniform sampler2D height; uniform mat4 m;
void main() { gl_Position = m * vec4(at.x, textureLod(height, at, 0.0).r, at.y, 1.0); })"),
            Variation::continuous);
}

TEST(Surfaces, ShadowCoordinatesAndTangents) {
  const StageVariation stage = variation_of({R"(#version 330
layout(location = 0) in vec3 p; layout(location = 1) in vec3 n; layout(location = 2) in vec4 tangent;
uniform mat4 model, view_projection, light[4]; uniform vec3 camera;
out vec4 shadow[4]; out mat3 frame; out vec3 view; out float fog;
void main() {
  vec4 world = model * vec4(p, 1.0);
  for (int i = 0; i < 4; i++) shadow[i] = light[i] * world;
  vec3 N = normalize(mat3(model) * n); vec3 T = normalize(mat3(model) * tangent.xyz);
  frame = mat3(T, cross(N, T) * tangent.w, N);
  view = camera - world.xyz;
  fog = clamp((length(view) - 10.0) / 50.0, 0.0, 1.0);
  gl_Position = view_projection * world;
})"});
  EXPECT_EQ(output_of(stage, "shadow"), Variation::affine);
  EXPECT_EQ(output_of(stage, "view"), Variation::affine);
  EXPECT_EQ(output_of(stage, "fog"), Variation::continuous);
  EXPECT_EQ(output_of(stage, "frame"), Variation::continuous);
  EXPECT_EQ(output_of(stage, "gl_Position"), Variation::affine);
}

// Both functions are linked, one is called.
TEST(Surfaces, FunctionsThatAreNotCalledDoNotCount) {
  const std::string source = R"(#version 330
in vec3 pos; in vec3 nor; uniform mat4 m; out vec3 normal;
vec4 point_of_hair() { return vec4(float(gl_VertexID / 2), 0.0, 0.0, 1.0); }
vec4 point_of_mesh() { return vec4(pos, 1.0); }
void main() { normal = nor; gl_Position = m * point_of_mesh(); })";
  const Inspection inspection = inspect_vertex_stage({source}, false);
  EXPECT_EQ(output_of(inspection.traits.variation, "gl_Position"), Variation::affine);
  EXPECT_FALSE(inspection.traits.reads_vertex_id);
  EXPECT_TRUE(inspection.traits.system_values.empty());
}

TEST(Surfaces, IntegersThatReachAnotherOutput) {
  const StageVariation stage = variation_of({R"(#version 330
in vec3 p; in vec3 n; in int part; uniform mat4 m; uniform vec4 palette[8]; flat out int id; out vec4 color;
void main() { id = part; color = palette[part]; gl_Position = m * vec4(p, 1.0); })"});
  EXPECT_EQ(output_of(stage, "gl_Position"), Variation::affine);
  EXPECT_EQ(output_of(stage, "color"), Variation::undefined);
}

TEST(Surfaces, TranslatedRegisters) {
  EXPECT_EQ(position_of(R"(#version 120
uniform vec4 c[96]; attribute vec4 in0; attribute vec4 in1; attribute vec4 in2; varying vec4 out1;
vec4 R0; vec4 R1;
void main() {
  R0.xyz = in1.xyz * 2.0 - 1.0;
  R0.w = fract(in2.x);
  out1 = R0;
  R0.x = dot(in0, c[0]); R0.y = dot(in0, c[1]); R0.z = dot(in0, c[2]); R0.w = dot(in0, c[3]);
  gl_Position.xyz = R0.xyz;
  gl_Position.w = R0.w;
  gl_Position.z = gl_Position.z * 2.0 - gl_Position.w;
})"),
            Variation::affine);
}

}  // namespace
}  // namespace glark::refine
