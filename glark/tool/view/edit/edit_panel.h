// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The controls over the editor's picture.
#pragma once

#include <array>
#include <string>

#include "glark/tool/view/controls/controls.h"
#include "glark/tool/view/edit/brush.h"

namespace glark::tool {

// What keys and controls change, and what they ask for.
struct EditState {
  Brush brush;
  float greatest_radius = 1;
  bool panel = true;
  bool help = false;
  bool wants_undo = false;
  bool wants_redo = false;
  bool wants_save = false;
  bool wants_first_view = false;
  edit::Symmetric symmetric;
  bool symmetry_changed = false;
  std::array<char, 256> line{};  // an operation as text
  bool wants_line = false;
  std::string said;  // the last message
};

// What the panel tells of the session.
struct EditFigures {
  std::size_t samples = 0, undo = 0, redo = 0;
  double milliseconds = 0;  // from the start of the last operation until it was drawn
};

class EditPanel {
 public:
  explicit EditPanel(GLFWwindow* window) : controls_(window) {}

  bool takes_pointer() const { return controls_.takes_pointer(); }
  bool takes_keys() const { return controls_.takes_keys(); }
  void draw(EditState& state, const EditFigures& figures);

 private:
  Controls controls_;
};

// The keys, one line each.
const char* help_of_edit_keys();

}  // namespace glark::tool
