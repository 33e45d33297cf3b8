// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The values of GL (lights, materials, planes, matrices) for the cases. Each function sets values in GL, and the
// matching fields of the FixedFunctionState.
#pragma once

#include <initializer_list>

#include "tests/core/refine/fixed_function/scene.h"
// The scene comes first, because it asks the GL headers for prototypes.
#include "glark/core/refine/fixed_function/fixed_function.h"

namespace glark::refine::test {

using State = FixedFunctionState;
using Values = std::initializer_list<float>;

inline void light_value(int light, GLenum parameter, Values values) {
  glLightfv(GL_LIGHT0 + light, parameter, values.begin());
}
inline void material_value(GLenum face, GLenum parameter, Values values) {
  glMaterialfv(face, parameter, values.begin());
}

// A white light in eye space.
inline void set_light(State& state, int light, Values position) {
  state.lighting = state.light[light] = true;
  glPushMatrix();
  glLoadIdentity();
  light_value(light, GL_POSITION, position);
  light_value(light, GL_SPOT_DIRECTION, {0.1f, 0.1f, -1.0f});
  glPopMatrix();
  light_value(light, GL_AMBIENT, {0.1f, 0.15f, 0.05f, 1.0f});
  light_value(light, GL_DIFFUSE, {0.7f, 0.6f, 0.8f, 1.0f});
  light_value(light, GL_SPECULAR, {0.6f, 0.9f, 0.5f, 1.0f});
}

// Materials of both faces, all different, so that no parameter can be mistaken for another.
inline void set_materials() {
  material_value(GL_FRONT, GL_AMBIENT, {0.5f, 0.3f, 0.2f, 0.9f});
  material_value(GL_FRONT, GL_DIFFUSE, {0.8f, 0.5f, 0.4f, 0.7f});
  material_value(GL_FRONT, GL_SPECULAR, {0.4f, 0.3f, 0.6f, 1.0f});
  material_value(GL_FRONT, GL_EMISSION, {0.05f, 0.0f, 0.1f, 1.0f});
  material_value(GL_FRONT, GL_SHININESS, {9.0f});
  material_value(GL_BACK, GL_AMBIENT, {0.1f, 0.6f, 0.3f, 0.8f});
  material_value(GL_BACK, GL_DIFFUSE, {0.2f, 0.7f, 0.9f, 0.4f});
  material_value(GL_BACK, GL_SPECULAR, {0.9f, 0.2f, 0.1f, 1.0f});
  material_value(GL_BACK, GL_EMISSION, {0.0f, 0.1f, 0.05f, 1.0f});
  material_value(GL_BACK, GL_SHININESS, {3.0f});
}

inline void directional(State& state) {
  set_materials();
  set_light(state, 0, {0.3f, 0.8f, 1.5f, 0.0f});
}

inline void positional(State& state) {
  set_materials();
  set_light(state, 0, {0.6f, 0.7f, -1.2f, 1.0f});
}

inline void spot(State& state, float cutoff, float exponent) {
  positional(state);
  light_value(0, GL_SPOT_CUTOFF, {cutoff});
  light_value(0, GL_SPOT_EXPONENT, {exponent});
}

// Lit from both sides.
inline void two_sided(State& state) {
  directional(state);
  set_light(state, 1, {-0.9f, 0.4f, -0.8f, 0.0f});
  state.two_sided = true;
}

inline void follow_color(State& state, GLenum face, GLenum parameter) {
  two_sided(state);
  state.color_material = true;
  state.color_material_face = face;
  state.color_material_parameter = parameter;
}

inline void textured(State& state, int unit) { state.unit[unit].used = true; }

inline void generate(State& state, int unit, GLenum s, GLenum t, GLenum r = 0, GLenum q = 0) {
  state.unit[unit] = {true, {s, t, r, q}};
  glActiveTexture(GL_TEXTURE0 + unit);
  const float planes[4][4] = {
      {0.6f, 0.1f, 0.2f, 0.4f}, {0.1f, 0.5f, 0.3f, 0.6f}, {0.3f, -0.3f, 0.4f, 0.7f}, {0.1f, 0.05f, 0.0f, 1.2f}};
  for (int i = 0; i < 4; ++i) {
    glTexGenfv(GL_S + i, GL_OBJECT_PLANE, planes[i]);
    glTexGenfv(GL_S + i, GL_EYE_PLANE, planes[i]);
  }
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  glActiveTexture(GL_TEXTURE0);
}

inline void texture_matrix(int unit) {
  glActiveTexture(GL_TEXTURE0 + unit);
  glMatrixMode(GL_TEXTURE);
  glTranslatef(0.1f, 0.2f * float(unit + 1), 0.1f);
  glRotatef(20.0f + 10.0f * float(unit), 0.1f, 0.1f, 1.0f);
  glScalef(0.7f, 0.9f, 0.8f);
  glMatrixMode(GL_MODELVIEW);
  glActiveTexture(GL_TEXTURE0);
}

inline void fog(State& state, GLint mode, float density = 0.3f) {
  state.fog = true;
  const float color[4] = {0.8f, 0.2f, 0.5f, 1.0f};
  glFogi(GL_FOG_MODE, mode);
  glFogfv(GL_FOG_COLOR, color);
  glFogf(GL_FOG_DENSITY, density);
  glFogf(GL_FOG_START, 1.5f);
  glFogf(GL_FOG_END, 4.5f);
}

inline void clip_plane(State& state, int index, double a, double b, double c, double d) {
  state.clip_planes = true;
  const double plane[4] = {a, b, c, d};
  glClipPlane(GL_CLIP_PLANE0 + index, plane);
  glEnable(GL_CLIP_PLANE0 + index);
}

inline void point_attenuation(State& state, Values attenuation, float smallest = 0.0f, float largest = 20.0f) {
  state.point_size = true;
  glPointSize(9.0f);
  glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation.begin());
  glPointParameterf(GL_POINT_SIZE_MIN, smallest);
  glPointParameterf(GL_POINT_SIZE_MAX, largest);
}

}  // namespace glark::refine::test
