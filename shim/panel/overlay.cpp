// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/panel/overlay.h"

#include <exception>
#include <memory>
#include <mutex>
#include <vector>

#include "glark/core/report/log.h"
#include "shim/contexts/contexts.h"
#include "shim/contexts/native_windows.h"
#include "shim/input/wayland_input.h"
#include "shim/input/x11_input.h"
#include "shim/live/live_settings.h"
#include "shim/panel/panel.h"
#include "shim/report/options.h"

namespace glark::shim {
namespace {

struct OverlayWindow {
  Provider provider = Provider::glx;
  Surface surface;
  std::uint64_t number = 0;            // of its NativeWindow
  std::unique_ptr<InputSource> input;  // null: there are no keys in this window
};

// Programs that open windows without end get keys in the first ones.
constexpr std::size_t most_windows = 32;

struct Overlay {
  std::mutex mutex;
  std::vector<std::unique_ptr<OverlayWindow>> windows;
  OverlayWindow* shown_in = nullptr;  // the window with the panel; null: the panel is closed
  bool keyboard = false;              // the panel has all keys
  bool told = false;                  // that the panel is open
  bool waits_to_open = options().overlay && options().overlay_open;  // no window was there yet
  Panel panel;
  bool failed = false;
};

// Never destroyed, because programs draw from their exit handlers, and libwayland knows our listeners.
Overlay& overlay() {
  static Overlay& instance = *new Overlay;
  return instance;
}

std::unique_ptr<InputSource> open_input(const NativeWindow& window) {
  const WantedKeys keys{options().overlay ? options().overlay_key : nullptr, options().toggle_key};
  if (window.system == NativeWindow::System::x11)
    return open_x11_input(window.x11_display.empty() ? nullptr : window.x11_display.c_str(), window.x11_window, keys);
  if (window.system == NativeWindow::System::wayland)
    return open_wayland_input(static_cast<wl_display*>(window.wayland_display),
                              static_cast<wl_surface*>(window.wayland_surface), keys);
  return nullptr;
}

void close_panel(Overlay& all) {
  if (all.shown_in->input != nullptr) all.shown_in->input->share({});
  all.shown_in = nullptr;
  all.told = false;
  all.panel.closed();
}

// The name of a window may be used again for another one.
void forget_gone(Overlay& all, const NativeWindow& current) {
  const Surface surface = current_surface();
  std::erase_if(all.windows, [&](const std::unique_ptr<OverlayWindow>& window) {
    const bool renamed =
        window->provider == current_provider() && window->surface == surface && window->number != current.number;
    const bool gone = renamed || (window->input != nullptr && window->input->gone());
    if (gone && all.shown_in == window.get()) {
      all.shown_in = nullptr;
      all.panel.closed();
    }
    return gone;
  });
}

OverlayWindow* find_window(Overlay& all, const NativeWindow& native) {
  const Surface surface = current_surface();
  for (const std::unique_ptr<OverlayWindow>& window : all.windows)
    if (window->provider == current_provider() && window->surface == surface) return window.get();
  if (all.windows.size() >= most_windows) return nullptr;
  auto window = std::make_unique<OverlayWindow>();
  window->provider = current_provider();
  window->surface = surface;
  window->number = native.number;
  window->input = open_input(native);
  if (window->input == nullptr)
    core::log(core::LogLevel::warning, "this window gives no keys: the panel and --toggle-key do not work in it");
  all.windows.push_back(std::move(window));
  return all.windows.back().get();
}

void follow_key(Overlay& all, OverlayWindow& window, const InputEvent& event) {
  if (all.shown_in == &window) {
    close_panel(all);
    return;
  }
  if (all.shown_in != nullptr) close_panel(all);
  all.shown_in = &window;
  all.keyboard = event.shift;
}

void open_at_start(Overlay& all, OverlayWindow& window) {
  if (!all.waits_to_open) return;
  all.waits_to_open = false;
  all.shown_in = &window;
}

void follow_events(Overlay& all, OverlayWindow& window) {
  std::vector<InputEvent> events;
  window.input->poll(events);
  for (const InputEvent& event : events) {
    if (event.kind == InputEvent::Kind::toggle)
      toggle_refinement();
    else if (event.kind == InputEvent::Kind::panel)
      follow_key(all, window, event);
    else if (all.shown_in == &window)
      all.panel.add(event);
  }
}

void run_frame(Overlay& all, core::Context& context) {
  const NativeWindow native = native_window_of(current_provider(), current_surface());
  forget_gone(all, native);
  OverlayWindow* const window = find_window(all, native);
  if (window == nullptr || window->input == nullptr) return;
  open_at_start(all, *window);
  follow_events(all, *window);
  if (all.shown_in != window) return;
  if (!all.panel.draw(context, window->surface)) {
    close_panel(all);
    return;
  }
  window->input->share(all.panel.share(all.keyboard));
  if (!all.told) core::log(core::LogLevel::info, "the panel is open");
  all.told = true;
}

}  // namespace

void overlay_frame(core::Context& context) {
  if (!wants_keys() || current_is_offscreen()) return;
  Overlay& all = overlay();
  const std::lock_guard lock(all.mutex);
  if (all.failed) return;
  try {
    run_frame(all, context);
  } catch (const std::exception& error) {
    all.failed = true;
    core::log(core::LogLevel::error, std::string("the panel is closed: ") + error.what());
    if (all.shown_in != nullptr) close_panel(all);
  }
}

}  // namespace glark::shim
