// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Keeps the GL errors of our own calls away from those of the application.
#pragma once

#include "glark/gl/dispatch.h"

namespace glark::core {

// The error that the application will get from glGetError before any that the driver has.
class PendingError {
 public:
  explicit PendingError(const gl::Dispatch& gl) : gl_(gl) {}
  // The first error stays, as in GL.
  void raise(GLenum error) { error_ = error_ == GL_NO_ERROR ? error : error_; }
  GLenum take();  // returns the error and clears it

 private:
  friend class ErrorScope;
  const gl::Dispatch& gl_;
  GLenum error_ = GL_NO_ERROR;
};

// At construction, moves the driver's pending error to `pending`. At destruction, drops the errors that our calls
// caused. For rare operations only (allocation, linking).
class ErrorScope {
 public:
  explicit ErrorScope(PendingError& pending);
  ~ErrorScope();
  ErrorScope(const ErrorScope&) = delete;
  ErrorScope& operator=(const ErrorScope&) = delete;
  GLenum take();  // the first error that our calls caused so far

 private:
  const gl::Dispatch& gl_;
};

}  // namespace glark::core
