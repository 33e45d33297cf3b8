// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/names/name_table.h"

#include <dlfcn.h>

#include <algorithm>
#include <iterator>

#include "glark/gl/types.h"
#include "shim/names/window_functions.h"
#include "shim/names/wrappers.h"

namespace glark::shim {
namespace {

// Sorted by name.
const Name gl_names[] = {
#include "shim/names/names.inc"
};

const Name* find_gl(std::string_view name) {
  const Name* found = std::lower_bound(std::begin(gl_names), std::end(gl_names), name,
                                       [](const Name& entry, std::string_view wanted) { return entry.name < wanted; });
  return found != std::end(gl_names) && found->name == name ? found : nullptr;
}

const Name window_system_names[] = {
#define GLARK_WINDOW_FUNCTION(function) {#function, reinterpret_cast<void*>(&function), NameKind::window_system},
#include "shim/names/window_functions.inc"
#undef GLARK_WINDOW_FUNCTION
    {"dlsym", reinterpret_cast<void*>(&dlsym), NameKind::linker},
    {"dlvsym", reinterpret_cast<void*>(&dlvsym), NameKind::linker},
    {"dlopen", reinterpret_cast<void*>(&dlopen), NameKind::linker},
};

}  // namespace

const Name* find_name(std::string_view name) {
  const bool window_system =
      name.starts_with("glX") || name.starts_with("egl") || name.starts_with("OSMesa") || name.starts_with("dl");
  if (!window_system) return name.starts_with("gl") ? find_gl(name) : nullptr;
  for (const Name& entry : window_system_names)
    if (entry.name == name) return &entry;
  return nullptr;
}

}  // namespace glark::shim
