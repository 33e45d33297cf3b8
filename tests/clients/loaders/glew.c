// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reaches OpenGL 1.1 by being linked to libGL, and later functions through GLEW.
#include <GL/glew.h>
#include <GL/glx.h>

#define GL(name) gl##name
#define GLX(name) glX##name
#define SCENE_GLSL_VERTEX SCENE_GLSL_120_VERTEX
#define SCENE_GLSL_FRAGMENT SCENE_GLSL_120_FRAGMENT
#define SCENE_HAS_VAO 0
#define GLX_CLIENT_AFTER_CURRENT require(glewInit() == GLEW_OK, "glewInit failed");
static void find_functions(void) {}

#include "tests/clients/scene/scene_shader.h"

#include "tests/clients/glx/glx_client.h"
