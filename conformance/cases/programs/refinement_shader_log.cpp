// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The log of refinement shaders (11.R.9).
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

// After a failed build and a repaired one, the log is that of the last build.
void check_last_log(Test& t) {
  const GLuint program = colour_program(t);
  const auto build = [program](const char* source) {
    give(program, source);
    return property(program, GL_REFINEMENT_STATUS_ARK);
  };
  const auto log_of = [program] {
    const GLint length = property(program, GL_REFINEMENT_LOG_LENGTH_ARK);
    std::string log(static_cast<std::size_t>(length) + 1, '\0');
    gl.GetRefinementInfoLogARK(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
    log.resize(std::strlen(log.c_str()));
    return log;
  };
  gl.ARKinit(2);
  t.expect_equal(build("void refine() { colour_of_nothing = 1.0; }"), GLint{GL_FALSE}, "the status of a faulty shader");
  const std::string first = log_of();
  t.expect(first.find("colour_of_nothing") != std::string::npos, "the log names what is wrong");
  t.expect_equal(build("void refine() { position.x += 0.0; }"), GLint{GL_TRUE}, "the status of the repaired shader");
  t.expect(log_of().find("colour_of_nothing") == std::string::npos, "the log of the failure is gone");
  t.expect_equal(build("void refine() { other_mistake = 1.0; }"), GLint{GL_FALSE}, "the status of another fault");
  t.expect(log_of().find("other_mistake") != std::string::npos, "the log is that of the last attempt");
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
  };
}

}  // namespace glark::conformance
