// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/offscreen.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

#include <stdexcept>
#include <vector>

#include "glark/clients/geometry/write/output_file.h"
#include "glark/tool/view/draw/gl.h"
// After glad, which stands for <GL/gl.h> but does not define APIENTRY.
#ifndef APIENTRY
#define APIENTRY GLAPIENTRY
#endif
#include <GL/osmesa.h>

namespace glark::tool {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(
      "--offscreen: " + what +
      "; glark info says what OpenGL is here, a software driver is in libegl-mesa0 and libgl1-mesa-dri");
}

// Returns EGL_NO_DISPLAY if there is no display.
EGLDisplay open_display() {
  const auto get_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  EGLDisplay display = get_display == nullptr
                           ? EGL_NO_DISPLAY
                           : get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE) return display;
  display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE ? display : EGL_NO_DISPLAY;
}

void make_framebuffer(int width, int height) {
  GLuint framebuffer = 0;
  GLuint storage[2] = {};
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.GenRenderbuffers(2, storage);
  gl.BindRenderbuffer(GL_RENDERBUFFER, storage[0]);
  gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
  gl.BindRenderbuffer(GL_RENDERBUFFER, storage[1]);
  gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, storage[0]);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, storage[1]);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    fail("the driver has no framebuffer of this size; choose a smaller one with --size");
}

}  // namespace

Offscreen::Offscreen(int width, int height) {
  if (open_egl()) {
    load_gl(eglGetProcAddress);
  } else if (open_osmesa()) {
    load_gl(OSMesaGetProcAddress);
  } else {
    fail("there is neither a context of OpenGL by EGL nor OSMesa");
  }
  make_framebuffer(width, height);
}

bool Offscreen::open_egl() {
  display_ = open_display();
  if (display_ == EGL_NO_DISPLAY) return false;
  eglBindAPI(EGL_OPENGL_API);
  context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, nullptr);
  return context_ != EGL_NO_CONTEXT && eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
}

// These are OSMesa's functions in libGLARK, which call those of the OSMesa library.
bool Offscreen::open_osmesa() {
  if (dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_GLOBAL) == nullptr) return false;
  osmesa_ = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr);
  constexpr int side = 16;  // any size is possible, because a framebuffer object receives the pictures
  surface_.resize(std::size_t{4} * side * side);
  return osmesa_ != nullptr &&
         OSMesaMakeCurrent(static_cast<OSMesaContext>(osmesa_), surface_.data(), GL_UNSIGNED_BYTE, side, side) != 0;
}

Offscreen::~Offscreen() {
  if (osmesa_ != nullptr) OSMesaDestroyContext(static_cast<OSMesaContext>(osmesa_));
  if (display_ == EGL_NO_DISPLAY) return;
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

void write_screenshot(const std::string& file, int width, int height) {
  std::vector<unsigned char> pixels(std::size_t{3} * static_cast<std::size_t>(width) *
                                    static_cast<std::size_t>(height));
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
  geometry::OutputFile output(file);
  stbi_flip_vertically_on_write(1);
  const auto write = [](void* to, void* data, int size) {
    static_cast<geometry::OutputFile*>(to)->write({static_cast<const char*>(data), static_cast<std::size_t>(size)});
  };
  if (stbi_write_png_to_func(write, &output, width, height, 3, pixels.data(), 3 * width) == 0)
    throw std::runtime_error(file + ": the picture cannot be packed; choose a smaller --width or --height");
  output.commit();
}

}  // namespace glark::tool
