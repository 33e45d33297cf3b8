// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Uniform commands with locations that no uniform has: GL's errors stay, whatever locations an implementation gives to
// uniforms of refinement shaders.
#include <fmt/core.h>

#include <string>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/uniform_commands.h"

namespace glark::conformance {
namespace {

// Locations around every power of two.
std::vector<GLint> unknown_locations() {
  std::vector<GLint> all;
  for (unsigned bit = 8; bit < 31; ++bit)
    for (const int beside : {-1, 0, 1, 5}) all.push_back(static_cast<GLint>(1U << bit) + beside);
  all.push_back(0x7FFFFFFF);
  return all;
}

bool names_program(const UniformCommand& command) { return std::string(command.name).rfind("Program", 0) == 0; }

void expect_location_refused(Test& t, GLuint program, GLint location, const std::string& what,
                             GLenum error = GL_INVALID_OPERATION) {
  const UniformNumbers numbers{};
  for (const UniformCommand& command : uniform_commands()) {
    if (is_double_type(command.type) && t.is_gles()) continue;
    command.set(program, location, 1, numbers.data());
    t.expect_error(error,
                   fmt::format("{} of location 0x{:x}, {}", command.name, static_cast<unsigned>(location), what));
  }
}

void draw_located() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

void check_unknown_locations(Test& t, bool has_shader) {
  const GLuint program = colour_program(t);
  gl.UseProgram(program);
  upload(one_triangle());
  refine_uniformly(2);
  draw_located();
  GLint known = -1;
  if (has_shader) {
    set_refinement_shader(t, program, "uniform float scale;\nvoid refine() { position.xy *= scale; }\n");
    known = gl.GetUniformLocation(program, "scale");
    t.expect(known >= 0, "the uniform has a location");
    gl.Uniform1f(known, 0.5F);
    draw_located();
  }
  for (const GLint location : unknown_locations())
    if (location != known) expect_location_refused(t, program, location, "of a refined program");
  const Picture before = conformance::picture_of(draw_located);
  if (has_shader) {  // another program does not have it
    const GLuint other = colour_program(t);
    expect_location_refused(t, other, known + 1, "of another program");
    gl.UseProgram(other);
    draw_located();
    gl.Uniform1f(known, 0.25F);
    t.expect_error(GL_INVALID_OPERATION, "a uniform of another program");
    gl.ProgramUniform1f(other, known, 0.25F);
    t.expect_error(GL_INVALID_OPERATION, "a uniform of another program, by its name");
    gl.ProgramUniform1f(program, known, 0.5F);
    t.expect_no_error("the uniform of a program that is not in use");
    gl.UseProgram(program);
  }
  t.expect_same_picture(conformance::picture_of(draw_located), before, "afterwards");
  gl.UseProgram(0);
  const UniformNumbers numbers{};
  for (const UniformCommand& command : uniform_commands()) {
    if (is_double_type(command.type) && t.is_gles()) continue;
    for (const GLint location : {0, 0x40000000, 0x40000001}) {
      command.set(0, location, 1, numbers.data());
      t.expect_error(names_program(command) ? GL_INVALID_VALUE : GL_INVALID_OPERATION,
                     fmt::format("{} without a program", command.name));
    }
  }
  gl.UseProgram(program);
  gl.Uniform1f(-1, 1);
  t.expect_no_error("location -1 is ignored");
}

// The same, with locations that hold for the uniforms of the refinement shader before it was replaced.
void check_locations_replaced(Test& t) {
  const GLuint program = colour_program(t);
  gl.UseProgram(program);
  upload(one_triangle());
  refine_uniformly(2);
  set_refinement_shader(t, program,
                        "uniform float scale; uniform float shift;\n"
                        "void refine() { position.xy = position.xy * scale + shift; }\n");
  const GLint scale = gl.GetUniformLocation(program, "scale");
  const GLint shift = gl.GetUniformLocation(program, "shift");
  t.expect(scale >= 0 && shift >= 0 && scale != shift, "two locations");
  gl.Uniform1f(scale, 0.5F);
  gl.Uniform1f(shift, 0.1F);
  t.expect_no_error("both are set");
  set_refinement_shader(t, program, "void refine() { position.xy *= 0.5; }\n");
  draw_located();
  for (const GLint location : {scale, shift}) {
    gl.Uniform1f(location, 1);
    const GLenum error = gl.GetError();
    t.expect(error == GL_NO_ERROR || error == GL_INVALID_OPERATION, "a location that is no longer valid does no harm");
  }
}

}  // namespace

Cases unknown_locations_cases() {
  const auto look = [](const char* leaf, const char* plan, std::function<void(Test&)> check) {
    return Case{
        .name = std::string("ark.programs.locations.") + leaf,
        .clauses = {"11.R.9-21", "11.R.9-22", "11.R.10-2"},
        .plan = plan,
        .wrong = "A command is taken for one that sets a uniform of the refinement shader, and raises no error.",
        .check = std::move(check)};
  };
  return {look("unknown", "Every uniform command with locations that no uniform has, with and without a program.",
               [](Test& t) { check_unknown_locations(t, false); }),
          look("unknown_with_shader", "The same, for a program with a refinement shader that has a uniform.",
               [](Test& t) { check_unknown_locations(t, true); }),
          look("replaced", "Locations of a refinement shader that was replaced.", check_locations_replaced)};
}

}  // namespace glark::conformance
