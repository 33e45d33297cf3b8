// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// An OpenGL context without a display, by EGL or else by OSMesa, and its pictures as files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace glark::tool {

class Offscreen {
 public:
  // Throws std::runtime_error if there is no OpenGL.
  Offscreen(int width, int height);
  ~Offscreen();
  Offscreen(const Offscreen&) = delete;
  Offscreen& operator=(const Offscreen&) = delete;

 private:
  bool open_egl();
  bool open_osmesa();

  void* display_ = nullptr;
  void* context_ = nullptr;
  void* osmesa_ = nullptr;
  std::vector<unsigned char> surface_;
};

// Writes the current framebuffer as PNG. The writing is atomic.
void write_screenshot(const std::string& file, int width, int height);

}  // namespace glark::tool
