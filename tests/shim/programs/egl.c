// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// EGL without a surface, everything through eglGetProcAddress, in OpenGL and OpenGL ES.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <stdio.h>
#include <string.h>

static int has_extension(void) {
  const GLubyte* (*get_string)(GLenum, GLuint) = (void*)eglGetProcAddress("glGetStringi");
  void (*get_integer)(GLenum, GLint*) = (void*)eglGetProcAddress("glGetIntegerv");
  GLint count = 0;
  get_integer(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i)
    if (strcmp((const char*)get_string(GL_EXTENSIONS, i), "GL_ARK_adaptive_refinement") == 0) return 1;
  return 0;
}

int main(void) {
  EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
  if (!eglInitialize(display, NULL, NULL)) return 3;
  for (int es = 0; es < 2; ++es) {
    const EGLint attributes[] = {EGL_CONTEXT_CLIENT_VERSION, es ? 3 : 1, EGL_NONE};
    eglBindAPI(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API);
    EGLContext context = eglCreateContext(display, NULL, EGL_NO_CONTEXT, attributes);
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) return 4;
    printf("%s extension %s\n", es ? "es" : "gl", has_extension() ? "yes" : "no");
    eglDestroyContext(display, context);
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  eglTerminate(display);
  return 0;
}
