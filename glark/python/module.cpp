// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The module glark._glark: the client libraries for Python.
#include <glark/error.h>

#include "glark/clients/geometry/geometry.h"
#include "glark/python/convert/arrays.h"
#include "glark/python/convert/text.h"

namespace glark::python {
namespace {

// As py::register_exception(), but the text may have names that are not UTF-8.
template <class Exception>
void register_error(py::module_& module, const char* name, PyObject* base, const char* text) {
  py::exception<Exception> type(module, name, base);
  type.doc() = text;
  static py::handle registered;
  registered = type.release();  // lives as long as the program
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Exception& error) {
      raise(registered, error.what());
    }
  });
}

}  // namespace
}  // namespace glark::python

PYBIND11_MODULE(_glark, module) {
  module.attr("__version__") = GLARK_VERSION;
  glark::python::register_error<glark::ArgumentError>(
      module, "ArgumentError", PyExc_ValueError,
      "A value that a function cannot use. The text names the element, its value, and the remedy.");
  glark::python::register_error<glark::geometry::Error>(module, "FileError", PyExc_OSError,
                                                        "A file that cannot be read or written.");
  glark::python::bind_files(module);
  glark::python::bind_vstree(module);
  glark::python::bind_reconstruct(module);
  glark::python::bind_stream(module);
  glark::python::bind_maps(module);
  glark::python::bind_surfel(module);
  glark::python::bind_qas(module);
  glark::python::bind_pn(module);
  glark::python::bind_depth(module);
}
