// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Vertex stages that are no functions on a surface: attributes are names of corners, of bones or of glyphs.
#include "tests/core/refine/soundness/soundness_harness.h"

namespace glark::refine {
namespace {

// A sphere as a quad. The fourth coordinate has the number of the corner and the radius in one float.
constexpr const char* sphere_of_packed_corners = R"(#version 120
attribute vec4 center_and_flags;
attribute vec4 tint;
uniform float scale;
varying vec3 middle;
varying float radius;
void main() {
  float flags = mod(center_and_flags.w, 4.0);
  radius = (center_and_flags.w - flags) * 0.25 * scale;
  float right = 2.0 * mod(flags, 2.0) - 1.0;
  float up = 2.0 * floor(flags / 2.0) - 1.0;
  vec4 eye = gl_ModelViewMatrix * vec4(center_and_flags.xyz, 1.0);
  middle = eye.xyz;
  eye.xy += radius * vec2(right, up);
  gl_FrontColor = tint;
  gl_Position = gl_ProjectionMatrix * eye;
})";

TEST(Impostors, SpheresWithPackedCorners) {
  EXPECT_EQ(position_of(sphere_of_packed_corners), Variation::undefined);
  EXPECT_EQ(reason_of(sphere_of_packed_corners), "line 8: mod() of 'center_and_flags'");
  EXPECT_EQ(output_of(variation_of({sphere_of_packed_corners}), "gl_FrontColor"), Variation::affine);
}

// A stick whose corners are chosen by branches.
TEST(Impostors, SticksWithBranches) {
  EXPECT_EQ(position_of(R"(#version 150
in vec3 start; in vec3 axis; in float corner; in float width;
uniform mat4 view; uniform mat4 projection;
out vec3 surface_point;
void main() {
  vec3 side = normalize(cross(axis, vec3(0.0, 0.0, 1.0)));
  vec3 at = start;
  if (corner > 0.5) at += axis;
  if (corner > 1.5) { side = -side; }
  at += side * width;
  surface_point = at;
  gl_Position = projection * view * vec4(at, 1.0);
})"),
            Variation::switched);
}

// Corners by gl_VertexID, as billboards of points and of glyphs do.
TEST(Impostors, BillboardsByVertexNumber) {
  EXPECT_EQ(position_of(R"(#version 330
layout(location = 0) in vec3 center;
uniform mat4 view_projection; uniform vec3 right, up;
out vec2 uv;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, (gl_VertexID >> 1) & 1);
  uv = corner;
  corner = 2.0 * corner - 1.0;
  gl_Position = view_projection * vec4(center + corner.x * right + corner.y * up, 1.0);
})"),
            Variation::undefined);
  EXPECT_EQ(position_of(R"(#version 300 es
const vec2 corners[4] = vec2[4](vec2(0), vec2(1, 0), vec2(0, 1), vec2(1));
void main() { gl_Position = vec4(corners[gl_VertexID] * 2.0 - 1.0, 0.0, 1.0); })",
                        true),
            Variation::undefined);
}

// A rectangle that widens by a pixel on the sides that an attribute names.
TEST(Impostors, AntialiasedRectangles) {
  const std::string source = R"(#version 150
in vec2 place; in float side; in vec4 paint;
uniform mat4 matrix; uniform vec2 pixel;
out float coverage; out vec4 shade;
void main() {
  vec4 clip = matrix * vec4(place, 0.0, 1.0);
  float left = mod(side, 2.0);
  coverage = fract(side * 0.5) < 0.25 ? 1.0 : 0.0;
  clip.xy += (left * 2.0 - 1.0) * pixel * clip.w;
  shade = paint;
  gl_Position = clip;
})";
  EXPECT_EQ(position_of(source), Variation::undefined);
  EXPECT_EQ(output_of(variation_of({source}), "coverage"), Variation::undefined);
  EXPECT_EQ(output_of(variation_of({source}), "shade"), Variation::affine);
}

// Glyphs: the instance has the cell, the vertex has its number.
TEST(Impostors, CellsOfText) {
  EXPECT_EQ(position_of(R"(#version 140
#extension GL_ARB_explicit_attrib_location : enable
in uvec3 colors; in uvec4 sprite;
uniform CellData { float xstart, ystart, dx, dy; uint columns; };
const uvec2 places[4] = uvec2[4](uvec2(1, 0), uvec2(1, 1), uvec2(0, 1), uvec2(0, 0));
out vec3 sprite_place; flat out uint ink;
void main() {
  uint row = uint(gl_InstanceID) / columns;
  uint column = uint(gl_InstanceID) - row * columns;
  float left = xstart + float(column) * dx;
  vec2 x = vec2(left, left + dx);
  vec2 y = vec2(ystart - float(row) * dy, ystart - float(row + 1u) * dy);
  uvec2 place = places[gl_VertexID];
  gl_Position = vec4(x[place.x], y[place.y], 0, 1);
  sprite_place = vec3(vec2(place), float(sprite.z));
  ink = colors.x;
})"),
            Variation::undefined);
}

// An overlay line that is widened by the vertex's number, and an edge that is hidden by its class.
TEST(Impostors, WideLinesAndHiddenEdges) {
  const std::string source = R"(#version 330
in vec3 pos; in int edge_class; in float sharpness;
uniform mat4 object_to_clip; uniform float threshold;
flat out vec4 final_color;
void main() {
  gl_Position = object_to_clip * vec4(pos, 1.0);
  bool hidden = edge_class == 2 || sharpness > threshold;
  if (hidden) gl_Position = vec4(0.0);
  final_color = (edge_class & 1) != 0 ? vec4(1.0, 0.5, 0.0, 1.0) : vec4(0.0, 0.0, 0.0, 1.0);
})";
  EXPECT_EQ(position_of(source), Variation::undefined);
}

TEST(Impostors, BonesByNumber) {
  EXPECT_EQ(reason_of(R"(#version 330
in vec3 p; in vec3 normal; in ivec4 joints; in vec4 weights;
uniform mat4 bones[64];
void main() {
  mat4 skin = mat4(0.0);
  for (int i = 0; i < 4; ++i) skin += weights[i] * bones[joints[i]];
  gl_Position = skin * vec4(p, 1.0);
})"),
            "line 6: integer value of 'joints'");
  EXPECT_EQ(position_of(R"(#version 110
attribute vec4 joints; attribute vec4 weights; uniform mat4 bones[64];
mat4 bone(float i) { return bones[int(i)]; }
void main() { gl_Position = (bone(joints.x) * weights.x + bone(joints.y) * weights.y) * gl_Vertex; })"),
            Variation::undefined);
}

// Register machines that translate other languages use one variable for many things.
TEST(Impostors, TranslatedRegistersOfPackedBones) {
  EXPECT_EQ(position_of(R"(#version 120
uniform vec4 c[96];
attribute vec4 in0; attribute vec4 in1;
ivec4 A0; vec4 R0; vec4 R1;
void main() {
  R0.xy = in1.xy * c[2].w;
  A0.x = int(floor(R0.x + 0.5));
  R1 = in0;
  R0.x = dot(R1, c[A0.x + 8]);
  R0.y = dot(R1, c[A0.x + 9]);
  R0.z = dot(R1, c[A0.x + 10]);
  R0.w = 1.0;
  gl_Position.x = dot(R0, c[0]); gl_Position.y = dot(R0, c[1]);
  gl_Position.z = dot(R0, c[2]); gl_Position.w = dot(R0, c[3]);
})"),
            Variation::undefined);
}

TEST(Impostors, QuadsThatAreFetched) {
  EXPECT_EQ(position_of(R"(#version 430
layout(location = 0) in vec2 cell;
layout(std430, binding = 0) readonly buffer Nodes { vec4 nodes[]; };
uniform isampler2D links;
void main() { gl_Position = nodes[texture(links, cell).x]; })"),
            Variation::undefined);
  EXPECT_EQ(position_of(R"(#version 330
in vec2 texel; uniform sampler2D places;
void main() { gl_Position = texelFetch(places, ivec2(texel), 0); })"),
            Variation::undefined);
}

// A float attribute names the part that a vertex belongs to. The stage discards the vertices of one part.
TEST(Impostors, FloatsThatAreCompared) {
  EXPECT_EQ(position_of(R"(#version 110
attribute float part; uniform float hidden_part;
void main() {
  gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
  if (part == hidden_part) gl_Position.w = -1.0;
})"),
            Variation::undefined);
}

}  // namespace
}  // namespace glark::refine
