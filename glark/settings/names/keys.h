// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The keys that a user may choose for glark. They lie at the same place on every keyboard layout.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace glark::settings {

struct Key {
  std::string_view name;
  std::uint32_t keysym;  // X11: X11/keysymdef.h
  std::uint32_t code;    // Wayland: linux/input-event-codes.h
};

std::span<const Key> known_keys();
// Null: there is no such key. Upper and lower case count as equal.
const Key* find_key(std::string_view name);

}  // namespace glark::settings
