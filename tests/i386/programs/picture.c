// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws one lit fan, from arrays on the stack, by EGL without a window, and writes the picture: picture FILE.ppm. On i386,
// the addresses of the stack are above 2 GB. Linked to libOpenGL and libEGL only.
#define GL_GLEXT_PROTOTYPES 1
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <stdio.h>

enum { size = 128, corners = 8 };

static int make_context(void) {
  const PFNEGLGETPLATFORMDISPLAYPROC get_display =
      (PFNEGLGETPLATFORMDISPLAYPROC)eglGetProcAddress("eglGetPlatformDisplay");
  const EGLDisplay display = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
  if (!eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API)) return 0;
  const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, NULL);
  return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != 0;
}

static void make_framebuffer(void) {
  GLuint framebuffer;
  GLuint storage;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glGenRenderbuffers(1, &storage);
  glBindRenderbuffer(GL_RENDERBUFFER, storage);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size, size);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, storage);
  glViewport(0, 0, size, size);
}

static void draw(void) {
  static const float around[corners][2] = {{1, 0},  {.7071F, .7071F},   {0, 1},  {-.7071F, .7071F},
                                           {-1, 0}, {-.7071F, -.7071F}, {0, -1}, {.7071F, -.7071F}};
  float positions[corners + 2][3] = {{0, 0, 0}};
  float normals[corners + 2][3] = {{0, 0, 1}};
  for (int i = 0; i <= corners; ++i) {
    for (int axis = 0; axis < 2; ++axis) {
      positions[i + 1][axis] = .9F * around[i % corners][axis];
      normals[i + 1][axis] = .8F * around[i % corners][axis];
    }
    normals[i + 1][2] = .6F;
  }
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, positions);
  glNormalPointer(GL_FLOAT, 0, normals);
  glClear(GL_COLOR_BUFFER_BIT);
  for (int frame = 0; frame < 3; ++frame) glDrawArrays(GL_TRIANGLE_FAN, 0, corners + 2);
}

int main(int argc, char** argv) {
  static unsigned char pixels[size * size * 3];
  if (argc != 2 || !make_context()) return 3;
  make_framebuffer();
  draw();
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, size, size, GL_RGB, GL_UNSIGNED_BYTE, pixels);
  FILE* file = fopen(argv[1], "wb");
  if (file == NULL) return 4;
  fprintf(file, "P6\n%d %d\n255\n", size, size);
  fwrite(pixels, 1, sizeof(pixels), file);
  return fclose(file) == 0 && glGetError() == GL_NO_ERROR ? 0 : 5;
}
