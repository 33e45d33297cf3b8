// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/contexts/native_windows.h"

#include <cstring>
#include <map>
#include <mutex>
#include <utility>

#include "shim/linker/dynamic_linker.h"
#include "shim/report/options.h"

namespace glark::shim {
namespace {

constexpr unsigned platform_x11 = 0x31D5;
constexpr unsigned platform_wayland = 0x31D8;
constexpr unsigned platform_xcb = 0x31DC;

struct EglDisplay {
  unsigned platform = 0;
  void* native = nullptr;
};

struct EglSurface {
  std::uintptr_t native = 0;
  std::uint64_t number = 0;
};

struct Windows {
  std::mutex mutex;
  std::map<void*, EglDisplay> displays;
  std::map<std::pair<void*, void*>, EglSurface> surfaces;  // by display and surface
  std::uint64_t surfaces_made = 0;
  std::map<unsigned long, unsigned long> glx_windows;  // by drawable
  std::map<void*, unsigned long> glx_visuals;          // by context
};

// Never destroyed, because programs draw from their exit handlers.
Windows& windows() {
  static Windows& instance = *new Windows;
  return instance;
}

// A wl_display begins with the address of its interface. Mesa tells displays apart in the same way.
bool is_wayland(const void* native) {
  const void* const interface = symbol_of_loaded("libwayland-client.so", "wl_display_interface");
  constexpr std::uintptr_t least_address = 4096;
  if (reinterpret_cast<std::uintptr_t>(native) < least_address || interface == nullptr) return false;
  const void* first = nullptr;
  std::memcpy(&first, native, sizeof(first));
  return first == interface;
}

// The public part of struct wl_egl_window, version 3 (wayland-egl-backend.h).
struct WaylandEglWindow {
  std::intptr_t version;
  int width, height, dx, dy, attached_width, attached_height;
  void* driver_private;
  void (*resize_callback)(WaylandEglWindow*, void*);
  void (*destroy_window_callback)(void*);
  void* surface;
};

void* wayland_surface_of(std::uintptr_t native) {
  const auto* const window = reinterpret_cast<const WaylandEglWindow*>(native);
  return window != nullptr && window->version == 3 ? window->surface : nullptr;
}

std::uintptr_t direct(unsigned platform, void* native, bool indirect) {
  if (!indirect || native == nullptr || platform == platform_wayland) return reinterpret_cast<std::uintptr_t>(native);
  if (platform == platform_xcb) return *static_cast<std::uint32_t*>(native);
  return platform == platform_x11 ? *static_cast<unsigned long*>(native) : 0;
}

NativeWindow window_of_egl(const Surface& surface) {
  Windows& all = windows();
  const std::lock_guard lock(all.mutex);
  const auto display = all.displays.find(surface.display);
  const auto found = all.surfaces.find({surface.display, surface.drawable});
  NativeWindow window;
  if (display == all.displays.end() || found == all.surfaces.end() || found->second.native == 0) return window;
  window.number = found->second.number;
  if (display->second.platform == platform_wayland) {
    window.system = NativeWindow::System::wayland;
    window.wayland_display = display->second.native;
    window.wayland_surface = wayland_surface_of(found->second.native);
    if (window.wayland_display == nullptr) window.system = NativeWindow::System::none;  // EGL's own connection
  } else if (display->second.platform == platform_x11 || display->second.platform == platform_xcb) {
    window.system = NativeWindow::System::x11;
    window.x11_window = static_cast<std::uint32_t>(found->second.native);
  }
  return window;
}

NativeWindow window_of_glx(const Surface& surface) {
  NativeWindow window{.system = NativeWindow::System::x11};
  using DisplayName = const char* (*)(void*);
  if (const auto name = reinterpret_cast<DisplayName>(symbol_of_loaded("libX11.so", "XDisplayString")))
    window.x11_display = name(surface.display);
  Windows& all = windows();
  const std::lock_guard lock(all.mutex);
  const auto drawable = reinterpret_cast<unsigned long>(surface.drawable);
  const auto found = all.glx_windows.find(drawable);
  window.x11_window = static_cast<std::uint32_t>(found != all.glx_windows.end() ? found->second : drawable);
  return window;
}

}  // namespace

void note_egl_display(unsigned platform, void* native, void* display) {
  if (display == nullptr || !wants_keys()) return;
  const unsigned guessed = is_wayland(native) ? platform_wayland : platform_x11;
  Windows& all = windows();
  const std::lock_guard lock(all.mutex);
  all.displays[display] = {platform != 0 ? platform : guessed, native};
}

void note_egl_window(void* display, void* native, bool indirect, void* surface) {
  if (surface == nullptr || !wants_keys()) return;
  Windows& all = windows();
  const std::lock_guard lock(all.mutex);
  const auto found = all.displays.find(display);
  const unsigned platform = found != all.displays.end() ? found->second.platform : 0;
  all.surfaces[{display, surface}] = {direct(platform, native, indirect), ++all.surfaces_made};
}

void note_glx_window(unsigned long window, unsigned long drawable) {
  if (!wants_keys()) return;
  Windows& all = windows();
  const std::lock_guard lock(all.mutex);
  all.glx_windows[drawable] = window;
}

void note_glx_visual(void* context, const void* visual) {
  if (context == nullptr || !wants_keys()) return;
  struct VisualInfo {  // the beginning of XVisualInfo (X11/Xutil.h)
    void* visual;
    unsigned long id;
  };
  Windows& all = windows();
  const std::lock_guard lock(all.mutex);
  all.glx_visuals[context] = visual != nullptr ? static_cast<const VisualInfo*>(visual)->id : 0;
}

unsigned long glx_visual_of(void* context) {
  Windows& all = windows();
  const std::lock_guard lock(all.mutex);
  const auto found = all.glx_visuals.find(context);
  return found != all.glx_visuals.end() ? found->second : 0;
}

NativeWindow native_window_of(Provider provider, const Surface& surface) {
  if (surface.drawable == nullptr || provider == Provider::osmesa) return {};
  return provider == Provider::glx ? window_of_glx(surface) : window_of_egl(surface);
}

}  // namespace glark::shim
