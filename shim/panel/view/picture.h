// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A texture with the panel. To show it costs one rectangle a frame, however much is in it.
#pragma once

#include "glark/gl/dispatch.h"
#include "shim/contexts/surface.h"
#include "shim/input/input.h"

namespace glark::shim {

class PanelPicture {
 public:
  explicit PanelPicture(const gl::Dispatch& gl) : gl_(gl) {}

  // False: GL refuses the shaders.
  bool start();
  // Draws go to an empty picture of this part of the window from now on. False: GL cannot draw to it.
  bool begin(const Area& area);
  // Draws go to the window again. The picture is drawn over it. `opaque`: it hides what is below.
  void show(Size window, bool opaque) const;

 private:
  void grow(const Area& area);

  const gl::Dispatch& gl_;
  GLuint program_ = 0;
  GLint scale_ = -1;  // location of the uniform
  GLuint corners_ = 0;
  GLuint texture_ = 0;
  GLuint frame_ = 0;
  Size size_;  // of the texture
  Area area_;  // of the window that it shows; its rows begin with the lowest one
};

GLuint build_panel_program(const gl::Dispatch& gl, const char* vertex_source, const char* fragment_source);

}  // namespace glark::shim
