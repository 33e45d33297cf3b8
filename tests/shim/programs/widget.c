// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A toolkit: a widget is drawn by a context of its own, which shows nothing. Another context shows the window. Draws
// one mesh with normals in each of six frames. Status 3: not here.
//   shim_widget [swapped]: the context of the widget swaps its buffers once at the start; then there are 14 frames.
#define GL_GLEXT_PROTOTYPES 1
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <stdio.h>
#include <stdlib.h>

static EGLDisplay display;
static EGLConfig config;

static void open_display(void) {
  static const EGLint wanted[] = {
      EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_DEPTH_SIZE, 24, EGL_NONE};
  EGLint count = 0;
  display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
  if (!eglInitialize(display, NULL, NULL)) exit(3);
  if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0) exit(3);
  eglBindAPI(EGL_OPENGL_API);
}

static EGLSurface make_surface(void) {
  static const EGLint size[] = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
  const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
  if (surface == EGL_NO_SURFACE) exit(3);
  return surface;
}

static EGLContext make_context(EGLContext share) {
  static const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                                   4,
                                   EGL_CONTEXT_MINOR_VERSION,
                                   5,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                   EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
                                   EGL_NONE};
  const EGLContext context = eglCreateContext(display, config, share, version);
  if (context == EGL_NO_CONTEXT) exit(3);
  return context;
}

static void make_mesh(void) {
  static const GLfloat corners[] = {.6f, 0, 0, 0, .6f,  0, 0, 0, .6f, -.6f, 0, 0, 0, .6f,  0, 0, 0, .6f,
                                    .6f, 0, 0, 0, -.6f, 0, 0, 0, .6f, -.6f, 0, 0, 0, -.6f, 0, 0, 0, .6f};
  GLuint buffer;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
  glVertexPointer(3, GL_FLOAT, 0, NULL);
  glNormalPointer(GL_FLOAT, 0, NULL);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glEnable(GL_DEPTH_TEST);
  glFrustum(-1, 1, -1, 1, 1, 9);
  glTranslatef(0, 0, -3);
}

int main(int count, char** arguments) {
  (void)arguments;
  open_display();
  const EGLSurface window = make_surface(), hidden = make_surface();
  const EGLContext shown = make_context(NULL), widget = make_context(shown);
  if (count > 1) {
    eglMakeCurrent(display, hidden, hidden, widget);
    eglSwapBuffers(display, hidden);
    eglMakeCurrent(display, window, window, shown);
  }
  for (int frame = 0; frame < (count > 1 ? 14 : 6); ++frame) {
    eglMakeCurrent(display, hidden, hidden, widget);
    if (frame == 0) make_mesh();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawArrays(GL_TRIANGLES, 0, 12);
    eglMakeCurrent(display, window, window, shown);
    glClear(GL_COLOR_BUFFER_BIT);
    eglSwapBuffers(display, window);
  }
  printf("error %x\n", glGetError());
  return 0;
}
