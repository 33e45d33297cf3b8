// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Procedural displacement: a coarse ground of 128 triangles, and a refinement shader that computes the height of every
// point. The height is the sum of six octaves of noise. There is no texture and no fine mesh. Vertices near the eye
// have greater depth tags. The program uses OpenGL ES 3.2.
//
//   noise_terrain [OUT.png]
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "examples/common/lesson.h"
#include "examples/common/look.h"
#include "examples/common/program.h"

namespace {

constexpr unsigned cells = 8;  // number of cells along a side of the ground
constexpr unsigned max_level = 6;

constexpr const char* vertex_shader = R"glsl(#version 320 es
in vec2 place;  // to the right, and away from the eye
uniform mat4 projection;
uniform mat4 view;
out vec3 color;
float height = 0.0;
vec3 normal = vec3(0.0, 1.0, 0.0);
vec3 ground = vec3(0.5);
void main() {
  color = ground * (0.25 + 0.75 * max(0.0, dot(normal, normalize(vec3(-0.8, 0.6, -0.25)))));
  gl_Position = projection * view * vec4(place.x, height, -place.y, 1.0);
})glsl";

constexpr const char* fragment_shader = R"glsl(#version 320 es
precision highp float;
in vec3 color;
out vec4 pixel;
void main() { pixel = vec4(color, 1.0); }
)glsl";

// Value noise with its derivative, so that the normal is exact. The absolute value makes ridges.
constexpr const char* mountains = R"glsl(
float random(vec2 cell) {
  vec3 p = fract(vec3(cell.xyx) * 0.1031);
  p += dot(p, p.yzx + 33.33);
  return fract((p.x + p.y) * p.z);
}

vec3 noise(vec2 at) {  // height, and slopes along x and y
  vec2 cell = floor(at);
  vec2 f = at - cell;
  vec2 blend = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  vec2 slope = 30.0 * f * f * (f * (f - 2.0) + 1.0);
  float a = random(cell);
  float b = random(cell + vec2(1.0, 0.0)) - a;
  float c = random(cell + vec2(0.0, 1.0)) - a;
  float d = random(cell + vec2(1.0, 1.0)) - a - b - c;
  return vec3(a + b * blend.x + c * blend.y + d * blend.x * blend.y, slope * (vec2(b, c) + d * blend.yx));
}

void refine() {
  vec3 sum = vec3(0.0);
  float amplitude = 1.1;
  float frequency = 0.7;
  for (int octave = 0; octave < 6; ++octave) {
    vec3 wave = noise(place * frequency + 7.0 * float(octave)) - vec3(0.5, 0.0, 0.0);
    float ridge = wave.x < 0.0 ? -1.0 : 1.0;
    sum += amplitude * vec3(0.25 - ridge * wave.x, -ridge * frequency * wave.yz);
    amplitude *= 0.45;
    frequency *= 2.1;
  }
  height = sum.x;
  normal = normalize(vec3(-sum.y, 1.0, sum.z));
  ground = mix(vec3(0.35, 0.5, 0.25), vec3(0.95), smoothstep(0.15, 0.75, sum.x + 0.3 * normal.y));
}
)glsl";

GLuint program = 0;
GLsizei indices = 0;

void begin() {
  std::vector<std::array<float, 2>> places;
  std::vector<float> tags;
  std::vector<unsigned> triangles;
  for (unsigned j = 0; j <= cells; ++j) {
    for (unsigned i = 0; i <= cells; ++i) {
      places.push_back({static_cast<float>(i) - cells / 2.0F, static_cast<float>(j)});
      // At twice the distance, triangles have half as many segments. So segments have about one size on the screen.
      const float distance = std::hypot(places.back()[0], places.back()[1] + 1.5F);
      tags.push_back(std::clamp(max_level + 1 - std::log2(distance), 1.0F, 1.0F * max_level));
      const unsigned at = j * (cells + 1) + i;
      if (i == cells || j == cells) continue;
      triangles.insert(triangles.end(), {at, at + 1, at + cells + 2, at, at + cells + 2, at + cells + 1});
    }
  }
  indices = static_cast<GLsizei>(triangles.size());
  glARKinit(max_level);
  glEnable(GL_ARK);
  glEnable(GL_DEPTH_TEST);
  program = lesson::make_program(vertex_shader, fragment_shader, {"place"});
  lesson::set_refinement_shader(program, mountains);
  lesson::make_buffer(GL_ELEMENT_ARRAY_BUFFER, triangles);
  lesson::make_buffer(GL_ARRAY_BUFFER, places);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  glEnableVertexAttribArray(0);
  lesson::make_buffer(GL_ARRAY_BUFFER, tags);
  glDepthTagPointerARK(GL_FLOAT, 0, nullptr);
  glEnable(GL_DEPTH_TAG_ARRAY_ARK);
}

void draw(double) {
  lesson::Camera eye = lesson::camera(1, 0, 25);
  eye.view[13] -= 0.6F;  // the eye stands above the near end of the ground
  glClearColor(0.75F, 0.85F, 0.95F, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glUseProgram(program);
  lesson::set_uniform_matrix(program, "projection", eye.projection.data());
  lesson::set_uniform_matrix(program, "view", eye.view.data());
  glDrawElements(GL_TRIANGLES, indices, GL_UNSIGNED_INT, nullptr);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv,
                     {.title = "noise_terrain",
                      .keys = {},
                      .begin = begin,
                      .draw = draw,
                      .api = lesson::Api::gles,
                      .width = 800,
                      .height = 400});
}
