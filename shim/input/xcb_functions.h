// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The functions of libxcb that this process has loaded; every program with a window on X11 has it. We link to no library
// of a window system.
#pragma once

#include <xcb/xcb.h>

namespace glark::shim {

#define GLARK_XCB_FUNCTIONS(use)                                                                                  \
  use(xcb_connect) use(xcb_disconnect) use(xcb_connection_has_error) use(xcb_flush) use(xcb_poll_for_event)       \
      use(xcb_generate_id) use(xcb_get_setup) use(xcb_query_tree) use(xcb_query_tree_reply)                       \
          use(xcb_get_keyboard_mapping) use(xcb_get_keyboard_mapping_reply) use(xcb_get_keyboard_mapping_keysyms) \
              use(xcb_query_pointer) use(xcb_query_pointer_reply) use(xcb_grab_key) use(xcb_grab_keyboard)        \
                  use(xcb_ungrab_keyboard) use(xcb_create_window) use(xcb_change_window_attributes)               \
                      use(xcb_configure_window) use(xcb_map_window) use(xcb_unmap_window) use(xcb_open_font)      \
                          use(xcb_create_glyph_cursor)

// Each member has the name of its function and an underscore.
struct XcbFunctions {
#define GLARK_XCB_MEMBER(function) decltype(&::function) function##_ = nullptr;
  GLARK_XCB_FUNCTIONS(GLARK_XCB_MEMBER)
#undef GLARK_XCB_MEMBER
};

// Null: the process has no libxcb.
const XcbFunctions* xcb_functions();

}  // namespace glark::shim
