// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/input/wayland_functions.h"

#include "shim/linker/dynamic_linker.h"

namespace glark::shim {
namespace {

template <class Symbol>
bool find(const char* name, Symbol& symbol) {
  symbol = reinterpret_cast<Symbol>(symbol_of_loaded("libwayland-client.so", name));
  return symbol != nullptr;
}

bool find_all(WaylandFunctions& functions) {
  bool complete = true;
#define GLARK_WAYLAND_FIND(function) complete = complete && find(#function, functions.function##_);
  GLARK_WAYLAND_FUNCTIONS(GLARK_WAYLAND_FIND)
#undef GLARK_WAYLAND_FIND
  return complete && find("wl_display_interface", functions.display_interface) &&
         find("wl_registry_interface", functions.registry_interface) &&
         find("wl_seat_interface", functions.seat_interface) &&
         find("wl_pointer_interface", functions.pointer_interface) &&
         find("wl_keyboard_interface", functions.keyboard_interface);
}

}  // namespace

const WaylandFunctions* wayland_functions() {
  static WaylandFunctions functions;
  static const bool complete = find_all(functions);
  return complete ? &functions : nullptr;
}

}  // namespace glark::shim
