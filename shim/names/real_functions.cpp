// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/names/real_functions.h"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <string_view>

#include "glark/core/report/log.h"
#include "shim/linker/dynamic_linker.h"
#include "shim/names/name_table.h"

namespace glark::shim {
namespace {

constexpr std::size_t function_count = static_cast<std::size_t>(WindowFunction::count_);

constexpr std::array<const char*, function_count> names{
#define GLARK_WINDOW_FUNCTION(function) #function,
#include "shim/names/window_functions.inc"
#undef GLARK_WINDOW_FUNCTION
};

std::array<std::atomic<void*>, function_count> real_functions{};

std::uintptr_t missing_function() { return 0; }

// Looks for a function of an extension, which a library need not export, by the library's own GetProcAddress.
void* ask_provider(std::string_view name) {
  if (name.find("GetProcAddress") != std::string_view::npos) return nullptr;
  if (name.starts_with("glX"))
    return reinterpret_cast<void*>(GLARK_REAL(glXGetProcAddressARB)(reinterpret_cast<const GLubyte*>(name.data())));
  if (name.starts_with("egl")) return reinterpret_cast<void*>(GLARK_REAL(eglGetProcAddress)(name.data()));
  return reinterpret_cast<void*>(GLARK_REAL(OSMesaGetProcAddress)(name.data()));
}

void* find_real(const char* name) {
  const void* wrapper = find_name(name)->wrapper;
  void* real = next_symbol(name);
  if (real == nullptr || real == wrapper) real = symbol_of_loaded_gl(name);
  if (real == nullptr || real == wrapper) real = ask_provider(name);
  return real == wrapper ? nullptr : real;
}

}  // namespace

void* real_window_function(WindowFunction function) {
  const auto index = static_cast<std::size_t>(function);
  void* real = real_functions[index].load(std::memory_order_acquire);
  if (real != nullptr) return real;
  real = find_real(names[index]);
  if (real == nullptr) {
    core::log(core::LogLevel::debug,
              fmt::format("{} was called or looked for, but no library of this process has it", names[index]));
    return reinterpret_cast<void*>(&missing_function);
  }
  real_functions[index].store(real, std::memory_order_release);
  return real;
}

void note_real_window_function(const char* name, void* real) {
  for (std::size_t i = 0; i < function_count; ++i) {
    if (std::string_view(names[i]) != name || real == find_name(name)->wrapper) continue;
    void* none = nullptr;
    if (real_functions[i].compare_exchange_strong(none, real, std::memory_order_acq_rel)) keep_loaded(real);
    return;
  }
}

void* wrapper_or(const char* name, void* real) {
  const Name* entry = name == nullptr ? nullptr : find_name(name);
  if (entry == nullptr || (real == nullptr && entry->kind != NameKind::ours)) return real;
  if (entry->kind == NameKind::window_system) note_real_window_function(name, real);
  return entry->wrapper;
}

}  // namespace glark::shim
