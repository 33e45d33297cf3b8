// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Lesson 8: displacement. Eight triangles become craters by a height map, then waves by a refinement shader. Three more
// shaders have the errors that one makes; the program prints what the library says about them.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "examples/common/lesson.h"
#include "examples/common/look.h"

namespace {

constexpr unsigned deepest = 7;
constexpr int map_size = 256;
unsigned depth = 6;
std::size_t chosen = 0;
bool wireframe = false;

// [waves]
constexpr const char* waves = R"glsl(
void refine() {
  float r = max(length(gl_Vertex.xz), 1e-4);
  gl_Vertex.y += 0.1 * cos(16.0 * r);
  float slope = -1.6 * sin(16.0 * r);
  gl_Normal = normalize(vec3(-slope * gl_Vertex.x / r, 1.0, -slope * gl_Vertex.z / r));
}
)glsl";
// [/waves]

// [errors]
constexpr const char* old_normal = R"glsl(
void refine() { gl_Vertex.y += 0.1 * cos(16.0 * length(gl_Vertex.xz)); }
)glsl";

constexpr const char* misspelled = R"glsl(
void refine() {
  float r = length(gl_Vertex.xz);
  gl_Vertex.y += 0.1 * cos(16.0 * radius);
}
)glsl";

constexpr const char* version = R"glsl(#version 120
void refine() { gl_Vertex.y += 0.1; }
)glsl";
// [/errors]

constexpr std::array<const char*, 5> shaders = {nullptr, waves, old_normal, misspelled, version};

// [use]
// Program 0 is the fixed function. The library says whether a shader builds, and why not.
void use(const char* source) {
  glRefinementShaderSourceARK(0, source != nullptr ? 1 : 0, &source, nullptr);
  GLint built = GL_FALSE;
  glGetRefinementivARK(0, GL_REFINEMENT_STATUS_ARK, &built);
  if (built == GL_TRUE) return;
  std::string log(4096, '\0');
  glGetRefinementInfoLogARK(0, static_cast<GLsizei>(log.size()), nullptr, log.data());
  std::printf("%s\n", log.c_str());
  glRefinementShaderSourceARK(0, 0, nullptr, nullptr);  // none: the sheet stays flat
}
// [/use]

// A height map of round craters with rims. Each has its middle and its radius.
float crater_height(float s, float t) {
  constexpr std::array<std::array<float, 3>, 5> craters = {
      {{0.3F, 0.35F, 0.2F}, {0.7F, 0.65F, 0.24F}, {0.72F, 0.22F, 0.12F}, {0.25F, 0.78F, 0.14F}, {0.5F, 0.48F, 0.07F}}};
  float height = 0.5F;
  for (const auto& [middle_s, middle_t, radius] : craters) {
    const float r = std::hypot(s - middle_s, t - middle_t) / radius;
    height += radius * (1.4F * std::exp(-12 * (r - 1) * (r - 1)) - 2.2F * std::exp(-3 * r * r * r * r));
  }
  return height;
}

void upload_height_map() {
  std::vector<float> heights;
  for (int t = 0; t < map_size; ++t)
    for (int s = 0; s < map_size; ++s)
      heights.push_back(crater_height(static_cast<float>(s) / map_size, static_cast<float>(t) / map_size));
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, map_size, map_size, 0, GL_RED, GL_FLOAT, heights.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
}

void draw_sheet() {
  glDepthTag1i(depth);
  glNormal3f(0, 1, 0);
  for (const float z : {-1.0F, 0.0F}) {
    glBegin(GL_TRIANGLE_STRIP);
    for (const float x : {-1.0F, 0.0F, 1.0F}) {
      for (const float side : {z, z + 1}) {
        glTexCoord2f(0.5F + 0.5F * x, 0.5F + 0.5F * side);
        glVertex3f(x, 0, side);
      }
    }
    glEnd();
  }
}

// [draw]
void draw(double) {
  glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, chosen == 0 ? 0 : -1);  // texture image unit 0, or no displacement
  glARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.8F);                 // a height of 1 in the map is 0.8 long
  glARKParameterfARK(GL_DISPLACEMENT_BIAS_ARK, -0.4F);                 // a height of 0.5 stays in the plane
  lesson::look(3.4F, 20, 40);
  lesson::light();
  glColor3f(0.45F, 0.65F, 0.8F);
  if (wireframe) lesson::draw_with_edges(draw_sheet);
  if (!wireframe) draw_sheet();
  lesson::say("%s, depth %u", chosen == 0 ? "a height map" : "a refinement shader", depth);
}
// [/draw]

void begin() {
  upload_height_map();
  glARKinit(deepest);
  glEnable(GL_ARK);
}

void choose(std::size_t shader) {
  chosen = shader;
  use(shaders.at(shader));
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv,
                     {.title = "Lesson 8: displacement",
                      .keys = {{'d', "one level deeper", [] { depth = std::min(depth + 1, deepest); }},
                               {'s', "one level shallower", [] { depth -= depth > 0 ? 1 : 0; }},
                               {'0', "the height map", [] { choose(0); }},
                               {'1', "a refinement shader: waves", [] { choose(1); }},
                               {'2', "waves with the old normal", [] { choose(2); }},
                               {'3', "a misspelled word", [] { choose(3); }},
                               {'4', "a version where none belongs", [] { choose(4); }},
                               {'w', "wireframe", [] { wireframe = !wireframe; }}},
                      .begin = begin,
                      .draw = draw});
}
