// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/contexts/provider.h"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cstring>
#include <mutex>
#include <string>
#include <utility>

#include "glark/core/report/log.h"
#include "shim/linker/dynamic_linker.h"
#include "shim/names/name_table.h"
#include "shim/names/real_functions.h"

namespace glark::shim {
namespace {

constexpr std::size_t member_count = sizeof(gl::Dispatch) / sizeof(void*);

void log_missing_once(std::size_t index) {
  static std::array<std::atomic<bool>, member_count> said{};
  if (said[index].exchange(true)) return;
  core::log(core::LogLevel::warning,
            fmt::format("{} was called, but the OpenGL driver does not have it; the call is ignored",
                        gl::members()[index].name));
}

// Replaces a function that the driver lacks. There is one for each member, so that the log can name the function. Any
// GL function may be called through it, because the caller cleans the stack and the result is in a register.
template <std::size_t index>
std::uintptr_t missing_function() {
  log_missing_once(index);
  return 0;
}

template <std::size_t... indices>
constexpr std::array<std::uintptr_t (*)(), member_count> make_missing_functions(std::index_sequence<indices...>) {
  return {&missing_function<indices>...};
}

constexpr auto missing_functions = make_missing_functions(std::make_index_sequence<member_count>{});

void* ask(const Provider* provider, const char* name) {
  if (provider == nullptr) return nullptr;
  switch (*provider) {
    case Provider::glx:
      return reinterpret_cast<void*>(GLARK_REAL(glXGetProcAddressARB)(reinterpret_cast<const GLubyte*>(name)));
    case Provider::egl: return reinterpret_cast<void*>(GLARK_REAL(eglGetProcAddress)(name));
    case Provider::osmesa: return reinterpret_cast<void*>(GLARK_REAL(OSMesaGetProcAddress)(name));
  }
  return nullptr;
}

// `user` is the provider, or nullptr.
void* get_proc(void* user, const char* name) {
  const Name* entry = find_name(name);
  const void* wrapper = entry == nullptr ? nullptr : entry->wrapper;
  void* function = ask(static_cast<const Provider*>(user), name);
  // A library may return an address that the dynamic linker has bound to our wrapper.
  if (function == nullptr || function == wrapper) function = find_symbol(name);
  return function == wrapper ? nullptr : function;
}

void fill_missing(gl::Dispatch& dispatch) {
  auto* bytes = reinterpret_cast<char*>(&dispatch);
  for (std::size_t i = 0; i < member_count; ++i) {
    void* function = nullptr;
    std::memcpy(&function, bytes + gl::members()[i].offset, sizeof function);
    if (function == nullptr) std::memcpy(bytes + gl::members()[i].offset, &missing_functions[i], sizeof function);
  }
}

const gl::Dispatch& load_once(std::once_flag& once, gl::Dispatch& dispatch, Provider* provider) {
  std::call_once(once, [&] {
    gl::load(dispatch, get_proc, provider);
    fill_missing(dispatch);
  });
  return dispatch;
}

}  // namespace

const gl::Dispatch& dispatch_of(Provider provider) {
  static std::once_flag once[provider_count];
  static gl::Dispatch dispatch[provider_count];
  return load_once(once[static_cast<int>(provider)], dispatch[static_cast<int>(provider)], &provider);
}

const gl::Dispatch& dispatch_without_context() {
  static std::once_flag once;
  static gl::Dispatch dispatch;
  return load_once(once, dispatch, nullptr);
}

}  // namespace glark::shim
