// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Programs that work in every API: sources are written without #version, in the GLSL that 4.30 core and ES 3.20 share.
#pragma once

#include <string>
#include <vector>

#include "conformance/suite/test.h"

namespace glark::conformance {

// The #version and precision lines of the context's API.
std::string glsl_head(const Test& t);

// Attribute locations that the programs of the suite use. None of them is the default of an attribute of the extension.
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

// Ends the case as an internal error where it does not build: the sources are the suite's own.
GLuint build_program(Test& t, const Sources& sources);
// As it is, #version and all; 0 where it does not build, with the log in `log`.
GLuint try_program(const Sources& sources, std::string& log);

// Ends the case where the program cannot be refined, with the log.
void require_refinable(Test& t, GLuint program);

// Gives the program a refinement shader, and expects it to build.
void set_refinement_shader(Test& t, GLuint program, const std::string& source);

// Inputs position (vec4), weights (vec3), colour (vec4); outputs colour. gl_Position is the position.
extern const char plain_vertex_shader[];

// Draws with the colour that each vertex has.
GLuint colour_program(Test& t);

}  // namespace glark::conformance
