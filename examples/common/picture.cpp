// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A picture without a display: EGL makes the context, a framebuffer object with 4 samples a pixel receives the frame.
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

#include <stdexcept>
#include <vector>

#include "examples/common/frame.h"

namespace lesson {
namespace {

EGLDisplay open_display() {
  const auto get = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  EGLDisplay display =
      get == nullptr ? EGL_NO_DISPLAY : get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE) return display;
  display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE) return display;
  throw std::runtime_error("there is no OpenGL by EGL; install libegl1 and libgl1-mesa-dri");
}

std::vector<EGLint> context_attributes(Api api) {
  if (api == Api::gles) return {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2, EGL_NONE};
  if (api == Api::core) return {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
  return {EGL_NONE};
}

class Context {
 public:
  explicit Context(Api api) : display_(open_display()) {
    eglBindAPI(api == Api::gles ? EGL_OPENGL_ES_API : EGL_OPENGL_API);
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, context_attributes(api).data());
    if (context_ == EGL_NO_CONTEXT || eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE)
      throw std::runtime_error("the driver has no OpenGL 4.3 or OpenGL ES 3.2; `glark info` says what it has");
  }
  ~Context() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
    eglTerminate(display_);
  }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

 private:
  EGLDisplay display_;
  EGLContext context_ = EGL_NO_CONTEXT;
};

GLuint bind_framebuffer(int width, int height, int samples) {
  GLuint framebuffer = 0;
  GLuint storage[2] = {};
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glGenRenderbuffers(2, storage);
  for (const int i : {0, 1}) {
    glBindRenderbuffer(GL_RENDERBUFFER, storage[i]);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, i == 0 ? GL_RGBA8 : GL_DEPTH24_STENCIL8, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, i == 0 ? GL_COLOR_ATTACHMENT0 : GL_DEPTH_STENCIL_ATTACHMENT,
                              GL_RENDERBUFFER, storage[i]);
  }
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("the driver has no framebuffer of this size; choose a smaller one with --size");
  return framebuffer;
}

// The means of the samples of each pixel, 4 bytes a pixel, the bottom row first.
std::vector<unsigned char> read_pixels(GLuint drawn, int width, int height) {
  const GLuint means = bind_framebuffer(width, height, 0);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn);
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, means);
  std::vector<unsigned char> pixels(std::size_t{4} * static_cast<std::size_t>(width) *
                                    static_cast<std::size_t>(height));
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  for (std::size_t i = 3; i < pixels.size(); i += 4) pixels[i] = 255;
  return pixels;
}

}  // namespace

int write_picture(const Lesson& lesson, const Arguments& arguments) {
  const Context context(lesson.api);
  const GLuint framebuffer = bind_framebuffer(arguments.width, arguments.height, 4);
  if (lesson.begin) lesson.begin();
  press_all(lesson, arguments.keys);
  for (int frame = 0; frame < arguments.frames; ++frame) {
    silent() = frame + 1 < arguments.frames;
    draw_frame(lesson, arguments.width, arguments.height, arguments.seconds);
    glFinish();  // without a window, this ends a frame
  }
  const std::vector<unsigned char> pixels = read_pixels(framebuffer, arguments.width, arguments.height);
  stbi_flip_vertically_on_write(1);
  if (stbi_write_png(arguments.picture.c_str(), arguments.width, arguments.height, 4, pixels.data(),
                     4 * arguments.width) == 0)
    throw std::runtime_error(arguments.picture + " cannot be written");
  return 0;
}

}  // namespace lesson
