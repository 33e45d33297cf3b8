// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Dear ImGui checks its callers with assert(), in Debian's release builds, too. A failed assertion must not end the
// program that shows the panel. The linker leads assert() of this library here (--wrap=__assert_fail).
#pragma once

#include <memory>
#include <string>
#include <type_traits>

namespace glark::shim {

// Calls use(data), which calls Dear ImGui. False: an assertion failed, and the rest of `use` was left out. Then Dear
// ImGui must not be called again. Exceptions pass.
bool survives_assertions(void (*use)(void*), void* data);
template <class Use>
bool survives_assertions(Use&& use) {
  return survives_assertions([](void* data) { (*static_cast<std::remove_reference_t<Use>*>(data))(); },
                             std::addressof(use));
}

// The expression that failed last, and its place.
std::string failed_assertion();

}  // namespace glark::shim
