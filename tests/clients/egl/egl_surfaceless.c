// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A core profile context by EGL without a surface. It draws to a framebuffer object, and is linked to libOpenGL,
// without libGL. Built twice, for two scenes.
#define GL_GLEXT_PROTOTYPES 1
#include <GL/gl.h>
#include <GL/glext.h>

#define GL(name) gl##name
#if SCENE_IS_IMPOSTORS
#include "tests/clients/scene/scene_impostors.h"
#else
#define SCENE_GLSL_VERTEX SCENE_GLSL_450_VERTEX
#define SCENE_GLSL_FRAGMENT SCENE_GLSL_450_FRAGMENT
#define SCENE_HAS_VAO 1

#include "tests/clients/scene/scene_shader.h"
#endif
#include "tests/clients/scene/egl_display.h"

static void make_framebuffer(void) {
  GLuint framebuffer;
  GLuint storage[2];
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glGenRenderbuffers(2, storage);
  glBindRenderbuffer(GL_RENDERBUFFER, storage[0]);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, picture_size, picture_size);
  glBindRenderbuffer(GL_RENDERBUFFER, storage[1]);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, picture_size, picture_size);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, storage[0]);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, storage[1]);
  require(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE, "framebuffer not complete");
}

int main(int argc, char** argv) {
  static unsigned char pixels[4 * picture_size * picture_size];
  static const EGLint attributes[] = {
      EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  const int frames = frame_count(argc, argv);
  const EGLDisplay display = open_egl_display();
  require(display != EGL_NO_DISPLAY && eglBindAPI(EGL_OPENGL_API), "no EGL display");
  const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  require(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context), "no context of OpenGL 4.5 core");
  make_framebuffer();
  scene_setup();
  for (int frame = 0; frame < frames; ++frame) {
    scene_draw();
    glFlush();
  }
  scene_read(pixels);
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display, context);
  eglTerminate(display);
  return write_picture(argv[2], pixels);
}
