// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The controls over the viewer's picture. Without Dear ImGui there are none, and the keys do the same.
#pragma once

#include <string>

#include "glark/tool/view/controls/controls.h"
#include "glark/tool/view/draw/scene.h"

namespace glark::tool {

// What keys and controls change.
struct ViewState {
  DrawSettings settings;
  MapsShown most_maps = MapsShown::plain;  // the most that a model has
  Camera camera;
  bool turntable = false;  // the model turns by itself
  bool panel = true;
  bool help = false;
  bool wants_screenshot = false;
  bool wants_first_view = false;
  float greatest_distance = 0;  // of the error colours; 0: there are none
};

class ViewPanel {
 public:
  explicit ViewPanel(GLFWwindow* window) : controls_(window) {}

  bool takes_pointer() const { return controls_.takes_pointer(); }
  bool takes_keys() const { return controls_.takes_keys(); }
  void draw(ViewState& state, const Statistics& drawn);

 private:
  Controls controls_;
};

// The keys, one line each.
const char* help_of_keys();

}  // namespace glark::tool
