// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Class.__new__(Class) makes a Python object without its C++ object. pybind11 would hand out uninitialised memory for it, and
// the program would crash. The casters of this header raise TypeError instead.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <type_traits>

namespace glark::python {

// Each file says which classes it binds, before it binds them.
template <class Object>
inline constexpr bool is_bound = false;

}  // namespace glark::python

namespace pybind11::detail {

template <class Object>
class type_caster<Object, std::enable_if_t<glark::python::is_bound<Object>>> : public type_caster_base<Object> {
 public:
  // pybind11 has the name.
  bool load(handle source, bool convert) {  // NOLINT(readability-identifier-naming)
    const type_info* const type = get_type_info(typeid(Object));
    if (type != nullptr && source && PyObject_TypeCheck(source.ptr(), type->type) != 0 &&
        !reinterpret_cast<instance*>(source.ptr())->get_value_and_holder(type)) {
      throw type_error(std::string(type->type->tp_name) + " object without content: its __init__ was not called");
    }
    return type_caster_base<Object>::load(source, convert);
  }
};

}  // namespace pybind11::detail
