// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/view/controls/gl_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cstdlib>
#include <stdexcept>

#include "glark/tool/view/draw/gl.h"

namespace glark::tool {
namespace {

// GLFW 3.3 is built for X11 or for Wayland.
std::string missing_display(const std::string& remedy) {
  const char* wayland = std::getenv("WAYLAND_DISPLAY");
  const char* x11 = std::getenv("DISPLAY");
  if (wayland == nullptr || *wayland == 0 || (x11 != nullptr && *x11 != 0)) return "there is no display; " + remedy;
  return "GLFW does not reach this Wayland display; install libglfw3-wayland or xwayland (Debian 12), or " + remedy;
}

}  // namespace

GlWindow::GlWindow(const std::string& title, int width, int height, int samples, const std::string& remedy) {
  if (glfwInit() == GLFW_FALSE) throw std::runtime_error(missing_display(remedy));
  glfwWindowHint(GLFW_SAMPLES, samples > 1 ? samples : 0);
  window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (window_ == nullptr) {
    glfwTerminate();
    throw std::runtime_error("there is no window with OpenGL; " + remedy);
  }
  glfwMakeContextCurrent(window_);
  load_gl(glfwGetProcAddress);
  glfwSwapInterval(1);
}

GlWindow::~GlWindow() { glfwTerminate(); }

}  // namespace glark::tool
