// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The log of refinement shaders (11.R.9).
#include <cctype>
#include <cstring>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/cases/programs/refinement_source.h"
#include "conformance/support/program.h"

namespace glark::conformance {
namespace {

void check_log(Test& t) {
  const GLuint program = colour_program(t);
  gl.ARKinit(1);
  give(program, "void refine() { position.x += not_declared; }");
  property(program, GL_REFINEMENT_STATUS_ARK);
  const GLint with_null = property(program, GL_REFINEMENT_LOG_LENGTH_ARK);
  t.require(with_null > 8, "a log of some length");
  std::vector<char> whole(static_cast<std::size_t>(with_null) + 8, '~');
  GLsizei length = -7;
  gl.GetRefinementInfoLogARK(program, with_null, &length, whole.data());
  t.expect_equal(length, with_null - 1, "the length without the null terminator");
  t.expect_equal(std::strlen(whole.data()), std::size_t(with_null) - 1, "where the terminator is");
  t.expect_equal(int{whole[std::size_t(with_null)]}, int{'~'}, "nothing after it is written");
  for (const GLsizei size : {1, 2, 5, with_null - 1}) {
    std::vector<char> part(static_cast<std::size_t>(with_null) + 8, '~');
    gl.GetRefinementInfoLogARK(program, size, &length, part.data());
    t.expect_equal(length, size - 1, "the length with a bufSize of " + as_text(size));
    t.expect_equal(std::string(part.data()), std::string(whole.data(), std::size_t(size) - 1), "the beginning");
    t.expect_equal(int{part[std::size_t(size)]}, int{'~'}, "nothing behind bufSize is written");
  }
  char none = '~';
  gl.GetRefinementInfoLogARK(program, 0, &length, &none);
  t.expect_equal(int{none}, int{'~'}, "nothing is written with a bufSize of 0");
  gl.GetRefinementInfoLogARK(program, with_null, nullptr, whole.data());
  t.expect_equal(std::strlen(whole.data()), std::size_t(with_null) - 1, "with a length of NULL");
  t.expect_no_error("the queries");
}

std::string log_of(GLuint program) {
  const GLint length = property(program, GL_REFINEMENT_LOG_LENGTH_ARK);
  std::string log(static_cast<std::size_t>(length) + 1, '\0');
  gl.GetRefinementInfoLogARK(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
  log.resize(std::strlen(log.c_str()));
  return log;
}

// After a failed build and a repaired one, the log is that of the last build.
void check_last_log(Test& t) {
  const GLuint program = colour_program(t);
  const auto build = [program](const char* source) {
    give(program, source);
    return property(program, GL_REFINEMENT_STATUS_ARK);
  };
  gl.ARKinit(2);
  t.expect_equal(build("void refine() { colour_of_nothing = 1.0; }"), GLint{GL_FALSE}, "the status of a faulty shader");
  const std::string first = log_of(program);
  t.expect(first.find("colour_of_nothing") != std::string::npos, "the log names what is wrong");
  t.expect_equal(build("void refine() { position.x += 0.0; }"), GLint{GL_TRUE}, "the status of the repaired shader");
  t.expect(log_of(program).find("colour_of_nothing") == std::string::npos, "the log of the failure is gone");
  t.expect_equal(build("void refine() { other_mistake = 1.0; }"), GLint{GL_FALSE}, "the status of another fault");
  t.expect(log_of(program).find("other_mistake") != std::string::npos, "the log is that of the last attempt");
}

// The log of a refinement shader with an error. Expects that it names line `line`, and no other one.
std::string expect_fault(Test& t, const char* source, int line, const std::string& what) {
  const GLuint program = colour_program(t);
  give(program, source);
  t.expect_equal(property(program, GL_REFINEMENT_STATUS_ARK), GLint{GL_FALSE}, what + ": the status");
  std::string log = log_of(program);
  const std::string head = "refinement shader:";
  const std::size_t found = log.find(head + as_text(line));
  t.expect(found != std::string::npos, what + ": line " + as_text(line) + " in the log: " + log);
  t.expect_no_error(what);
  return log;
}

void check_lines(Test& t) {
  gl.ARKinit(1);
  for (const int line : {1, 2, 17}) {
    std::string source(static_cast<std::size_t>(line) - 1, '\n');
    source += "void refine() { position.x += not_declared; }\n";
    const std::string log = expect_fault(t, source.c_str(), line, "a name that is not declared");
    t.expect(log.find("not_declared") != std::string::npos, "the log has the name: " + log);
  }
}

// Every word of the log that contains `name` is that name.
void expect_own_name(Test& t, const std::string& log, const std::string& name) {
  const auto is_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (std::size_t at = log.find(name); at != std::string::npos; at = log.find(name, at + 1)) {
    const bool whole = (at == 0 || !is_name(log[at - 1])) && !is_name(log[at + name.size()]);
    t.expect(whole || log.compare(at, name.size() + 4, name + "ment") == 0, "no other name for " + name + ": " + log);
  }
}

void check_names(Test& t) {
  gl.ARKinit(1);
  const std::string log = expect_fault(t, "void refine() {\n  position = refine(position);\n}\n", 2, "wrong arguments");
  expect_own_name(t, log, "refine");
}

void check_faults(Test& t) {
  gl.ARKinit(1);
  std::string versioned = "\n" + glsl_head(t);
  versioned.resize(versioned.find('\n', 1) + 1);
  expect_fault(t, (versioned + "void refine() { position.x += 0.1; }\n").c_str(), 2, "a #version directive");
  expect_fault(t, "void refined() { }", 1, "no refine()");
  expect_fault(t, "void refine() {\n position += ark_corner_absent[0]; }", 2, "an input that is not active");
  expect_fault(t, "uniform vec4 pale;\nuniform vec4 colour_of_all, colour;\nvoid refine() { position.x += colour.x; }",
               2, "a uniform with the name of an output");
}

constexpr Area shader_case{"ark.shader."};

}  // namespace

Cases refinement_shader_log_cases() {
  return {
      shader_case(
          "log", {"11.R.9-30", "11.R.9-33", "11.R.9-34", "functions-9", "functions-10", "11.R.9-26"},
          "Get the log into buffers that are just long enough, too short, and empty.",
          "One byte too many in the buffer; a length that counts the terminator; nothing if the length is NULL.",
          check_log),
      shader_case("log.last", {"11.R.9-30", "11.R.9-34"}, "Build a faulty shader, a good one, a faulty one.",
                  "The log of an earlier build.", check_last_log),
      shader_case("log.lines", {"11.R.9-41", "11.R.9-42"}, "Put an error into line 1, 2 and 17 of a refinement shader.",
                  "Lines of the program that the implementation makes of the shader.", check_lines),
      shader_case("log.names", {"11.R.9-43"}, "Call refine with wrong arguments.",
                  "Names that the implementation gave to the function and to the inputs.", check_names),
      shader_case("faults", {"11.R.9-40", "11.R.9-11", "11.R.9-12", "11.R.9-17", "11.R.9-41"},
                  "A shader with #version, one without refine, one with an input that is not active, and one with a "
                  "uniform that has the name of an output.",
                  "They build; or the log names no line of the shader.", check_faults),
  };
}

}  // namespace glark::conformance
