// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A context of OpenGL without a display, by EGL, and pictures.
#pragma once

#include <cstdint>
#include <string>

namespace glark::tool {

class Offscreen {
 public:
  // Throws std::runtime_error where there is no OpenGL.
  Offscreen(int width, int height);
  ~Offscreen();
  Offscreen(const Offscreen&) = delete;
  Offscreen& operator=(const Offscreen&) = delete;

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
};

// Of what is drawn to, as PNG. The file appears complete or not at all.
void write_screenshot(const std::string& file, int width, int height);

}  // namespace glark::tool
