// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Dear ImGui over the picture of a window. Without the library there are no controls, and the keys do the same.
#pragma once

struct GLFWwindow;

namespace glark::tool {

class Controls {
 public:
  // After the window's callbacks are set: the controls take their events from the same window.
  explicit Controls(GLFWwindow* window);
  ~Controls();
  Controls(const Controls&) = delete;
  Controls& operator=(const Controls&) = delete;

  // The pointer or the keys are for the controls.
  bool takes_pointer() const;
  bool takes_keys() const;
  // Between these calls, widgets may be added.
  void begin();
  void end();
};

// A window in the middle that shows a text while is_open.
void show_text(const char* title, const char* text, bool& is_open);

}  // namespace glark::tool
