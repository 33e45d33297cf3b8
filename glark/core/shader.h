// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Shaders and programs of ours. The caller wraps these in an ErrorScope.
#pragma once

#include <span>
#include <string>

#include "glark/gl/dispatch.h"

namespace glark::core {

struct ShaderText {
  GLenum stage = 0;
  std::string source;
};

// Of a program that only captures: without a fragment shader, draws to integer framebuffers would be errors.
std::string idle_fragment_shader(bool es);

// A shader object; what the compiler says of one that does not compile goes to the end of `error`.
GLuint compile_shader(const gl::Dispatch& gl, GLenum stage, const std::string& source, std::string& error);

// Links what the caller has made ready and takes the shaders apart from it again. False: the program is deleted, and what the
// linker says goes to the end of `error`.
bool link_program(const gl::Dispatch& gl, GLuint program, std::span<const GLuint> shaders, std::string& error);

// The same from texts, capturing `varyings`. 0 and a line in the log, which calls it `what`, if it cannot be built.
GLuint build_program(const gl::Dispatch& gl, const std::string& what, std::span<const ShaderText> texts,
                     std::span<const std::string> varyings = {});

}  // namespace glark::core
