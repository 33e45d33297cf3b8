// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Long computations on the files of scans: their errors become FileError, and Ctrl-C ends them.
#pragma once

#include <glark/point_stream.h>

#include "glark/clients/geometry/geometry.h"
#include "glark/python/convert/arrays.h"

namespace glark::python {

// Runs a step without the interpreter's lock. What is wrong with a file becomes FileError.
template <class Step>
auto with_files(const Step& step) {
  try {
    return without_gil(step);
  } catch (const stream::Error& error) {
    if (error.element() != stream::Element::file) throw;
    throw geometry::Error(error.what());
  }
}

// Lets Ctrl-C end a computation: what throws here goes through the library, which leaves nothing half-written. Only the
// main thread of Python handles signals; in others, nothing happens.
inline void stop_for_signals(double) {
  const py::gil_scoped_acquire locked;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

}  // namespace glark::python
