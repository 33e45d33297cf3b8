// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws with glBegin and glEnd in every mode that gives triangles.
#include <GL/gl.h>
#include <GL/glx.h>

#define GL(name) gl##name
#define GLX(name) glX##name
#define scene_draw scene_arrays
static void find_functions(void) {}

#include "tests/clients/scene/scene_fixed.h"

#undef scene_draw

// Draws corner i of n on a bowl about (x, y). The normal leans outwards.
static void rim(float x, float y, int i, int n) {
  const double turn = 2 * 3.14159265358979 * i / n;
  glColor3f(0.5f + 0.5f * (float)cos(turn), 0.6f, 0.5f + 0.5f * (float)sin(turn));
  glNormal3f(0.5f * (float)cos(turn), 0.5f * (float)sin(turn), 0.8f);
  glVertex3f(x + 0.5f * (float)cos(turn), y + 0.5f * (float)sin(turn), 0);
}

// Draws corner i of a band that bends away. Each step has two corners.
static void band(float x, float y, int i) {
  const int step = i / 2;
  const float along = 0.3f * (float)step - 0.45f;
  glColor3f(0.2f, 0.5f + along, 0.9f - along);
  glNormal3f(along, 0, 0.8f);
  glVertex3f(x + along, y + (i % 2 ? -0.4f : 0.4f), -along * along);
}

static void scene_draw(void) {
  static const int quad_order[4] = {0, 1, 3, 2};
  scene_begin_frame();
  glBegin(GL_TRIANGLES);
  for (int i = 0; i < 6; ++i) rim(-1.5f, 0.9f, i, 6);
  glEnd();
  glBegin(GL_TRIANGLE_FAN);
  glColor3f(1, 1, 1);
  glNormal3f(0, 0, 1);
  glVertex3f(0, 0.9f, 0.3f);
  for (int i = 0; i <= 8; ++i) rim(0, 0.9f, i, 8);
  glEnd();
  glBegin(GL_POLYGON);
  for (int i = 0; i < 7; ++i) rim(1.5f, 0.9f, i, 7);
  glEnd();
  glBegin(GL_TRIANGLE_STRIP);
  for (int i = 0; i < 8; ++i) band(-1.5f, -0.9f, i);
  glEnd();
  glBegin(GL_QUAD_STRIP);
  for (int i = 0; i < 8; ++i) band(0, -0.9f, i);
  glEnd();
  glBegin(GL_QUADS);
  for (int q = 0; q < 3; ++q) {
    for (int i = 0; i < 4; ++i) band(1.5f, -0.9f, 2 * q + quad_order[i]);
  }
  glEnd();
}

#include "tests/clients/glx/glx_client.h"
