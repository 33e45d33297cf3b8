// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <imgui.h>

#include "glark/gl/dispatch.h"
#include "shim/contexts/surface.h"

namespace glark::shim {

// Draws the lists of Dear ImGui in a context of our own: OpenGL 2.0 or OpenGL ES 2.0 is enough.
class PanelRenderer {
 public:
  explicit PanelRenderer(const gl::Dispatch& gl) : gl_(gl) {}

  // Builds program, buffers and font. False: GL refuses the shaders. ImGui's context is current.
  bool start();
  void draw(const ImDrawData& data, Size size) const;

 private:
  void set_state(const ImDrawData& data, Size size) const;
  void set_first_vertex(unsigned vertex) const;
  void draw_list(const ImDrawList& list, const ImDrawData& data, Size size) const;

  const gl::Dispatch& gl_;
  GLuint program_ = 0;
  GLint size_ = -1;  // location of the uniform
  GLuint vertices_ = 0;
  GLuint indices_ = 0;
  GLuint font_ = 0;
};

}  // namespace glark::shim
