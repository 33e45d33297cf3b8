// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The editor's window is another program, glark-view, because it needs OpenGL.
#pragma once

#include <string>
#include <vector>

namespace glark::tool {

// Whether somebody sits at a display: standard input is a terminal, there is a display, and glark-view is installed.
bool can_open_window();

// Becomes `glark-view edit` with these arguments. Throws std::runtime_error if it is not installed.
[[noreturn]] void become_window(std::vector<std::string> arguments);

}  // namespace glark::tool
