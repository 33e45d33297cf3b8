// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Programs whose vertex stage writes a value to transform feedback.
#pragma once

#include "conformance/support/capture.h"

namespace glark::conformance {

using RecordedVertex = std::array<float, 8>;  // gl_Position and a value

inline GLuint record_program(Test& t, const std::string& declarations, const std::string& value) {
  return build_program(t, {.vertex = "layout(location = 0) in vec4 position; out vec4 colour;\n" + declarations +
                                     "\nvoid main() { gl_Position = position; colour = " + value + "; }\n",
                           .captured = {"gl_Position", "colour"}});
}

inline void draw_one() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

}  // namespace glark::conformance
