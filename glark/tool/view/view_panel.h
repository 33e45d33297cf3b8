// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The controls over the viewer's picture. Without Dear ImGui there are none, and the keys do the same.
#pragma once

#include <string>

#include "glark/tool/view/draw/scene.h"

struct GLFWwindow;

namespace glark::tool {

// What keys and controls change.
struct ViewState {
  DrawSettings settings;
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
  // After the window's callbacks are set: the controls take their events from the same window.
  explicit ViewPanel(GLFWwindow* window);
  ~ViewPanel();
  ViewPanel(const ViewPanel&) = delete;
  ViewPanel& operator=(const ViewPanel&) = delete;

  // The pointer or the keys are for the controls.
  bool takes_pointer() const;
  bool takes_keys() const;
  void draw(ViewState& state, const Statistics& drawn);
};

// The keys, one line each.
const char* help_of_keys();

}  // namespace glark::tool
