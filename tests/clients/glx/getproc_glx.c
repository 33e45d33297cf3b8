// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reaches every GL and GLX function through glXGetProcAddressARB, even those of OpenGL 1.0.
#include <GL/gl.h>
#include <GL/glx.h>

#include "tests/clients/scene/functions.h"

static struct {
  SCENE_FIXED_FUNCTIONS(DECLARE_GL)
  GLX_CLIENT_FUNCTIONS(DECLARE_GLX)
} found;
#define GL(name) found.gl##name
#define GLX(name) found.glX##name

#include "tests/clients/scene/scene_fixed.h"

static __GLXextFuncPtr find(const char* name) {
  const __GLXextFuncPtr function = glXGetProcAddressARB((const GLubyte*)name);
  require(function != NULL, name);
  return function;
}

#define FIND_GL(name) found.gl##name = (__typeof__(&gl##name))find("gl" #name);
#define FIND_GLX(name) found.glX##name = (__typeof__(&glX##name))find("glX" #name);
static void find_functions(void) {
  SCENE_FIXED_FUNCTIONS(FIND_GL)
  GLX_CLIENT_FUNCTIONS(FIND_GLX)
}

#include "tests/clients/glx/glx_client.h"
