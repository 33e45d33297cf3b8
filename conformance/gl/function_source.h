// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

namespace glark::conformance {

// Gives the functions of OpenGL by name, as eglGetProcAddress and its relatives do.
class FunctionSource {
 public:
  FunctionSource() = default;
  FunctionSource(const FunctionSource&) = delete;
  FunctionSource& operator=(const FunctionSource&) = delete;
  virtual ~FunctionSource() = default;

  virtual void* function(const char* name) = 0;
};

}  // namespace glark::conformance
