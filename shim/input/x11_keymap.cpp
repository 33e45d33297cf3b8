// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/input/x11_keymap.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace glark::shim {
namespace {

// X11/keysymdef.h
constexpr std::array<std::pair<std::uint32_t, PanelKey>, 16> panel_keys{{
    {0xFF09, PanelKey::tab},
    {0xFF51, PanelKey::left},
    {0xFF52, PanelKey::up},
    {0xFF53, PanelKey::right},
    {0xFF54, PanelKey::down},
    {0xFF55, PanelKey::page_up},
    {0xFF56, PanelKey::page_down},
    {0xFF50, PanelKey::home},
    {0xFF57, PanelKey::end},
    {0xFFFF, PanelKey::remove},
    {0xFF08, PanelKey::backspace},
    {0x0020, PanelKey::space},
    {0xFF0D, PanelKey::enter},
    {0xFF8D, PanelKey::enter},
    {0xFF1B, PanelKey::escape},
    {0xFE20, PanelKey::tab},
}};

}  // namespace

X11Keymap::X11Keymap(const XcbFunctions& xcb, xcb_connection_t* connection) {
  const xcb_setup_t* const setup = xcb.xcb_get_setup_(connection);
  first_ = setup->min_keycode;
  const auto count = static_cast<std::uint8_t>(setup->max_keycode - setup->min_keycode + 1);
  xcb_get_keyboard_mapping_reply_t* const reply = xcb.xcb_get_keyboard_mapping_reply_(
      connection, xcb.xcb_get_keyboard_mapping_(connection, first_, count), nullptr);
  if (reply == nullptr) return;
  width_ = reply->keysyms_per_keycode;
  const xcb_keysym_t* const keysyms = xcb.xcb_get_keyboard_mapping_keysyms_(reply);
  keysyms_.assign(keysyms, keysyms + count * width_);
  std::free(reply);
}

xcb_keycode_t X11Keymap::code_of(std::uint32_t keysym) const {
  for (std::size_t at = 0; at < keysyms_.size(); at += width_)
    if (keysyms_[at] == keysym) return static_cast<xcb_keycode_t>(first_ + at / width_);
  return 0;
}

std::uint32_t X11Keymap::keysym_of(xcb_keycode_t code, bool shift) const {
  const std::size_t at = (code - first_) * width_;
  if (code < first_ || at + width_ > keysyms_.size() || width_ == 0) return 0;
  const std::uint32_t shifted = shift && width_ > 1 ? keysyms_[at + 1] : 0;
  return shifted != 0 ? shifted : keysyms_[at];
}

std::optional<PanelKey> panel_key(std::uint32_t keysym) {
  const auto* const found =
      std::find_if(panel_keys.begin(), panel_keys.end(), [&](const auto& row) { return row.first == keysym; });
  return found != panel_keys.end() ? std::optional(found->second) : std::nullopt;
}

}  // namespace glark::shim
