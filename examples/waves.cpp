// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Depth tags that change with every frame: rings of waves run outwards over a pond of 288 triangles. The refinement
// shader moves the refined vertices by a function of time. In the same frame, the CPU tags each coarse vertex by the
// bend of this function near it. So fine triangles travel with the waves.
// The program uses the core profile: shaders, vertex array objects and buffers. It compares the number of triangles of
// each frame with section 11.R.5 of the extension.
//
//   waves [OUT.png [--seconds 1]]
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "examples/common/lesson.h"
#include "examples/common/look.h"
#include "examples/common/program.h"

namespace {

constexpr unsigned cells = 12;
constexpr unsigned max_level = 4;

constexpr const char* vertex_shader = R"glsl(#version 430 core
in vec2 place;
uniform mat4 projection;
uniform mat4 view;
out float light;
float height = 0.0;
vec2 slope = vec2(0.0);
void main() {
  vec3 normal = normalize(vec3(-slope.x, 1.0, -slope.y));
  light = 0.35 + 0.65 * max(0.0, dot(normal, normalize(vec3(-0.6, 0.7, 0.4))));
  gl_Position = projection * view * vec4(place.x, height, place.y, 1.0);
})glsl";

constexpr const char* fragment_shader = R"glsl(#version 430 core
in float light;
out vec4 color;
void main() { color = vec4(vec3(0.35, 0.65, 0.85) * light, 1.0); }
)glsl";

// A packet of waves around the ring of radius `time`. refine() may also set globals of the vertex shader.
constexpr const char* refinement_shader = R"glsl(
uniform float time;
void refine() {
  float r = length(place);
  float packet = 0.16 * exp(-9.0 * (r - time) * (r - time));
  height = packet * cos(14.0 * (r - time));
  float rise = -packet * (14.0 * sin(14.0 * (r - time)) + 18.0 * (r - time) * cos(14.0 * (r - time)));
  slope = rise * place / max(r, 1e-4);
}
)glsl";

std::vector<std::array<float, 2>> places;
std::vector<unsigned char> tags;
std::vector<unsigned> indices;

void make_pond() {
  for (unsigned j = 0; j <= cells; ++j) {
    for (unsigned i = 0; i <= cells; ++i) {
      places.push_back({4.0F * static_cast<float>(i) / cells - 2, 4.0F * static_cast<float>(j) / cells - 2});
      const unsigned at = j * (cells + 1) + i;
      if (i == cells || j == cells) continue;
      indices.insert(indices.end(), {at, at + 1, at + cells + 2, at, at + cells + 2, at + cells + 1});
    }
  }
}

// The bend of the waves fades with the packet. At a quarter of the bend, segments may be twice as long.
void tag(float time) {
  tags.clear();
  for (const auto& [x, y] : places) {
    const float off = std::hypot(x, y) - time;
    const float depth = static_cast<float>(max_level) + std::log2(std::exp(-9.0F * off * off) + 1e-6F) / 2;
    tags.push_back(static_cast<unsigned char>(std::max(0.0F, depth)));
  }
}

// Section 11.R.5, where m is the least of the three edge depths.
unsigned expected_triangles() {
  unsigned sum = 0;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    std::array<unsigned, 3> segments{};
    for (std::size_t k = 0; k < 3; ++k)
      segments[k] = 1U << ((unsigned{tags[indices[i + k]]} + tags[indices[i + (k + 1) % 3]]) / 2);
    const unsigned least = *std::min_element(segments.begin(), segments.end());
    sum += (least - 1) * (least - 2) + segments[0] + segments[1] + segments[2] - 2;
  }
  return sum;
}

GLuint program = 0;
GLuint tag_buffer = 0;

void draw_pond() { glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, nullptr); }

void begin() {
  make_pond();
  glARKinit(max_level);
  glEnable(GL_ARK);
  glEnable(GL_DEPTH_TEST);
  program = lesson::make_program(vertex_shader, fragment_shader, {"place"});
  lesson::set_refinement_shader(program, refinement_shader);
  GLuint arrays = 0;
  glGenVertexArrays(1, &arrays);
  glBindVertexArray(arrays);
  lesson::make_buffer(GL_ELEMENT_ARRAY_BUFFER, indices);
  lesson::make_buffer(GL_ARRAY_BUFFER, places);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  glEnableVertexAttribArray(0);
  tag(0);
  tag_buffer = lesson::make_buffer(GL_ARRAY_BUFFER, tags);
  glDepthTagPointerARK(GL_UNSIGNED_BYTE, 0, nullptr);
  glEnable(GL_DEPTH_TAG_ARRAY_ARK);
}

void draw(double seconds) {
  const float time = 0.8F + static_cast<float>(std::fmod(0.5 * seconds, 1.8));
  tag(time);
  glBindBuffer(GL_ARRAY_BUFFER, tag_buffer);
  glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(tags.size()), tags.data());
  glUseProgram(program);
  lesson::set_uniform(program, "time", time);
  const lesson::Camera eye = lesson::camera(5.2F, 20, 40);
  lesson::set_uniform_matrix(program, "projection", eye.projection.data());
  lesson::set_uniform_matrix(program, "view", eye.view.data());
  lesson::draw_with_edges(draw_pond);
  const unsigned triangles = lesson::count_triangles(draw_pond);
  lesson::say("%u triangles", triangles);
  if (triangles != expected_triangles()) throw std::runtime_error("section 11.R.5 has another number of triangles");
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv,
                     {.title = "waves", .keys = {}, .begin = begin, .draw = draw, .api = lesson::Api::core});
}
