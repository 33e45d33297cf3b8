// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A number without sign that a Python function gets. pybind11 would answer -1 with a TypeError that lists C++ types; here
// it is an ArgumentError with the name of the argument.
#pragma once

#include <fmt/format.h>
#include <glark/error.h>
#include <pybind11/pybind11.h>

#include <limits>
#include <string>

namespace glark::python {

template <class T>
class Whole {
 public:
  Whole() = default;
  // given: an int of Python.
  explicit Whole(pybind11::handle given) {
    const unsigned long long value = PyLong_AsUnsignedLongLong(given.ptr());
    const bool fits = PyErr_Occurred() == nullptr && value <= std::numeric_limits<T>::max();
    PyErr_Clear();
    if (fits) {
      value_ = static_cast<T>(value);
    } else {
      wrong_ = pybind11::str(given);
    }
  }

  // Throws ArgumentError.
  T checked(const char* name) const {
    if (wrong_.empty()) return value_;
    throw ArgumentError(
        fmt::format("glark: {} is {}; give it a number from 0 to {}", name, wrong_, std::numeric_limits<T>::max()));
  }

 private:
  T value_ = 0;
  std::string wrong_;
};

}  // namespace glark::python

namespace pybind11::detail {

template <class T>
struct type_caster<glark::python::Whole<T>> {
  PYBIND11_TYPE_CASTER(glark::python::Whole<T>, const_name("int"));
  bool load(handle source, bool) {
    if (!source || PyIndex_Check(source.ptr()) == 0) return false;
    const auto number = reinterpret_steal<object>(PyNumber_Index(source.ptr()));
    if (!number) {
      PyErr_Clear();
      return false;
    }
    value = glark::python::Whole<T>(number);
    return true;
  }
};

}  // namespace pybind11::detail
