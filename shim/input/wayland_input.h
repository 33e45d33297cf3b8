// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Keys and pointer on Wayland. We bind a seat of our own on the program's connection, with an event queue of our own:
// the compositor sends each event to our objects as well as to the program's. So the program gets all input, too.
#pragma once

#include <memory>

#include "shim/input/input.h"

struct wl_display;
struct wl_surface;

namespace glark::shim {

// Null if the process has no Wayland library or the compositor has no seat. `surface`: of the window; null if it is
// unknown: then every surface of the program counts.
std::unique_ptr<InputSource> open_wayland_input(wl_display* display, wl_surface* surface, const WantedKeys& keys);

}  // namespace glark::shim
