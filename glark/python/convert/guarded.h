// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// An object that Python threads may share. Computations release the interpreter's lock, so each object has one of its own.
#pragma once

#include <pybind11/pybind11.h>

#include <mutex>
#include <shared_mutex>
#include <utility>

namespace glark::python {

template <class Object>
class Guarded {
 public:
  template <class... Arguments>
  explicit Guarded(Arguments&&... arguments) : object_(std::forward<Arguments>(arguments)...) {}

  // Calls a step that touches no Python object. Several threads may read at once.
  template <class Step>
  auto read(const Step& step) const {
    const pybind11::gil_scoped_release released;
    const std::shared_lock lock(mutex_);
    return step(object_);
  }
  template <class Step>
  auto change(const Step& step) {
    const pybind11::gil_scoped_release released;
    const std::unique_lock lock(mutex_);
    return step(object_);
  }

  // For what never changes.
  const Object& fixed() const { return object_; }

 private:
  Object object_;
  mutable std::shared_mutex mutex_;
};

}  // namespace glark::python
