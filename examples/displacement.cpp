// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Displacement by a texture, without any shader. The terrain on the left is a flat grid of 32 triangles whose vertices
// near the eye have greater depth tags. The planet on the right is a displaced PN surface of an icosahedron with 20
// triangles. Both use the same height map. The fixed function lights them with the normals of the displaced surface.
//
//   displacement [OUT.png]
#include <GL/gl.h>

#include <array>
#include <cmath>
#include <vector>

#include <GL/glark.h>
#include "examples/common/lesson.h"
#include "examples/common/look.h"

namespace {

constexpr int map_size = 256;
constexpr unsigned max_level = 7;

// Waves of halving lengths and heights. They repeat at the edges of the map.
float mountains(float s, float t) {
  float sum = 0;
  float amplitude = 0.5F;
  for (int octave = 0; octave < 6; ++octave) {
    const auto frequency = static_cast<float>(2 * M_PI * (1 << octave));
    const float turn = 1.7F * static_cast<float>(octave);
    sum += amplitude * (1 - std::abs(std::sin(frequency * s / 2 + std::cos(frequency * t + turn)) *
                                     std::cos(frequency * t / 2 + turn)));
    amplitude *= 0.45F;
  }
  return sum;
}

// One height for each texel, from 0 to about 1, filtered between texels. Scale and bias turn heights into lengths.
void upload_height_map() {
  std::vector<float> heights;
  for (int t = 0; t < map_size; ++t) {
    for (int s = 0; s < map_size; ++s) {
      heights.push_back(mountains(static_cast<float>(s) / map_size, static_cast<float>(t) / map_size));
    }
  }
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, 0x822E /* GL_R32F */, map_size, map_size, 0, GL_RED, GL_FLOAT, heights.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void terrain_vertex(int i, int j) {
  const float x = static_cast<float>(i) / 2 - 1;
  const float y = static_cast<float>(j) / 2 - 1;
  glDepthTag1i(max_level - static_cast<unsigned>(j));  // the eye is at the side with small y
  glTexCoord2f(0.4F * x, 0.4F * y);
  glVertex2f(2 * x, 2 * y);
}

void draw_terrain() {
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_INPUTS_ARK);
  glARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.7F);
  glARKParameterfARK(GL_DISPLACEMENT_BIAS_ARK, -0.3F);
  glNormal3f(0, 0, 1);
  for (int j = 0; j < 4; ++j) {
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i <= 4; ++i) {
      terrain_vertex(i, j + 1);
      terrain_vertex(i, j);
    }
    glEnd();
  }
}

// An icosahedron. Its twelve points are the corners of three golden rectangles; its twenty triangles join neighbouring
// points.
void draw_planet() {
  std::vector<std::array<float, 3>> points;
  const float t = (1 + std::sqrt(5.0F)) / 2;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (unsigned signs = 0; signs < 4; ++signs) {
      std::array<float, 3> p{};
      p.at((axis + 1) % 3) = (signs & 1U) != 0 ? 1.0F : -1.0F;
      p.at((axis + 2) % 3) = (signs & 2U) != 0 ? t : -t;
      points.push_back(p);
    }
  }
  const auto near = [](const std::array<float, 3>& a, const std::array<float, 3>& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) < 2.1F;
  };
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  glARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.6F);
  glDepthTag1i(max_level - 1);
  glBegin(GL_TRIANGLES);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        if (!near(points[i], points[j]) || !near(points[j], points[k]) || !near(points[k], points[i])) continue;
        for (const std::size_t corner : {i, j, k}) {
          const std::array<float, 3>& p = points[corner];
          glNormal3fv(p.data());
          glTexCoord2f(0.15F * p[0], 0.15F * p[1]);  // the front and the back are alike, so there is no seam
          glVertex3fv(p.data());
        }
      }
    }
  }
  glEnd();
}

void begin() {
  upload_height_map();
  glARKinit(max_level);
  glEnable(GL_ARK);
  glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 0);
  lesson::light();
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_FALSE);  // the triangles of the planet have either orientation
}

void draw(double) {
  lesson::use_part(0, 2);
  lesson::look(5.4F, 0, 30);
  glRotatef(-90, 1, 0, 0);
  glColor3f(0.75F, 0.7F, 0.55F);
  draw_terrain();
  lesson::use_part(1, 2);
  lesson::look(8, 0, -20);
  glColor3f(0.5F, 0.65F, 0.8F);
  draw_planet();
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv,
                     {.title = "displacement", .keys = {}, .begin = begin, .draw = draw, .width = 1024, .height = 512});
}
