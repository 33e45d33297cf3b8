// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The module glark._glark: the client libraries for Python.
#include <glark/error.h>

#include "glark/clients/geometry/geometry.h"
#include "glark/python/arrays.h"

PYBIND11_MODULE(_glark, module) {
  namespace py = pybind11;
  module.attr("__version__") = GLARK_VERSION;
  py::register_exception<glark::ArgumentError>(module, "ArgumentError", PyExc_ValueError).doc() =
      "A value that a function cannot use. The text names the element, its value, and the remedy.";
  py::register_exception<glark::geometry::Error>(module, "FileError", PyExc_OSError).doc() =
      "A file that cannot be read or written.";
  glark::python::bind_files(module);
  glark::python::bind_vstree(module);
  glark::python::bind_reconstruct(module);
  glark::python::bind_stream(module);
  glark::python::bind_surfel(module);
  glark::python::bind_qas(module);
  glark::python::bind_pn(module);
  glark::python::bind_depth(module);
}
