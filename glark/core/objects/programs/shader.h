// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark's own shaders and programs. The caller wraps these functions in an ErrorScope.
#pragma once

#include <span>
#include <string>

#include "glark/gl/dispatch.h"

namespace glark::core {

struct ShaderText {
  GLenum stage = 0;
  std::string source;
};

// The fragment shader of a program that only captures. Without one, draws to integer framebuffers would be errors.
std::string idle_fragment_shader(bool es);

// Makes a shader object. Appends the compiler's log to `error` if the shader does not compile.
GLuint compile_shader(const gl::Dispatch& gl, GLenum stage, const std::string& source, std::string& error);

// Links the program and deletes the shaders. If linking fails, deletes the program too, appends the program's log to
// `error` and returns false.
bool link_program(const gl::Dispatch& gl, GLuint program, std::span<const GLuint> shaders, std::string& error);

// Compiles and links; the program captures `varyings`. Returns 0 and logs an error that begins with `what` if it cannot
// be built.
GLuint build_program(const gl::Dispatch& gl, const std::string& what, std::span<const ShaderText> texts,
                     std::span<const std::string> varyings = {});

}  // namespace glark::core
