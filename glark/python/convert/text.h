// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Texts that may have names of files. The system takes any bytes as a name, so they need not be UTF-8.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace glark::python {

// Returns the text as os.fsdecode() does: bytes that are no characters become surrogates, and can be encoded again.
inline pybind11::object text_of(const std::string& bytes) {
  PyObject* text = PyUnicode_DecodeFSDefaultAndSize(bytes.data(), static_cast<Py_ssize_t>(bytes.size()));
  if (text == nullptr) throw pybind11::error_already_set();
  return pybind11::reinterpret_steal<pybind11::object>(text);
}

// Sets the Python exception; no C++ exception leaves it. If the text cannot be made, that error is set instead.
inline void raise(pybind11::handle type, const char* what) {
  PyObject* text = PyUnicode_DecodeFSDefault(what);
  if (text == nullptr) return;
  PyErr_SetObject(type.ptr(), text);
  Py_DECREF(text);
}

}  // namespace glark::python
