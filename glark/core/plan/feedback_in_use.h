// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "glark/core/state/bindings.h"
#include "glark/core/state/programs/program.h"

namespace glark::core {

// The application's transform feedback while it captures refined triangles. glark pauses it between refined draws.
struct FeedbackInUse {
  std::shared_ptr<DerivedProgram> program;  // all captured draws use it; null: the application's feedback is left to GL
  GLenum mode = GL_NONE;
  GLuint owner = 0;  // the application's program that it was derived from; 0: fixed function
  bool has_captured = false;

  bool ours() const { return program != nullptr; }
  // The program is the one for tags that vary: all draws are planned that way.
  bool tagged() const { return ours() && program->layout.tagged; }
  bool captures(const Bindings& b) const { return ours() && !b.transform_feedback.paused; }
};

}  // namespace glark::core
