// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The editor's window.
#pragma once

#include <glark/edit.h>

#include <filesystem>

namespace glark::tool {

struct EditOptions {
  std::filesystem::path scan;
  std::filesystem::path output;   // where the edited scan is saved
  bool may_replace = false;       // a file that is there already
  std::filesystem::path session;  // the folder
  edit::SessionOptions sampling;
  int width = 1024;
  int height = 768;
};

// Returns when the window is closed. Throws std::runtime_error if there is no display, and what edit::Session throws.
void show_edit_window(const EditOptions& options);

}  // namespace glark::tool
