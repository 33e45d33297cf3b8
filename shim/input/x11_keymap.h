// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "shim/input/input.h"
#include "shim/input/xcb_functions.h"

namespace glark::shim {

// The keys of an X server: keycodes are places on the keyboard, keysyms are what is printed on them.
class X11Keymap {
 public:
  X11Keymap(const XcbFunctions& xcb, xcb_connection_t* connection);

  xcb_keycode_t code_of(std::uint32_t keysym) const;              // 0: no key has it
  std::uint32_t keysym_of(xcb_keycode_t code, bool shift) const;  // 0: none

 private:
  xcb_keycode_t first_ = 0;
  std::size_t width_ = 0;  // keysyms of a key: plain, with shift ...
  std::vector<std::uint32_t> keysyms_;
};

std::optional<PanelKey> panel_key(std::uint32_t keysym);

}  // namespace glark::shim
