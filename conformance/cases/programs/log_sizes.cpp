// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The length that GetRefinementInfoLogARK returns (11.R.9), for buffers of every size from 0 on and for programs with
// and without a log. GetProgramInfoLog does the same with the log of a program.
#include <fmt/core.h>
#include <cstring>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/cases/programs/refinement_source.h"
#include "conformance/support/program.h"

namespace glark::conformance {
namespace {

constexpr char log_mark = '~';
constexpr GLsizei no_length = -7;

using LogQuery = void (*)(GLuint program, GLsizei size, GLsizei* length, GLchar* log);

void refinement_log(GLuint program, GLsizei size, GLsizei* length, GLchar* log) {
  gl.GetRefinementInfoLogARK(program, size, length, log);
}
void program_log(GLuint program, GLsizei size, GLsizei* length, GLchar* log) {
  gl.GetProgramInfoLog(program, size, length, log);
}

// `whole`: the bytes of the log without its terminator.
void expect_sizes(Test& t, GLuint program, LogQuery get, GLsizei whole, const std::string& what) {
  std::vector<GLchar> complete(static_cast<std::size_t>(whole) + 2, log_mark);
  get(program, whole + 1, nullptr, complete.data());
  for (const GLsizei size : {0, 1, 2, whole, whole + 1, whole + 2, whole + 1000}) {
    for (int again = 0; again < 2; ++again) {
      std::vector<GLchar> log(static_cast<std::size_t>(whole) + 1002, log_mark);
      GLsizei length = no_length;
      get(program, size, &length, log.data());
      const GLsizei expected = size == 0 ? 0 : std::min(size - 1, whole);
      const std::string of_size = fmt::format("{}, a bufSize of {}", what, size);
      t.expect_equal(length, expected, of_size + ": the length");
      const auto written = static_cast<std::size_t>(size == 0 ? 0 : expected + 1);
      if (size > 0)
        t.expect(log[written - 1] == '\0' && std::memcmp(log.data(), complete.data(), written - 1) == 0,
                 of_size + ": the log and its terminator");
      t.expect(log[written] == log_mark, of_size + ": nothing more is written");
    }
    std::vector<GLchar> log(static_cast<std::size_t>(whole) + 1002, log_mark);
    get(program, size, nullptr, log.data());
    t.expect(log[static_cast<std::size_t>(size == 0 ? 0 : std::min(size - 1, whole) + 1)] == log_mark,
             fmt::format("{}, a bufSize of {} without a length", what, size));
  }
  GLsizei length = no_length;
  get(program, 0, &length, nullptr);
  t.expect_equal(length, 0, what + ": the length without a buffer");
  t.expect_no_error(what);
}

struct LoggedProgram {
  const char* leaf;
  GLuint (*make)(Test&);
  bool has_log = false;
  Apis apis = every_api;
};

constexpr char with_fault[] = "void refine() { position.x += not_declared; }";

GLuint with_source(Test& t, const char* source, bool is_asked) {
  const GLuint program = colour_program(t);
  give(program, source);
  if (is_asked) property(program, GL_REFINEMENT_STATUS_ARK);
  return program;
}

constexpr LoggedProgram logged_programs[] = {
    {"fresh", [](Test&) { return gl.CreateProgram(); }},
    {"linked", colour_program},
    {"not_linked",
     [](Test&) {
       const GLuint program = gl.CreateProgram();
       give(program, with_fault);
       return program;
     }},
    {"not_built", [](Test& t) { return with_source(t, with_fault, false); }},
    {"built", [](Test& t) { return with_source(t, "void refine() { position.x += 0.0; }", true); }},
    {"faulty", [](Test& t) { return with_source(t, with_fault, true); }, true},
    {"mended",
     [](Test& t) {
       const GLuint program = with_source(t, with_fault, true);
       give(program, "void refine() { position.x += 0.0; }");
       property(program, GL_REFINEMENT_STATUS_ARK);
       return program;
     }},
    {"fixed_function", [](Test&) { return GLuint{0}; }, false, compat_only},
    {"fixed_function_faulty",
     [](Test&) {
       give(0, "void refine() { gl_Vertex.x += not_declared; }");
       property(0, GL_REFINEMENT_STATUS_ARK);
       return GLuint{0};
     },
     true, compat_only},
};

void check_sizes(Test& t, const LoggedProgram& logged) {
  gl.ARKinit(1);
  const GLuint program = logged.make(t);
  const GLint with_terminator = property(program, GL_REFINEMENT_LOG_LENGTH_ARK);
  if (logged.has_log) t.expect(with_terminator > 12, "the log names the fault");
  t.expect(with_terminator != 1, "an empty log has the length 0");
  expect_sizes(t, program, refinement_log, with_terminator == 0 ? 0 : with_terminator - 1, logged.leaf);
  t.expect_equal(property(program, GL_REFINEMENT_LOG_LENGTH_ARK), with_terminator, "the length afterwards");
}

// GetProgramInfoLog of the same GL, for a program that does not link.
void control_sizes(Test& t) {
  const GLuint program = gl.CreateProgram();
  const std::string text = glsl_head(t) + "void main() { gl_Position = absent(); }\nvec4 absent();\n";
  const char* const source = text.c_str();
  const GLuint shader = gl.CreateShader(GL_VERTEX_SHADER);
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  gl.AttachShader(program, shader);
  gl.LinkProgram(program);
  GLint length = 0;
  gl.GetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  expect_sizes(t, program, program_log, length == 0 ? 0 : length - 1, "GetProgramInfoLog");
}

// Wrong calls write neither the length nor the log.
void check_refused_sizes(Test& t) {
  gl.ARKinit(1);
  const GLuint program = with_source(t, with_fault, true);
  const GLuint shader = gl.CreateShader(GL_VERTEX_SHADER);
  struct Refused {
    GLuint program;
    GLsizei size;
    GLenum error;
  };
  for (const Refused& refused : {Refused{program, -1, GL_INVALID_VALUE},
                                 {program, -1000, GL_INVALID_VALUE},
                                 {7654321, 0, GL_INVALID_VALUE},
                                 {7654321, 8, GL_INVALID_VALUE},
                                 {shader, 0, GL_INVALID_OPERATION},
                                 {shader, 8, GL_INVALID_OPERATION}}) {
    GLsizei length = no_length;
    GLchar log[8] = "~~~~~~~";
    gl.GetRefinementInfoLogARK(refused.program, refused.size, &length, log);
    t.expect_error(refused.error, fmt::format("program {}, a bufSize of {}", refused.program, refused.size));
    t.expect(length == no_length && std::strcmp(log, "~~~~~~~") == 0, "nothing is written");
  }
}

}  // namespace

Cases log_sizes_cases() {
  Cases cases;
  for (const LoggedProgram& logged : logged_programs)
    cases.push_back({.name = std::string("ark.shader.log.sizes.") + logged.leaf,
                     .clauses = {"11.R.9-33", "11.R.9-34", "11.R.9-30"},
                     .plan = "Get the log into buffers of 0, 1, 2, just enough and too many bytes.",
                     .wrong = "With a bufSize of 0, or without a log, the length is left alone; it counts the "
                              "terminator, or what did not fit.",
                     .apis = logged.apis,
                     .control = control_sizes,
                     .check = [&logged](Test& t) { check_sizes(t, logged); }});
  cases.push_back({.name = "ark.shader.log.sizes.refused",
                   .clauses = {"11.R.9-35", "11.R.9-36", "errors-2"},
                   .plan = "Negative sizes, and names that are no program's, with and without a buffer.",
                   .wrong = "The length is set to 0 although there is an error.",
                   .check = check_refused_sizes});
  return cases;
}

}  // namespace glark::conformance
