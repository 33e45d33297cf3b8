// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What the programs of this folder share: a context by EGL without a window, and the check of the extension. Before this
// header, the program includes the loader's.
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <stdio.h>

static int make_context(void) {
  static const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5, EGL_NONE};
  const PFNEGLGETPLATFORMDISPLAYPROC get_display =
      (PFNEGLGETPLATFORMDISPLAYPROC)eglGetProcAddress("eglGetPlatformDisplay");
  const EGLDisplay display = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
  if (!eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API)) return 0;
  const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != 0;
}

// Calls functions of the extension through the loader, and prints what they changed.
static int use_extension(void) {
  GLint deepest = -1;
  GLint tag = -1;
  glARKinit(3);
  glEnable(GL_ARK);
  glDepthTag1i(2);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_INPUTS_ARK);
  glGetIntegerv(GL_POOL_LEVEL_ARK, &deepest);
  glGetIntegerv(GL_CURRENT_DEPTH_TAG_ARK, &tag);
  printf("deepest %d, tag %d, enabled %d, error 0x%x\n", deepest, tag, glIsEnabled(GL_ARK), glGetError());
  return deepest == 3 && tag == 2 ? 0 : 1;
}
