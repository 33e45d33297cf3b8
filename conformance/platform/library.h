// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace glark::conformance {

// A shared library and its functions by name. It stays loaded, because drivers do not survive being unloaded.
class Library {
 public:
  explicit Library(const char* name) : name_(name), handle_(dlopen(name, RTLD_NOW | RTLD_GLOBAL)) {
    if (handle_ == nullptr) throw std::runtime_error("cannot load " + name_ + ": " + dlerror());
  }

  template <typename Function>
  void get(Function*& function, const char* symbol) const {
    function = reinterpret_cast<Function*>(dlsym(handle_, symbol));
    if (function == nullptr) throw std::runtime_error(name_ + " has no " + symbol);
  }

 private:
  std::string name_;
  void* handle_;
};

}  // namespace glark::conformance
