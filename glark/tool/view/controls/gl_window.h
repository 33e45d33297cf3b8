// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A window with OpenGL, whose context is current.
#pragma once

#include <string>

struct GLFWwindow;

namespace glark::tool {

class GlWindow {
 public:
  // samples: of a pixel, 1 or more. remedy: what to do without a display, for the message. Throws std::runtime_error if
  // there is no display.
  GlWindow(const std::string& title, int width, int height, int samples, const std::string& remedy);
  ~GlWindow();
  GlWindow(const GlWindow&) = delete;
  GlWindow& operator=(const GlWindow&) = delete;

  GLFWwindow* handle() const { return window_; }

 private:
  GLFWwindow* window_ = nullptr;
};

}  // namespace glark::tool
