// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The functions of libwayland-client that this process has loaded. We link to no library of a window system.
#pragma once

#include <wayland-client-core.h>

namespace glark::shim {

#define GLARK_WAYLAND_FUNCTIONS(use)                                                                                \
  use(wl_display_create_queue) use(wl_display_dispatch_queue_pending) use(wl_display_flush)                         \
      use(wl_display_roundtrip_queue) use(wl_proxy_add_listener) use(wl_proxy_create_wrapper) use(wl_proxy_destroy) \
          use(wl_proxy_marshal_array_constructor) use(wl_proxy_marshal_array_constructor_versioned)                 \
              use(wl_proxy_set_queue) use(wl_proxy_wrapper_destroy)

// Each function has its name and an underscore.
struct WaylandFunctions {
#define GLARK_WAYLAND_MEMBER(function) decltype(&::function) function##_ = nullptr;
  GLARK_WAYLAND_FUNCTIONS(GLARK_WAYLAND_MEMBER)
#undef GLARK_WAYLAND_MEMBER
  const wl_interface* display_interface = nullptr;
  const wl_interface* registry_interface = nullptr;
  const wl_interface* seat_interface = nullptr;
  const wl_interface* pointer_interface = nullptr;
  const wl_interface* keyboard_interface = nullptr;
};

// Null: the process has no libwayland-client.
const WaylandFunctions* wayland_functions();

}  // namespace glark::shim
