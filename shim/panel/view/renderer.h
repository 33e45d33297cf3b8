// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <imgui.h>

#include "glark/gl/dispatch.h"
#include "shim/contexts/surface.h"
#include "shim/panel/view/kept_lists.h"
#include "shim/panel/view/picture.h"

namespace glark::shim {

// Draws the lists of Dear ImGui in a context of our own: OpenGL 2.0 with framebuffer objects or OpenGL ES 2.0 is enough.
// The lists are drawn to a picture when they have changed; the picture is drawn in each frame.
class PanelRenderer {
 public:
  explicit PanelRenderer(const gl::Dispatch& gl) : gl_(gl), picture_(gl) {}

  // Builds program, buffers and font. False: GL refuses the shaders. ImGui's context is current.
  bool start();
  // `frame`: lists with the number of the last call are not looked at again. `opaque`: nothing shows through here.
  void draw(const ImDrawData& data, int frame, Size window, const Area& opaque);

 private:
  void make_font();
  void paint(const ImDrawData& data);
  void set_state() const;
  void set_first_vertex(unsigned vertex) const;
  void draw_list(const ImDrawList& list) const;

  const gl::Dispatch& gl_;
  KeptLists lists_;
  PanelPicture picture_;
  int frame_ = -1;
  GLuint program_ = 0;
  GLint origin_ = -1;  // locations of uniforms
  GLint size_ = -1;
  GLuint vertices_ = 0;
  GLuint indices_ = 0;
  GLuint font_ = 0;
};

}  // namespace glark::shim
