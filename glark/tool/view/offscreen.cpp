// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/offscreen.h"

#define GL_GLEXT_PROTOTYPES 1
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

#include <stdexcept>
#include <vector>

#include "glark/clients/geometry/output_file.h"

namespace glark::tool {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(
      "--offscreen: " + what +
      "; glark info says what OpenGL is here, a software driver is in libegl-mesa0 and libgl1-mesa-dri");
}

EGLDisplay open_display() {
  const auto get_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  EGLDisplay display = get_display == nullptr
                           ? EGL_NO_DISPLAY
                           : get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE) return display;
  display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE)
    fail("there is no EGL display without a surface");
  return display;
}

void make_framebuffer(int width, int height) {
  GLuint framebuffer = 0;
  GLuint storage[2] = {};
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glGenRenderbuffers(2, storage);
  glBindRenderbuffer(GL_RENDERBUFFER, storage[0]);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
  glBindRenderbuffer(GL_RENDERBUFFER, storage[1]);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, storage[0]);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, storage[1]);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    fail("the driver has no framebuffer of this size; choose a smaller one with --size");
}

}  // namespace

Offscreen::Offscreen(int width, int height) : display_(open_display()) {
  eglBindAPI(EGL_OPENGL_API);
  context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, nullptr);
  if (context_ == EGL_NO_CONTEXT || eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE)
    fail("there is no context of OpenGL");
  make_framebuffer(width, height);
}

Offscreen::~Offscreen() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

void write_screenshot(const std::string& file, int width, int height) {
  std::vector<unsigned char> pixels(std::size_t{3} * static_cast<std::size_t>(width) *
                                    static_cast<std::size_t>(height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
  geometry::OutputFile output(file);
  stbi_flip_vertically_on_write(1);
  const auto write = [](void* to, void* data, int size) {
    static_cast<geometry::OutputFile*>(to)->write({static_cast<const char*>(data), static_cast<std::size_t>(size)});
  };
  if (stbi_write_png_to_func(write, &output, width, height, 3, pixels.data(), 3 * width) == 0)
    throw std::runtime_error(file + ": the picture cannot be packed; choose a smaller --size");
  output.commit();
}

}  // namespace glark::tool
