// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// An array that a Python function gets. NumPy would convert anything: -1 to a vertex 4294967295, half a triangle index to a
// whole one, complex numbers to their real part. Here, what does not fit is refused.
#pragma once

#include <fmt/format.h>
#include <glark/error.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

namespace glark::python {

namespace py = pybind11;

// Holds the array in rows (C order), or what is wrong with it. The name of the argument is known only later: checked().
template <class T>
class Array {
 public:
  using Values = py::array_t<T, py::array::c_style | py::array::forcecast>;

  Array() = default;
  explicit Array(py::handle given) {
    if (fits(given)) {
      values_ = py::reinterpret_borrow<Values>(given);
    } else {
      convert(given);
    }
  }

  // Throws ArgumentError.
  const Values& checked(const char* name) const {
    if (!problem_.empty()) throw ArgumentError(fmt::format("glark: {} {}", name, problem_));
    return values_;
  }

 private:
  static constexpr int aligned_flag = 0x0100;  // NPY_ARRAY_ALIGNED

  static bool fits(py::handle given) {
    return py::isinstance<Values>(given) && (py::reinterpret_borrow<py::array>(given).flags() & aligned_flag) != 0;
  }

  static bool is_number(char kind) {
    return kind == 'b' || kind == 'i' || kind == 'u' || (kind == 'f' && std::is_floating_point_v<T>);
  }

  static std::string wanted() {
    if constexpr (std::is_floating_point_v<T>) return "numbers";
    return fmt::format("integers from 0 to {}", std::numeric_limits<T>::max());
  }

  void convert(py::handle given) {
    const py::array array = given.is_none() ? py::array() : py::array::ensure(given);
    if (given.is_none() || !array) {
      PyErr_Clear();
      problem_ = given.is_none() ? "is None; give it an array"
                                 : "cannot be read as an array; give it a NumPy array, or lists of equal lengths";
      return;
    }
    const bool empty = array.size() == 0;  // an empty list has a type, too
    if (!empty && !is_number(array.dtype().kind())) {
      problem_ =
          array.dtype().kind() == 'O'
              ? fmt::format("is of the type {}; give it an array of {}, as the positions of a mesh",
                            std::string(py::str(py::type::of(given).attr("__name__"))), wanted())
              : fmt::format("has the type {}; give it {}", std::string(py::str(py::handle(array.dtype()))), wanted());
      return;
    }
    if constexpr (std::is_integral_v<T>) {
      if (!empty && !in_range(array)) return;
    }
    values_ = Values(py::array(array.attr("astype")(py::dtype::of<T>(), "C")));
  }

  bool in_range(const py::array& array) {
    for (const char* extreme : {"min", "max"}) {
      const py::int_ value(array.attr(extreme)());
      if (value >= py::int_(0) && value <= py::int_(std::numeric_limits<T>::max())) continue;
      problem_ = fmt::format("has the value {}; give it {}", std::string(py::str(py::handle(value))), wanted());
      return false;
    }
    return true;
  }

  Values values_;
  std::string problem_;
};

}  // namespace glark::python

namespace pybind11::detail {

template <class T>
struct type_caster<glark::python::Array<T>> {
  PYBIND11_TYPE_CASTER(glark::python::Array<T>, handle_type_name<array_t<T>>::name);
  bool load(handle source, bool) {
    value = glark::python::Array<T>(source);
    return true;
  }
};

}  // namespace pybind11::detail
