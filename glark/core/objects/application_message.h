// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Messages for an application that calls the extension, through its own debug output (OpenGL 4.6, 20).
#pragma once

#include <string>

#include "glark/gl/dispatch.h"

namespace glark::core {

// The `id` of a message in debug output. An application may filter by it.
enum class MessageId : GLuint {
  wrong_call = 1,    // a command of the extension generated an error
  passed_draw,       // draws stay as the application asked although GL_ARK is enabled
  other_refinement,  // draws do not get the refinement of GL_REFINEMENT_ARK
  ignored_shader,    // the refinement shader does not run
  not_displaced,     // GL_DISPLACEMENT_ARK has no effect
};

// The application has enabled GL_DEBUG_OUTPUT if `audible`; otherwise nothing is called. `hushed`: a Quiet has switched
// debug output off.
struct DebugOutput {
  const gl::Dispatch& gl;
  bool audible = false;
  bool hushed = false;
  void send(MessageId id, const std::string& text) const;
};

}  // namespace glark::core
