// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The application's debug output must report its own calls only. It is switched off while we make calls.
#pragma once

#include "glark/gl/dispatch.h"

namespace glark::core {

class Quiet {
 public:
  Quiet() = default;
  // `audible`: the application has enabled GL_DEBUG_OUTPUT. If not, nothing is called.
  Quiet(const gl::Dispatch& gl, bool audible) : gl_(audible ? &gl : nullptr) { hush(); }
  ~Quiet() { interrupt(); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

  // Switches debug output on again for a call of the application.
  void interrupt() const {
    if (gl_ != nullptr) {
      gl_->Enable(GL_DEBUG_OUTPUT);
    }
  }
  void hush() const {
    if (gl_ != nullptr) {
      gl_->Disable(GL_DEBUG_OUTPUT);
    }
  }

 private:
  const gl::Dispatch* gl_ = nullptr;
};

}  // namespace glark::core
