// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/input/wayland_input.h"

#include <unistd.h>
#include <wayland-client-protocol.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "shim/input/wayland_functions.h"

namespace glark::shim {
namespace {

// linux/input-event-codes.h. Keys that only move about lie at the same place on every layout.
constexpr std::array<std::pair<std::uint32_t, PanelKey>, 14> panel_keys{{{15, PanelKey::tab},
                                                                         {105, PanelKey::left},
                                                                         {106, PanelKey::right},
                                                                         {103, PanelKey::up},
                                                                         {108, PanelKey::down},
                                                                         {104, PanelKey::page_up},
                                                                         {109, PanelKey::page_down},
                                                                         {102, PanelKey::home},
                                                                         {107, PanelKey::end},
                                                                         {111, PanelKey::remove},
                                                                         {14, PanelKey::backspace},
                                                                         {57, PanelKey::space},
                                                                         {28, PanelKey::enter},
                                                                         {1, PanelKey::escape}}};
constexpr std::uint32_t left_shift = 42;
constexpr std::uint32_t right_shift = 54;
constexpr std::uint32_t left_button = 0x110;  // the right one follows, then the middle one
constexpr float notch = 10;                   // of a wheel, in the units of wl_pointer.axis

struct Pointer {
  wl_proxy* proxy = nullptr;  // null while the panel is closed
  bool offered = false;       // by the seat
  bool here = false;          // over the program's surface
  float x = 0;
  float y = 0;

  void move(wl_fixed_t to_x, wl_fixed_t to_y) {
    x = static_cast<float>(wl_fixed_to_double(to_x));
    y = static_cast<float>(wl_fixed_to_double(to_y));
  }
};

class WaylandInput final : public InputSource {
 public:
  WaylandInput(const WaylandFunctions& wayland, wl_display* display, wl_surface* surface, const WantedKeys& keys)
      : wayland_(wayland), display_(display), surface_(surface), keys_(keys) {}
  ~WaylandInput() override = default;  // the connection may be closed already; its objects end with it

  bool open();
  void poll(std::vector<InputEvent>& events) override;
  void share(const InputShare& share) override;
  bool gone() const override { return false; }  // a key of another surface counts, too

 private:
  static WaylandInput& self(void* data) { return *static_cast<WaylandInput*>(data); }
  wl_proxy* make(wl_proxy* parent, std::uint32_t request, const wl_interface* interface) const;
  void bind_seat(wl_registry* registry, std::uint32_t name);
  void use_seat(std::uint32_t capabilities);
  void key_moved(std::uint32_t code, bool down);

  static const wl_registry_listener registry_listener;
  static const wl_seat_listener seat_listener;
  static const wl_keyboard_listener keyboard_listener;
  static const wl_pointer_listener pointer_listener;

  const WaylandFunctions& wayland_;
  wl_display* display_;
  wl_surface* surface_;
  WantedKeys keys_;
  wl_event_queue* queue_ = nullptr;
  wl_proxy* seat_ = nullptr;
  wl_proxy* keyboard_ = nullptr;
  Pointer pointer_;
  bool shift_ = false;
  std::vector<InputEvent> events_;
};

// Calls a request that makes an object, at version 1, whose events we all know.
wl_proxy* WaylandInput::make(wl_proxy* parent, std::uint32_t request, const wl_interface* interface) const {
  wl_argument argument{};
  return wayland_.wl_proxy_marshal_array_constructor_(parent, request, &argument, interface);
}

const wl_registry_listener WaylandInput::registry_listener{
    .global =
        [](void* data, wl_registry* registry, std::uint32_t name, const char* interface, std::uint32_t) {
          if (std::string_view(interface) == "wl_seat") self(data).bind_seat(registry, name);
        },
    .global_remove = [](void*, wl_registry*, std::uint32_t) {}};

const wl_seat_listener WaylandInput::seat_listener{
    .capabilities = [](void* data, wl_seat*, std::uint32_t capabilities) { self(data).use_seat(capabilities); },
    .name = [](void*, wl_seat*, const char*) {}};

// Keys have the codes of Linux, so the map is not needed.
const wl_keyboard_listener WaylandInput::keyboard_listener{
    .keymap = [](void*, wl_keyboard*, std::uint32_t, std::int32_t file, std::uint32_t) { close(file); },
    .enter = [](void*, wl_keyboard*, std::uint32_t, wl_surface*, wl_array*) {},
    .leave = [](void* data, wl_keyboard*, std::uint32_t, wl_surface*) { self(data).shift_ = false; },
    .key = [](void* data, wl_keyboard*, std::uint32_t, std::uint32_t, std::uint32_t code,
              std::uint32_t state) { self(data).key_moved(code, state == WL_KEYBOARD_KEY_STATE_PRESSED); },
    .modifiers = [](void*, wl_keyboard*, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t) {},
    .repeat_info = [](void*, wl_keyboard*, std::int32_t, std::int32_t) {}};

const wl_pointer_listener WaylandInput::pointer_listener = [] {
  wl_pointer_listener listener{};
  listener.enter = [](void* data, wl_pointer*, std::uint32_t, wl_surface* surface, wl_fixed_t x, wl_fixed_t y) {
    const wl_surface* const ours = self(data).surface_;
    self(data).pointer_.here = ours == nullptr || surface == ours;
    self(data).pointer_.move(x, y);
  };
  listener.leave = [](void* data, wl_pointer*, std::uint32_t, wl_surface*) {
    self(data).pointer_.here = false;
    self(data).events_.push_back({.kind = InputEvent::Kind::leave});
  };
  listener.motion = [](void* data, wl_pointer*, std::uint32_t, wl_fixed_t x, wl_fixed_t y) {
    Pointer& pointer = self(data).pointer_;
    pointer.move(x, y);
    if (pointer.here) self(data).events_.push_back({.kind = InputEvent::Kind::move, .x = pointer.x, .y = pointer.y});
  };
  listener.button = [](void* data, wl_pointer*, std::uint32_t, std::uint32_t, std::uint32_t button,
                       std::uint32_t state) {
    const Pointer& pointer = self(data).pointer_;
    if (!pointer.here || button < left_button || button > left_button + 2) return;
    self(data).events_.push_back({.kind = InputEvent::Kind::button,
                                  .down = state == WL_POINTER_BUTTON_STATE_PRESSED,
                                  .x = pointer.x,
                                  .y = pointer.y,
                                  .number = button - left_button});
  };
  listener.axis = [](void* data, wl_pointer*, std::uint32_t, std::uint32_t axis, wl_fixed_t value) {
    if (axis == WL_POINTER_AXIS_VERTICAL_SCROLL && self(data).pointer_.here)
      self(data).events_.push_back(
          {.kind = InputEvent::Kind::wheel, .y = -static_cast<float>(wl_fixed_to_double(value)) / notch});
  };
  return listener;
}();

// A listener is a table of functions, which libwayland takes without their types.
template <class Listener>
void (**functions_of(const Listener& listener))() {
  return reinterpret_cast<void (**)()>(const_cast<Listener*>(&listener));
}

bool WaylandInput::open() {
  queue_ = wayland_.wl_display_create_queue_(display_);
  auto* const wrapper = static_cast<wl_proxy*>(wayland_.wl_proxy_create_wrapper_(display_));
  if (queue_ == nullptr || wrapper == nullptr) return false;
  wayland_.wl_proxy_set_queue_(wrapper, queue_);
  wl_proxy* const registry = make(wrapper, WL_DISPLAY_GET_REGISTRY, wayland_.registry_interface);
  wayland_.wl_proxy_wrapper_destroy_(wrapper);
  if (registry == nullptr) return false;
  wayland_.wl_proxy_add_listener_(registry, functions_of(registry_listener), this);
  wayland_.wl_display_roundtrip_queue_(display_, queue_);  // the globals
  wayland_.wl_display_roundtrip_queue_(display_, queue_);  // what the seat can do
  return keyboard_ != nullptr;
}

void WaylandInput::bind_seat(wl_registry* registry, std::uint32_t name) {
  if (seat_ != nullptr) return;
  std::array<wl_argument, 4> arguments{};
  arguments[0].u = name;
  arguments[1].s = wayland_.seat_interface->name;
  arguments[2].u = 1;
  seat_ = wayland_.wl_proxy_marshal_array_constructor_versioned_(
      reinterpret_cast<wl_proxy*>(registry), WL_REGISTRY_BIND, arguments.data(), wayland_.seat_interface, 1);
  if (seat_ != nullptr) wayland_.wl_proxy_add_listener_(seat_, functions_of(seat_listener), this);
}

void WaylandInput::use_seat(std::uint32_t capabilities) {
  if ((capabilities & WL_SEAT_CAPABILITY_KEYBOARD) != 0 && keyboard_ == nullptr) {
    keyboard_ = make(seat_, WL_SEAT_GET_KEYBOARD, wayland_.keyboard_interface);
    if (keyboard_ != nullptr) wayland_.wl_proxy_add_listener_(keyboard_, functions_of(keyboard_listener), this);
  }
  pointer_.offered = (capabilities & WL_SEAT_CAPABILITY_POINTER) != 0;
}

// While the panel is closed we have no pointer: its events would pile up if the window shows no frames.
void WaylandInput::share(const InputShare& share) {
  if (share.pointer && pointer_.offered && pointer_.proxy == nullptr) {
    pointer_.proxy = make(seat_, WL_SEAT_GET_POINTER, wayland_.pointer_interface);
    if (pointer_.proxy != nullptr)
      wayland_.wl_proxy_add_listener_(pointer_.proxy, functions_of(pointer_listener), this);
    wayland_.wl_display_flush_(display_);
  } else if (!share.pointer && pointer_.proxy != nullptr) {
    wayland_.wl_proxy_destroy_(std::exchange(pointer_.proxy, nullptr));
    pointer_.here = false;
  }
}

void WaylandInput::key_moved(std::uint32_t code, bool down) {
  if (code == left_shift || code == right_shift) shift_ = down;
  if (keys_.panel != nullptr && code == keys_.panel->code) {
    if (down) events_.push_back({.kind = InputEvent::Kind::panel, .down = true, .shift = shift_});
    return;
  }
  if (keys_.toggle != nullptr && code == keys_.toggle->code) {
    if (down) events_.push_back({.kind = InputEvent::Kind::toggle, .down = true});
    return;
  }
  const auto* const found =
      std::find_if(panel_keys.begin(), panel_keys.end(), [&](const auto& row) { return row.first == code; });
  if (found != panel_keys.end())
    events_.push_back({.kind = InputEvent::Kind::key, .down = down, .number = static_cast<unsigned>(found->second)});
}

// The program or its EGL reads the connection, and libwayland puts our events into our queue.
void WaylandInput::poll(std::vector<InputEvent>& events) {
  wayland_.wl_display_dispatch_queue_pending_(display_, queue_);
  wayland_.wl_display_flush_(display_);
  events.insert(events.end(), events_.begin(), events_.end());
  events_.clear();
}

}  // namespace

std::unique_ptr<InputSource> open_wayland_input(wl_display* display, wl_surface* surface, const WantedKeys& keys) {
  const WaylandFunctions* const wayland = wayland_functions();
  if (wayland == nullptr) return nullptr;
  auto input = std::make_unique<WaylandInput>(*wayland, display, surface, keys);
  if (input->open()) return input;
  static_cast<void>(input.release());  // libwayland may still call its listeners
  return nullptr;
}

}  // namespace glark::shim
