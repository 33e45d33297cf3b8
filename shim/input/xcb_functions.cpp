// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/input/xcb_functions.h"

#include "shim/linker/dynamic_linker.h"

namespace glark::shim {
namespace {

template <class Function>
bool find(const char* name, Function& function) {
  function = reinterpret_cast<Function>(symbol_of_loaded("libxcb.so", name));
  return function != nullptr;
}

const XcbFunctions* find_all() {
  static XcbFunctions functions;
  bool complete = true;
#define GLARK_XCB_FIND(function) complete = find(#function, functions.function##_) && complete;
  GLARK_XCB_FUNCTIONS(GLARK_XCB_FIND)
#undef GLARK_XCB_FIND
  return complete ? &functions : nullptr;
}

}  // namespace

const XcbFunctions* xcb_functions() {
  static const XcbFunctions* const functions = find_all();
  return functions;
}

}  // namespace glark::shim
