// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reaches GL by dlopen of libGL and dlsym of every function on that handle.
#include <GL/gl.h>
#include <GL/glx.h>
#include <dlfcn.h>

#include "tests/clients/scene/functions.h"

static struct {
  SCENE_FIXED_FUNCTIONS(DECLARE_GL)
  GLX_CLIENT_FUNCTIONS(DECLARE_GLX)
} found;
#define GL(name) found.gl##name
#define GLX(name) found.glX##name

#include "tests/clients/scene/scene_fixed.h"

static void* find(void* library, const char* name) {
  void* function = dlsym(library, name);
  require(function != NULL, name);
  return function;
}

#define FIND_GL(name) *(void**)&found.gl##name = find(library, "gl" #name);
#define FIND_GLX(name) *(void**)&found.glX##name = find(library, "glX" #name);
static void find_functions(void) {
  void* library = dlopen("libGL.so.1", RTLD_NOW | RTLD_LOCAL);
  require(library != NULL, "no libGL.so.1");
  SCENE_FIXED_FUNCTIONS(FIND_GL)
  GLX_CLIENT_FUNCTIONS(FIND_GLX)
}

#include "tests/clients/glx/glx_client.h"
