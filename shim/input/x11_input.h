// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Keys and pointer on X11, over a connection of our own: the program's events and its error handlers are not touched.
//   - The chosen keys are grabbed on the program's top window, so the server gives them to us, not to the program.
//   - While the panel is open, an invisible window lies over it. It takes the pointer there.
//   - After a click into the panel, the keyboard is ours until the pointer leaves it.
#pragma once

#include <cstdint>
#include <memory>

#include "shim/input/input.h"

namespace glark::shim {

// `display`: as in $DISPLAY; null for that of the environment. Null if the server or the window cannot be reached.
std::unique_ptr<InputSource> open_x11_input(const char* display, std::uint32_t window, const WantedKeys& keys);

}  // namespace glark::shim
