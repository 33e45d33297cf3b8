// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws the scene under a FixedFunctionState, by fixed function or by a program, and compares the images.
#pragma once

#include <set>

#include "tests/core/refine/fixed_function/scene.h"
// The scene comes first, because it asks the GL headers for prototypes.
#include "glark/core/refine/fixed_function/fixed_function.h"

namespace glark::refine::test {

inline void set_enabled(GLenum what, bool on) { on ? glEnable(what) : glDisable(what); }

// Cube map for directions, 3D if r is generated, else 2D.
inline GLenum texture_target(const TextureUnitState& unit) {
  for (GLenum mode : unit.generation)
    if (mode == GL_REFLECTION_MAP || mode == GL_NORMAL_MAP) return GL_TEXTURE_CUBE_MAP;
  return unit.generation[2] ? GL_TEXTURE_3D : GL_TEXTURE_2D;
}

inline void apply_texture_unit(const TextureUnitState& unit, int index) {
  glActiveTexture(GL_TEXTURE0 + index);
  if (unit.used) glEnable(texture_target(unit));
  for (int i = 0; i < 4; ++i) {
    set_enabled(GL_TEXTURE_GEN_S + i, unit.generation[i] != 0);
    if (unit.generation[i]) glTexGeni(GL_S + i, GL_TEXTURE_GEN_MODE, GLint(unit.generation[i]));
  }
  glActiveTexture(GL_TEXTURE0);
}

// The enables and modes of GL that `state` stands for.
inline void apply(const FixedFunctionState& state) {
  set_enabled(GL_LIGHTING, state.lighting);
  for (int i = 0; i < fixed_function_lights; ++i) set_enabled(GL_LIGHT0 + i, state.light[i]);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, state.two_sided);
  glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, state.local_viewer);
  glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, state.separate_specular ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
  set_enabled(GL_COLOR_SUM, state.color_sum);
  if (state.color_material) glColorMaterial(state.color_material_face, state.color_material_parameter);
  set_enabled(GL_COLOR_MATERIAL, state.color_material);
  set_enabled(GL_NORMALIZE, state.normalize);
  set_enabled(GL_RESCALE_NORMAL, state.rescale_normal);
  set_enabled(GL_FOG, state.fog);
  glFogi(GL_FOG_COORDINATE_SOURCE, state.fog_from_coordinate ? GL_FOG_COORDINATE : GL_FRAGMENT_DEPTH);
  if (state.fog_distance != GL_EYE_PLANE_ABSOLUTE_NV) glFogi(GL_FOG_DISTANCE_MODE_NV, GLint(state.fog_distance));
  for (int i = 0; i < 3; ++i) apply_texture_unit(state.unit[i], i);
}

struct Image {
  std::vector<GLubyte> rgba = std::vector<GLubyte>(4 * image_size * image_size);
  std::vector<GLfloat> depth = std::vector<GLfloat>(image_size * image_size);
};

// Draws by fixed function (program 0), or by `program` under the enables that fixed_function.h asks for.
inline Image draw(const FixedFunctionState& state, GLuint program, GLenum primitive) {
  glUseProgram(program);
  set_enabled(GL_VERTEX_PROGRAM_TWO_SIDE, program && state.lighting && state.two_sided);
  set_enabled(GL_VERTEX_PROGRAM_POINT_SIZE, program && state.point_size);
  set_enabled(GL_COLOR_SUM, state.color_sum || (program && state.lighting && state.separate_specular));
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  draw_grid(primitive);
  Image image;
  glReadPixels(0, 0, image_size, image_size, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  glReadPixels(0, 0, image_size, image_size, GL_DEPTH_COMPONENT, GL_FLOAT, image.depth.data());
  glUseProgram(0);
  return image;
}

inline int largest_difference(const Image& a, const Image& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) largest = std::max(largest, std::abs(a.rgba[i] - b.rgba[i]));
  return largest;
}

inline int covered_pixels(const Image& image) {
  return int(std::count_if(image.depth.begin(), image.depth.end(), [](GLfloat depth) { return depth != 1.0f; }));
}

inline float largest_depth_difference(const Image& a, const Image& b) {
  float largest = 0.0f;
  for (std::size_t i = 0; i < a.depth.size(); ++i) largest = std::max(largest, std::abs(a.depth[i] - b.depth[i]));
  return largest;
}

inline int distinct_colors(const Image& image) {
  std::set<std::array<GLubyte, 4>> colors;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    colors.insert({image.rgba[i], image.rgba[i + 1], image.rgba[i + 2], image.rgba[i + 3]});
  return int(colors.size());
}

}  // namespace glark::refine::test
