// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// NumPy arrays as spans, and results as NumPy arrays. An array of the right type in rows (C order) is read where it lies;
// others are converted first (array_argument.h). Results are never copied: an array keeps what owns its memory alive.
#pragma once

#include <fmt/format.h>
#include <glark/error.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "glark/python/convert/array_argument.h"
#include "glark/python/convert/whole_number.h"

namespace glark::python {

namespace py = pybind11;

template <class T>
using OptionalArray = std::optional<Array<T>>;

// The numbers of an array of the shape (n, `columns`), or (n,) if `columns` is 1. Throws ArgumentError for any other
// shape.
template <class T>
std::span<const T> rows(const Array<T>& given, py::ssize_t columns, const char* name) {
  const auto& array = given.checked(name);
  const bool fits = columns == 1 ? array.ndim() == 1 : array.ndim() == 2 && array.shape(1) == columns;
  if (!fits) {
    std::string shape;
    for (py::ssize_t i = 0; i < array.ndim(); ++i) shape += fmt::format("{}{}", i == 0 ? "" : ", ", array.shape(i));
    throw ArgumentError(fmt::format("glark: {} has the shape ({}); give it the shape {}", name, shape,
                                    columns == 1 ? "(n,)" : fmt::format("(n, {})", columns)));
  }
  return {array.data(), static_cast<std::size_t>(array.size())};
}

template <class T>
std::span<const T> rows(const OptionalArray<T>& array, py::ssize_t columns, const char* name) {
  return array ? rows(*array, columns, name) : std::span<const T>{};
}

inline std::vector<py::ssize_t> shape_of(std::size_t numbers, py::ssize_t columns) {
  const auto count = static_cast<py::ssize_t>(numbers);
  return columns == 1 ? std::vector<py::ssize_t>{count} : std::vector<py::ssize_t>{count / columns, columns};
}

// An array that owns the vector.
template <class T>
py::array_t<T> owned(std::vector<T>&& values, py::ssize_t columns) {
  auto moved = std::make_unique<std::vector<T>>(std::move(values));
  std::vector<T>* vector = moved.get();
  const py::capsule owner(moved.release(), [](void* memory) { delete static_cast<std::vector<T>*>(memory); });
  return py::array_t<T>(shape_of(vector->size(), columns), vector->data(), owner);
}

// A read-only array of memory that `owner` keeps.
template <class T>
py::array_t<T> view(std::span<const T> values, py::ssize_t columns, py::handle owner) {
  py::array_t<T> array(shape_of(values.size(), columns), values.data(), owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

template <class T>
py::array_t<T> view(const std::vector<T>& values, py::ssize_t columns, py::handle owner) {
  return view(std::span<const T>(values), columns, owner);
}

// None where a result has no such attribute.
template <class T>
py::object view_or_none(const std::vector<T>& values, py::ssize_t columns, py::handle owner) {
  return values.empty() ? py::object(py::none()) : py::object(view(values, columns, owner));
}

// The enumerator of a name. Throws ArgumentError, which lists the names.
template <class Enumeration, std::size_t Count>
Enumeration named(const std::string& name, const char* option,
                  const std::array<std::pair<const char*, Enumeration>, Count>& names) {
  std::string all;
  for (const auto& [known, value] : names) {
    if (name == known) return value;
    all += fmt::format("{}'{}'", all.empty() ? "" : ", ", known);
  }
  throw ArgumentError(fmt::format("glark: {} is '{}'; use one of {}", option, name, all));
}

// Runs a computation that touches no Python object, while other Python threads run.
template <class Step>
auto without_gil(const Step& step) {
  const py::gil_scoped_release released;
  return step();
}

void bind_depth(py::module_& module);
void bind_files(py::module_& module);
void bind_maps(py::module_& module);
void bind_pn(py::module_& module);
void bind_qas(py::module_& module);
void bind_reconstruct(py::module_& module);
void bind_stream(py::module_& module);
void bind_surfel(py::module_& module);
void bind_vstree(py::module_& module);

}  // namespace glark::python
