// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What a user does with keys and pointer in a window of the program. glark listens on its own: it interposes no function
// that gives the program its events.
#pragma once

#include <optional>
#include <vector>

#include "glark/settings/names/keys.h"

namespace glark::shim {

// Keys that move about in the panel.
enum class PanelKey {
  tab,
  left,
  right,
  up,
  down,
  page_up,
  page_down,
  home,
  end,
  remove,
  backspace,
  space,
  enter,
  escape
};

// In the order in which they came. Positions are in pixels from the window's upper left corner.
struct InputEvent {
  enum class Kind {
    panel,      // the key of the panel
    toggle,     // the key that switches refinement
    move,       // the pointer is at x, y
    leave,      // the pointer is elsewhere
    button,     // at x, y: `number` 0 left, 1 right, 2 middle
    wheel,      // by y notches, upwards
    key,        // a PanelKey
    character,  // `number` is a Unicode character
  };
  Kind kind = Kind::move;
  bool down = false;   // of a button or a key
  bool shift = false;  // of `panel`
  float x = 0;
  float y = 0;
  unsigned number = 0;
};

struct WantedKeys {
  const settings::Key* panel = nullptr;  // null: none
  const settings::Key* toggle = nullptr;
};

struct Area {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  bool operator==(const Area&) const = default;
};

// What the panel takes of the user's input.
struct InputShare {
  std::optional<Area> pointer;  // here, the pointer does not reach the program
  bool keyboard = false;        // no key reaches the program
};

class InputSource {
 public:
  InputSource() = default;
  virtual ~InputSource() = default;
  InputSource(const InputSource&) = delete;
  InputSource& operator=(const InputSource&) = delete;

  // Adds what happened since the last call. Does not block.
  virtual void poll(std::vector<InputEvent>& events) = 0;
  // The window is destroyed.
  virtual bool gone() const = 0;
  // Wayland has no such sharing: there the program gets all input, too.
  virtual void share(const InputShare& share) = 0;
};

}  // namespace glark::shim
