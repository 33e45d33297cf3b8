// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A program of OpenGL ES 2, drawing to an EGL pbuffer; linked to libGLESv2. Its context has OpenGL ES 3.2 if the driver
// has it, else OpenGL ES 2 or higher, as the driver likes.
#include <GLES2/gl2.h>

#define GL(name) gl##name
#define SCENE_GLSL_VERTEX SCENE_GLSL_100_VERTEX
#define SCENE_GLSL_FRAGMENT SCENE_GLSL_100_FRAGMENT
#define SCENE_HAS_VAO 0

#include "tests/clients/scene/egl_display.h"
#include "tests/clients/scene/scene_shader.h"

static EGLContext make_context(EGLDisplay display, EGLConfig config) {
  static const EGLint newest[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2, EGL_NONE};
  static const EGLint any[] = {EGL_CONTEXT_MAJOR_VERSION, 2, EGL_NONE};
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, newest);
  return context != EGL_NO_CONTEXT ? context : eglCreateContext(display, config, EGL_NO_CONTEXT, any);
}

int main(int argc, char** argv) {
  static unsigned char pixels[4 * picture_size * picture_size];
  static const EGLint wanted[] = {EGL_SURFACE_TYPE,
                                  EGL_PBUFFER_BIT,
                                  EGL_RENDERABLE_TYPE,
                                  EGL_OPENGL_ES2_BIT,
                                  EGL_RED_SIZE,
                                  8,
                                  EGL_GREEN_SIZE,
                                  8,
                                  EGL_BLUE_SIZE,
                                  8,
                                  EGL_DEPTH_SIZE,
                                  24,
                                  EGL_NONE};
  static const EGLint size[] = {EGL_WIDTH, picture_size, EGL_HEIGHT, picture_size, EGL_NONE};
  const int frames = frame_count(argc, argv);
  const EGLDisplay display = open_egl_display();
  require(display != EGL_NO_DISPLAY && eglBindAPI(EGL_OPENGL_ES_API), "no EGL display");
  EGLConfig config;
  EGLint configs = 0;
  require(eglChooseConfig(display, wanted, &config, 1, &configs) && configs == 1, "no EGL config");
  const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
  const EGLContext context = make_context(display, config);
  require(eglMakeCurrent(display, surface, surface, context), "no context of OpenGL ES");
  scene_setup();
  for (int frame = 0; frame < frames; ++frame) {
    scene_draw();
    if (frame == frames - 1) scene_read(pixels);
    eglSwapBuffers(display, surface);
  }
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroySurface(display, surface);
  eglDestroyContext(display, context);
  eglTerminate(display);
  return write_picture(argv[2], pixels);
}
