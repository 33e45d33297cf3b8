// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reaches GL by being linked to libGL.
#include <GL/gl.h>
#include <GL/glx.h>

#define GL(name) gl##name
#define GLX(name) glX##name
static void find_functions(void) {}

#include "tests/clients/scene/scene_fixed.h"

#include "tests/clients/glx/glx_client.h"
