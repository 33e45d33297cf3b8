// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A coloured strip, drawn by programs of the test's own. Attributes 0 (position) and 1 (colour) come from a buffer.
#pragma once

#include <string>

#include "tests/core/support/modes.h"
#include "tests/core/support/osmesa_context.h"
#include "tests/core/support/programs.h"

namespace glark::core::test {

inline const char* const pass_color =
    "#version 430\nin vec3 c; out vec4 result;\nvoid main() { result = vec4(c, 1.0); }\n";
inline const std::string inputs =
    "#version 430\nlayout(location = 0) in vec2 position; layout(location = 1) in vec3 color;\n";

class ProgramScene : public testing::TestWithParam<Profile> {
 protected:
  ProgramScene() {
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    make_buffer(GL_ARRAY_BUFFER, mode_shapes()[1].vertices);
    point_generic_arrays(nullptr);
  }
  // `declarations` stand before main. `body` follows the statements that give gl_Position and c their plain values.
  GLuint use(const std::string& declarations, const std::string& body, const std::string& fragment = pass_color) {
    const GLuint program =
        link_program({.vertex = inputs + declarations +
                                "void main() { gl_Position = vec4(position, 0.0, 1.0); c = color;\n" + body + "}\n",
                      .fragment = fragment});
    glUseProgram(program);
    return program;
  }
  static void draw() { glDrawArrays(GL_TRIANGLE_STRIP, 0, 6); }
  OsmesaContext context_{GetParam()};
};

}  // namespace glark::core::test
