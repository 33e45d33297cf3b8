// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws from display lists: arrays and glBegin compiled once, one list called within another.
#include <GL/gl.h>
#include <GL/glx.h>

#define GL(name) gl##name
#define GLX(name) glX##name
#define scene_setup scene_state
#define scene_draw scene_directly
static void find_functions(void) {}

#include "tests/clients/scene/scene_fixed.h"

#undef scene_setup
#undef scene_draw

static GLuint lists;

static void scene_setup(void) {
  scene_state();
  lists = glGenLists(2);
  glNewList(lists, GL_COMPILE);
  scene_cube();
  glEndList();
  // glNewList reads the arrays at once. Enabling them is not compiled but executed.
  glNewList(lists + 1, GL_COMPILE);
  scene_sphere();
  glCallList(lists);
  glEndList();
}

static void scene_draw(void) {
  scene_begin_frame();
  glCallList(lists + 1);
}

#include "tests/clients/glx/glx_client.h"
