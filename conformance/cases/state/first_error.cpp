// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Two errors in a row (GL 4.6, 2.3.1): the first one stays until GetError returns it. Commands of the extension and of
// GL are mixed. An implementation with several error flags may return both.
#include <set>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

struct Faulty {
  const char* what;
  GLenum error;
  void (*call)();
};

constexpr GLuint no_object = 987654;

// Each command of the extension with each of its errors, and commands of GL with all of its common errors.
constexpr Faulty faulty[] = {
    {"ARKParameteriARK of no name", GL_INVALID_ENUM, [] { gl.ARKParameteriARK(0x1234, 1); }},
    {"ARKParameteriARK of a value", GL_INVALID_VALUE, [] { gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, -1); }},
    {"ARKParameteriARK of a token", GL_INVALID_ENUM, [] { gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_TRIANGLES); }},
    {"ARKParameterfARK of no name", GL_INVALID_ENUM, [] { gl.ARKParameterfARK(GL_REFINEMENT_ARK, 1); }},
    {"ARKParameterfARK of a value", GL_INVALID_VALUE, [] { gl.ARKParameterfARK(GL_SCREEN_ERROR_ARK, -1); }},
    {"ARKinit", GL_INVALID_VALUE, [] { gl.ARKinit(100); }},
    {"DepthTag1i", GL_INVALID_VALUE, [] { gl.DepthTag1i(77); }},
    {"DepthTagPointerARK of a type", GL_INVALID_ENUM, [] { gl.DepthTagPointerARK(GL_DOUBLE, 0, nullptr); }},
    {"DepthTagPointerARK of a stride", GL_INVALID_VALUE, [] { gl.DepthTagPointerARK(GL_FLOAT, -4, nullptr); }},
    {"DrawARP of a mode", GL_INVALID_ENUM, [] { gl.DrawARP(GL_LINES, 0, 3); }},
    {"DrawARP of a count", GL_INVALID_VALUE, [] { gl.DrawARP(GL_TRIANGLES, 0, -3); }},
    {"DrawARPElementsARK of a mode", GL_INVALID_ENUM,
     [] { gl.DrawARPElementsARK(GL_POINTS, 3, GL_UNSIGNED_SHORT, nullptr); }},
    {"DrawARPElementsARK of a type", GL_INVALID_ENUM,
     [] { gl.DrawARPElementsARK(GL_TRIANGLES, 3, GL_FLOAT, nullptr); }},
    {"DrawARPElementsARK of a count", GL_INVALID_VALUE,
     [] { gl.DrawARPElementsARK(GL_TRIANGLES, -3, GL_UNSIGNED_SHORT, nullptr); }},
    {"RefinementShaderSourceARK of a count", GL_INVALID_VALUE,
     [] { gl.RefinementShaderSourceARK(0, -1, nullptr, nullptr); }},
    {"RefinementShaderSourceARK of no program", GL_INVALID_VALUE,
     [] { gl.RefinementShaderSourceARK(no_object, 0, nullptr, nullptr); }},
    {"RefinementShaderSourceARK of a shader", GL_INVALID_OPERATION,
     [] {
       const GLuint shader = gl.CreateShader(GL_VERTEX_SHADER);
       gl.RefinementShaderSourceARK(shader, 0, nullptr, nullptr);
       gl.DeleteShader(shader);
     }},
    {"GetRefinementivARK of no program", GL_INVALID_VALUE,
     [] {
       GLint value = 0;
       gl.GetRefinementivARK(no_object, GL_REFINEMENT_STATUS_ARK, &value);
     }},
    {"GetRefinementInfoLogARK of a size", GL_INVALID_VALUE,
     [] {
       GLchar text[4] = {};
       GLint current = 0;
       gl.GetIntegerv(GL_CURRENT_PROGRAM, &current);
       gl.GetRefinementInfoLogARK(static_cast<GLuint>(current), -1, nullptr, text);
     }},
    {"Enablei", GL_INVALID_ENUM, [] { gl.Enablei(GL_ARK, 0); }},
    {"Enable", GL_INVALID_ENUM, [] { gl.Enable(0x1234); }},
    {"LineWidth", GL_INVALID_VALUE, [] { gl.LineWidth(-1); }},
    {"EndQuery", GL_INVALID_OPERATION, [] { gl.EndQuery(GL_ANY_SAMPLES_PASSED); }},
    {"DrawArrays of a mode", GL_INVALID_ENUM, [] { gl.DrawArrays(0x1234, 0, 3); }},
    {"DrawArrays of a count", GL_INVALID_VALUE, [] { gl.DrawArrays(GL_TRIANGLES, 0, -3); }},
    {"UseProgram", GL_INVALID_VALUE, [] { gl.UseProgram(no_object); }},
};

// At most as many flags as there are calls.
std::set<GLenum> errors_found(Test& t) {
  std::set<GLenum> found;
  for (int i = 0; i < 4; ++i) {
    const GLenum error = gl.GetError();
    if (error == GL_NO_ERROR) return found;
    found.insert(error);
  }
  t.fail("GetError returns an error again and again");
  return found;
}

void set_up_errors(Test& t, bool is_enabled) {
  gl.UseProgram(colour_program(t));
  upload(one_triangle());
  refine_uniformly(2);
  if (!is_enabled) gl.Disable(GL_ARK);
}

void check_each_error(Test& t) {
  set_up_errors(t, true);
  for (const Faulty& each : faulty) {
    each.call();
    t.expect_equal(gl.GetError(), each.error, each.what);
    t.expect_no_error(each.what);
  }
}

void check_error_pairs(Test& t) {
  check_each_error(t);
  for (const bool is_enabled : {true, false}) {
    set_up_errors(t, is_enabled);
    for (const Faulty& first : faulty)
      for (const Faulty& second : faulty) {
        first.call();
        second.call();
        const std::set<GLenum> found = errors_found(t);
        const std::string what = std::string(first.what) + ", then " + second.what;
        t.expect(found.contains(first.error), what + ": the first error is reported");
        for (const GLenum error : found)
          t.expect(error == first.error || error == second.error, what + ": no other error than theirs");
      }
  }
}

// A draw, and commands without an error, leave a pending error as it is.
void check_kept_error(Test& t) {
  set_up_errors(t, true);
  for (const Faulty& each : faulty) {
    each.call();
    for (int again = 0; again < 2; ++again) gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 1);
    gl.DepthTag1i(1);
    gl.Disable(GL_ARK);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.Enable(GL_ARK);
    t.expect_equal(gl.GetError(), each.error, std::string(each.what) + ", then draws");
    t.expect_no_error(each.what);
  }
}

}  // namespace

Cases first_error_cases() {
  return {{.name = "ark.error.first.pairs",
           .clauses = {"errors-2", "10.R.2-13"},
           .plan = "Cause two errors, of any two commands of the extension and of GL, and then call GetError.",
           .wrong = "The second error replaces the first.",
           .check = check_error_pairs},
          {.name = "ark.error.first.draws",
           .clauses = {"errors-2", "10.R.2-13"},
           .plan = "Cause an error, draw, change the state, and then call GetError.",
           .wrong = "A refined draw takes the error, or a command without an error clears it.",
           .check = check_kept_error}};
}

}  // namespace glark::conformance
