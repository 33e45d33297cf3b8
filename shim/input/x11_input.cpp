// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/input/x11_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "glark/core/report/log.h"
#include "shim/input/x11_keymap.h"
#include "shim/input/xcb_functions.h"

namespace glark::shim {
namespace {

struct Freed {
  void operator()(void* reply) const { std::free(reply); }
};
template <class T>
using Reply = std::unique_ptr<T, Freed>;

constexpr std::uint8_t grab_key_request = 33;  // the major code in an error
constexpr std::uint16_t left_pointer = 68;     // its glyph in the font "cursor"; the next glyph is its mask

// An invisible window over the panel.
struct Cover {
  xcb_window_t window = 0;
  std::optional<Area> area;  // empty: the window is not mapped
};

// The pointer over the cover.
struct CoverPointer {
  unsigned buttons = 0;                             // that are down, by bits
  std::optional<xcb_query_pointer_cookie_t> asked;  // where it is; the answer comes by the next frame
  std::optional<std::pair<int, int>> told;          // where it was in the last event
  bool told_left = false;                           // the last event said that it is elsewhere

  void forget() {
    told.reset();
    told_left = false;
  }
};

class X11Input final : public InputSource {
 public:
  X11Input(const XcbFunctions& xcb, xcb_connection_t* connection, xcb_window_t window, const WantedKeys& keys)
      : xcb_(xcb), connection_(connection), window_(window), keys_(keys), keymap_(xcb, connection) {
    grab(keys.panel);
    grab(keys.toggle);
    const std::uint32_t end[] = {XCB_EVENT_MASK_STRUCTURE_NOTIFY};
    xcb_.xcb_change_window_attributes_(connection_, window_, XCB_CW_EVENT_MASK, end);
    xcb_.xcb_flush_(connection_);
  }
  ~X11Input() override { xcb_.xcb_disconnect_(connection_); }

  void poll(std::vector<InputEvent>& events) override;
  void share(const InputShare& share) override;
  bool gone() const override { return gone_ || xcb_.xcb_connection_has_error_(connection_) != 0; }

  // Returns the highest window above `window` that is below the root; 0: there is no such window.
  static xcb_window_t top_window(const XcbFunctions& xcb, xcb_connection_t* connection, xcb_window_t window);

 private:
  void grab(const settings::Key* key);
  void key_pressed(const xcb_key_press_event_t& event, std::vector<InputEvent>& events);
  void key_moved(const xcb_key_press_event_t& event, bool down, std::vector<InputEvent>& events) const;
  void button_moved(const xcb_button_press_event_t& event, bool down, std::vector<InputEvent>& events);
  void note_error(const xcb_generic_error_t& error);
  void look_for_pointer(std::vector<InputEvent>& events);
  void tell_pointer(const xcb_query_pointer_reply_t* pointer, std::vector<InputEvent>& events);
  void make_cover();
  void set_keyboard(bool ours);

  const XcbFunctions& xcb_;
  xcb_connection_t* connection_;
  xcb_window_t window_;
  WantedKeys keys_;
  X11Keymap keymap_;
  Cover cover_;
  bool keyboard_wanted_ = false;
  bool keyboard_ours_ = false;
  CoverPointer pointer_;
  std::pair<xcb_keycode_t, xcb_timestamp_t> released_{};
  bool complained_ = false;
  bool gone_ = false;
};

xcb_window_t X11Input::top_window(const XcbFunctions& xcb, xcb_connection_t* connection, xcb_window_t window) {
  for (int height = 0; height < 64; ++height) {
    const Reply<xcb_query_tree_reply_t> tree(
        xcb.xcb_query_tree_reply_(connection, xcb.xcb_query_tree_(connection, window), nullptr));
    if (tree == nullptr) return 0;
    if (tree->parent == tree->root || tree->parent == 0) return window;
    window = tree->parent;
  }
  return 0;
}

// A grab works for whichever window of the program has the focus. Any modifier may be down, like Num Lock.
void X11Input::grab(const settings::Key* key) {
  const xcb_keycode_t code = key != nullptr ? keymap_.code_of(key->keysym) : xcb_keycode_t{0};
  const xcb_window_t top = code != 0 ? top_window(xcb_, connection_, window_) : 0;
  if (top != 0)
    xcb_.xcb_grab_key_(connection_, 0, top, XCB_MOD_MASK_ANY, code, XCB_GRAB_MODE_ASYNC, XCB_GRAB_MODE_ASYNC);
}

void X11Input::note_error(const xcb_generic_error_t& error) {
  if (error.major_code != grab_key_request || std::exchange(complained_, true)) return;
  core::log(core::LogLevel::warning,
            "another program has the key of the panel or of --toggle-key; choose others with --overlay-key and "
            "--toggle-key");
}

// A key that is held repeats: the server sends a release and a press at the same time.
void X11Input::key_pressed(const xcb_key_press_event_t& event, std::vector<InputEvent>& events) {
  const bool repeats = released_ == std::pair{event.detail, event.time};
  const std::uint32_t keysym = keymap_.keysym_of(event.detail, false);
  const bool shift = (event.state & XCB_MOD_MASK_SHIFT) != 0;
  if (keys_.panel != nullptr && keysym == keys_.panel->keysym) {
    if (!repeats) events.push_back({.kind = InputEvent::Kind::panel, .down = true, .shift = shift});
  } else if (keys_.toggle != nullptr && keysym == keys_.toggle->keysym) {
    if (!repeats) events.push_back({.kind = InputEvent::Kind::toggle, .down = true});
  } else {
    key_moved(event, true, events);
    const std::uint32_t letter = keymap_.keysym_of(event.detail, shift);
    if (letter >= 0x20 && letter < 0x7F) events.push_back({.kind = InputEvent::Kind::character, .number = letter});
  }
}

void X11Input::key_moved(const xcb_key_press_event_t& event, bool down, std::vector<InputEvent>& events) const {
  const std::optional<PanelKey> key = panel_key(keymap_.keysym_of(event.detail, false));
  if (key) events.push_back({.kind = InputEvent::Kind::key, .down = down, .number = static_cast<unsigned>(*key)});
}

void X11Input::button_moved(const xcb_button_press_event_t& event, bool down, std::vector<InputEvent>& events) {
  if (event.detail == 4 || event.detail == 5) {
    if (down) events.push_back({.kind = InputEvent::Kind::wheel, .y = event.detail == 4 ? 1.0F : -1.0F});
    return;
  }
  if (event.detail < 1 || event.detail > 3 || !cover_.area) return;
  const unsigned number = event.detail == 1 ? 0 : event.detail == 3 ? 1 : 2;
  pointer_.buttons = down ? pointer_.buttons | 1U << number : pointer_.buttons & ~(1U << number);
  events.push_back({.kind = InputEvent::Kind::button,
                    .down = down,
                    .x = static_cast<float>(event.event_x + cover_.area->x),
                    .y = static_cast<float>(event.event_y + cover_.area->y),
                    .number = number});
  if (down) set_keyboard(true);
}

void X11Input::poll(std::vector<InputEvent>& events) {
  while (const Reply<xcb_generic_event_t> event{xcb_.xcb_poll_for_event_(connection_)}) {
    const auto* key = reinterpret_cast<const xcb_key_press_event_t*>(event.get());
    const auto* button = reinterpret_cast<const xcb_button_press_event_t*>(event.get());
    switch (event->response_type & 0x7F) {
      case 0: note_error(reinterpret_cast<const xcb_generic_error_t&>(*event)); break;
      case XCB_KEY_PRESS: key_pressed(*key, events); break;
      case XCB_KEY_RELEASE:
        released_ = {key->detail, key->time};
        key_moved(*key, false, events);
        break;
      case XCB_BUTTON_PRESS: button_moved(*button, true, events); break;
      case XCB_BUTTON_RELEASE: button_moved(*button, false, events); break;
      case XCB_LEAVE_NOTIFY:
        if (pointer_.buttons == 0) set_keyboard(keyboard_wanted_);
        break;
      case XCB_DESTROY_NOTIFY:
        gone_ = gone_ || reinterpret_cast<const xcb_destroy_notify_event_t&>(*event).window == window_;
        break;
      default: break;
    }
  }
  if (cover_.area && !gone()) look_for_pointer(events);
}

// Nobody waits for the X server: the answer to the question of one frame is read in the next one. A place that is older
// than a click in `events` is not told.
void X11Input::look_for_pointer(std::vector<InputEvent>& events) {
  const bool clicked = std::any_of(events.begin(), events.end(),
                                   [](const InputEvent& event) { return event.kind == InputEvent::Kind::button; });
  if (pointer_.asked) {
    const Reply<xcb_query_pointer_reply_t> pointer(
        xcb_.xcb_query_pointer_reply_(connection_, *pointer_.asked, nullptr));
    if (!clicked) tell_pointer(pointer.get(), events);
  }
  if (clicked) pointer_.forget();
  pointer_.asked = xcb_.xcb_query_pointer_(connection_, window_);
  xcb_.xcb_flush_(connection_);
}

// A pointer that rests makes no events.
void X11Input::tell_pointer(const xcb_query_pointer_reply_t* pointer, std::vector<InputEvent>& events) {
  const bool here = pointer != nullptr && (pointer->child == cover_.window || pointer_.buttons != 0);
  if (!here) {
    if (!pointer_.told_left) events.push_back({.kind = InputEvent::Kind::leave});
    pointer_.forget();
    pointer_.told_left = true;
    return;
  }
  const std::pair<int, int> place{pointer->win_x, pointer->win_y};
  if (pointer_.told == place) return;
  pointer_.told = place;
  pointer_.told_left = false;
  events.push_back(
      {.kind = InputEvent::Kind::move, .x = static_cast<float>(place.first), .y = static_cast<float>(place.second)});
}

void X11Input::make_cover() {
  const xcb_font_t font = xcb_.xcb_generate_id_(connection_);
  const xcb_cursor_t cursor = xcb_.xcb_generate_id_(connection_);
  constexpr char name[] = "cursor";
  xcb_.xcb_open_font_(connection_, font, sizeof(name) - 1, name);
  xcb_.xcb_create_glyph_cursor_(connection_, cursor, font, font, left_pointer, left_pointer + 1, 0, 0, 0, 0xFFFF,
                                0xFFFF, 0xFFFF);
  cover_.window = xcb_.xcb_generate_id_(connection_);
  const std::uint32_t values[] = {XCB_EVENT_MASK_BUTTON_PRESS | XCB_EVENT_MASK_BUTTON_RELEASE |
                                      XCB_EVENT_MASK_LEAVE_WINDOW | XCB_EVENT_MASK_POINTER_MOTION |
                                      XCB_EVENT_MASK_KEY_PRESS | XCB_EVENT_MASK_KEY_RELEASE,
                                  cursor};
  xcb_.xcb_create_window_(connection_, 0, cover_.window, window_, 0, 0, 1, 1, 0, XCB_WINDOW_CLASS_INPUT_ONLY,
                          XCB_COPY_FROM_PARENT, XCB_CW_EVENT_MASK | XCB_CW_CURSOR, values);
}

void X11Input::set_keyboard(bool ours) {
  if (keyboard_ours_ == ours || cover_.window == 0) return;
  keyboard_ours_ = ours;
  if (ours)
    xcb_.xcb_grab_keyboard_(connection_, 0, cover_.window, XCB_CURRENT_TIME, XCB_GRAB_MODE_ASYNC, XCB_GRAB_MODE_ASYNC);
  else
    xcb_.xcb_ungrab_keyboard_(connection_, XCB_CURRENT_TIME);
}

void X11Input::share(const InputShare& share) {
  if (share.pointer && cover_.window == 0) make_cover();
  if (share.pointer && share.pointer != cover_.area) {
    const Area& wanted = *share.pointer;
    const std::uint32_t values[] = {static_cast<std::uint32_t>(wanted.x), static_cast<std::uint32_t>(wanted.y),
                                    static_cast<std::uint32_t>(wanted.width),
                                    static_cast<std::uint32_t>(wanted.height)};
    xcb_.xcb_configure_window_(
        connection_, cover_.window,
        XCB_CONFIG_WINDOW_X | XCB_CONFIG_WINDOW_Y | XCB_CONFIG_WINDOW_WIDTH | XCB_CONFIG_WINDOW_HEIGHT, values);
  }
  if (share.pointer && !cover_.area) xcb_.xcb_map_window_(connection_, cover_.window);
  if (!share.pointer && cover_.area) {
    pointer_.forget();
    xcb_.xcb_unmap_window_(connection_, cover_.window);
    pointer_.buttons = 0;
  }
  cover_.area = share.pointer;
  if (share.keyboard != keyboard_wanted_ || !cover_.area) set_keyboard(share.keyboard && cover_.area);
  keyboard_wanted_ = share.keyboard;
  xcb_.xcb_flush_(connection_);
}

}  // namespace

std::unique_ptr<InputSource> open_x11_input(const char* display, std::uint32_t window, const WantedKeys& keys) {
  const XcbFunctions* const xcb = xcb_functions();
  if (xcb == nullptr) return nullptr;
  xcb_connection_t* const connection = xcb->xcb_connect_(display, nullptr);
  if (xcb->xcb_connection_has_error_(connection) != 0 || X11Input::top_window(*xcb, connection, window) == 0) {
    xcb->xcb_disconnect_(connection);
    return nullptr;
  }
  return std::make_unique<X11Input>(*xcb, connection, window, keys);
}

}  // namespace glark::shim
