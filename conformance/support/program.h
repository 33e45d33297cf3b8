// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Programs for every API. Sources have no #version and use the GLSL that 4.30 core and ES 3.20 share.
#pragma once

#include <string>
#include <vector>

#include "conformance/suite/test.h"

namespace glark::conformance {

// The #version and precision lines of the context's API.
std::string glsl_head(const Test& t);

// Attribute locations of the suite's programs. No attribute of the extension has one of them by default.
enum Location : GLuint {
  at_position = 0,
  at_normal = 1,
  at_weights = 2,
  at_colour = 3,
  at_texture = 4,
  at_tag = 5,
  at_extra = 6
};

struct Sources {
  std::string vertex;
  std::string fragment = "in vec4 colour; out vec4 pixel; void main() { pixel = colour; }";
  std::string geometry = {};
  std::vector<const char*> captured = {};  // varyings, interleaved
};

// Ends the case as an internal error if the program does not build, since the sources are the suite's own.
GLuint build_program(Test& t, const Sources& sources);
// Builds the sources as they are, with their #version. Returns 0 if they do not build, and writes the log to `log`.
GLuint try_program(const Sources& sources, std::string& log);

// A program pipeline of two separable programs, bound. The sources have no #version, and declare no gl_PerVertex.
struct Pipeline {
  GLuint name = 0;
  GLuint vertex_program = 0;
  GLuint fragment_program = 0;
};
Pipeline bind_pipeline(Test& t, const std::string& vertex, const std::string& fragment);
// One of these programs, for another stage of the pipeline. stage: GL_VERTEX_SHADER or GL_FRAGMENT_SHADER.
GLuint separable_program(const Test& t, GLenum stage, const std::string& source);

// Fails and ends the case if the program cannot be refined, and shows the log.
void require_refinable(Test& t, GLuint program);

// Gives the program a refinement shader, and expects it to build.
void set_refinement_shader(Test& t, GLuint program, const std::string& source);

// Inputs: position (vec4), weights (vec3), colour (vec4). Output: colour. gl_Position is the position.
extern const char plain_vertex_shader[];

// A program that draws each vertex in its own colour.
GLuint colour_program(Test& t);

}  // namespace glark::conformance
