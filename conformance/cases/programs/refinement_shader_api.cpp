// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Refinement shaders: their commands, errors, status and log (11.R.9).
#include <algorithm>
#include <cstring>
#include <limits>

#include "conformance/cases/cases.h"
#include "conformance/cases/programs/refinement_source.h"
#include "conformance/support/capture.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

constexpr char good[] = "void refine() { position.x += 1.0; }";
constexpr char broken[] = "void refine() { position.x += not_declared; }";

GLuint make_shader() { return gl.CreateShader(GL_VERTEX_SHADER); }

// The number of captured triangles, and how far they moved to the right.
struct Drawn {
  std::size_t triangles = 0;
  float shift = 0;
};

Drawn draw(Test& t) {
  const auto vertices = capture(t, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
  float least = std::numeric_limits<float>::max();
  for (const CapturedVertex& vertex : vertices) least = std::min(least, vertex.position[0]);
  return {vertices.size() / 3, least + 0.75F};
}

GLuint set_up_draw(Test& t) {
  const GLuint program = capture_program(t);
  gl.UseProgram(program);
  upload(one_triangle(), false);
  refine_uniformly(1);
  return program;
}

void expect_draw(Test& t, std::size_t triangles, float shift, const std::string& what) {
  const Drawn drawn = draw(t);
  t.expect_equal(drawn.triangles, triangles, what + ": triangles");
  t.expect_near(double{drawn.shift}, double{shift}, 1e-6, what + ": shift");
}

void control(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(one_triangle(), false);
  const Drawn drawn = draw(t);
  t.expect(drawn.triangles == 1 && drawn.shift == 0, "one triangle in its place");
}

struct BadProgram {
  const char* leaf;
  GLenum error;
  std::vector<std::string> clauses;
  std::function<GLuint(Test&)> name;
  bool is_compat = true;
};

const std::vector<BadProgram>& bad_programs() {
  static const std::vector<BadProgram> all{
      {"unknown", GL_INVALID_VALUE, {"11.R.9-8", "errors-20", "11.R.9-36"}, [](Test&) { return 0x7654321U; }},
      {"great", GL_INVALID_VALUE, {"11.R.9-8", "errors-20", "11.R.9-36"}, [](Test&) { return 0xFFFFFFFFU; }},
      {"deleted",
       GL_INVALID_VALUE,
       {"11.R.9-8", "errors-20", "11.R.9-36"},
       [](Test&) {
         const GLuint program = gl.CreateProgram();
         gl.DeleteProgram(program);
         return program;
       }},
      {"shader", GL_INVALID_OPERATION, {"11.R.9-9", "errors-21", "11.R.9-36"}, [](Test&) { return make_shader(); }},
      {"zero", GL_INVALID_VALUE, {"11.R.9-8", "errors-20", "core-1", "11.R.9-36"}, [](Test&) { return 0U; }, false},
  };
  return all;
}

void check_bad_program(Test& t, const BadProgram& bad) {
  const GLuint used = set_up_draw(t);
  give(used, good);
  const GLuint program = bad.name(t);
  const char* const source = good;
  expect_refused(
      t, bad.error, "RefinementShaderSourceARK", [&] { gl.RefinementShaderSourceARK(program, 1, &source, nullptr); },
      used);
  expect_refused(
      t, bad.error, "RefinementShaderSourceARK with a count of 0",
      [&] { gl.RefinementShaderSourceARK(program, 0, nullptr, nullptr); }, used);
  for (const GLenum name : {GL_REFINEMENT_STATUS_ARK, GL_REFINEMENT_LOG_LENGTH_ARK, GL_REFINEMENT_SOURCE_LENGTH_ARK})
    expect_refused(
        t, bad.error, "GetRefinementivARK",
        [&] { t.expect_equal(property(program, name), -7, "GetRefinementivARK left the value alone"); }, used);
  GLsizei length = -7;
  char log[8] = "abc";
  expect_refused(
      t, bad.error, "GetRefinementInfoLogARK", [&] { gl.GetRefinementInfoLogARK(program, sizeof(log), &length, log); },
      used);
  t.expect(length == -7 && std::strcmp(log, "abc") == 0, "GetRefinementInfoLogARK left both alone");
}

void check_counts_and_names(Test& t) {
  const GLuint program = set_up_draw(t);
  give(program, broken);
  property(program, GL_REFINEMENT_STATUS_ARK);
  const char* const source = good;
  for (const GLsizei count : {-1, std::numeric_limits<GLsizei>::min()})
    expect_refused(
        t, GL_INVALID_VALUE, "count " + as_text(count),
        [&] { gl.RefinementShaderSourceARK(program, count, &source, nullptr); }, program);
  for (const int name : {0, GL_LINK_STATUS, GL_INFO_LOG_LENGTH, GL_REFINEMENT_ARK, 0x6F1F, 0x6F27})
    expect_refused(
        t, GL_INVALID_ENUM, "GetRefinementivARK of " + as_text(name),
        [&] { t.expect_equal(property(program, static_cast<GLenum>(name)), -7, "the query left the value alone"); },
        program);
  GLsizei length = -7;
  char log[8] = "abc";
  for (const GLsizei size : {-1, std::numeric_limits<GLsizei>::min()})
    expect_refused(
        t, GL_INVALID_VALUE, "bufSize " + as_text(size),
        [&] { gl.GetRefinementInfoLogARK(program, size, &length, log); }, program);
  t.expect(length == -7 && std::strcmp(log, "abc") == 0, "GetRefinementInfoLogARK left both alone");
}

void check_strings(Test& t) {
  const GLuint program = set_up_draw(t);
  const auto expect_source = [&](GLint length, const char* what) {
    t.expect_equal(source_length(program), length, what);
    t.expect_equal(property(program, GL_REFINEMENT_STATUS_ARK), GLint{GL_TRUE}, what);
    expect_draw(t, 4, 1, what);
    give(program, broken);
  };
  const char* const parts[] = {"void ref", "ine() { position", "", ".x += 1.0; }"};
  gl.RefinementShaderSourceARK(program, 4, parts, nullptr);
  expect_source(length_of(good), "null-terminated strings");
  const char* const longer[] = {"void refine() { garbage", "position.x += 1.0; garbage", "} garbage"};
  const GLint lengths[] = {16, 19, 1};
  gl.RefinementShaderSourceARK(program, 3, longer, lengths);
  expect_source(37, "strings with lengths");
  const char* const mixed[] = {"void refine() { ", "garbage", "position.x += 1.0; garbage", "}"};
  const GLint some[] = {-1, 0, 19, -100};
  gl.RefinementShaderSourceARK(program, 4, mixed, some);
  expect_source(37, "a negative length for a null-terminated string");
  std::string own = good;
  give(program, own.c_str());
  own.assign(own.size(), '#');
  expect_source(length_of(good), "the string is copied");
  t.expect_no_error("the commands");
}

void check_removed(Test& t) {
  const GLuint program = set_up_draw(t);
  give(program, good);
  expect_draw(t, 4, 1, "with a refinement shader");
  gl.RefinementShaderSourceARK(program, 0, nullptr, nullptr);
  t.expect_equal(source_length(program), 0, "the length without one");
  t.expect_equal(property(program, GL_REFINEMENT_STATUS_ARK), GLint{GL_TRUE}, "the status without one");
  expect_draw(t, 4, 0, "without one");
  give(program, broken);
  gl.RefinementShaderSourceARK(program, 0, nullptr, nullptr);
  expect_draw(t, 4, 0, "after a broken one was removed");
  const char* const empty[] = {"", "void refine() {"};
  const GLint lengths[] = {-1, 0};
  give(program, good);
  gl.RefinementShaderSourceARK(program, 2, empty, lengths);
  t.expect_equal(source_length(program), 0, "the length of empty strings");
  t.expect_equal(property(program, GL_REFINEMENT_STATUS_ARK), GLint{GL_TRUE}, "the status with empty strings");
  expect_draw(t, 4, 0, "with empty strings");
}

void check_replaced(Test& t) {
  const GLuint program = set_up_draw(t);
  expect_draw(t, 4, 0, "without a refinement shader");
  give(program, good);
  expect_draw(t, 4, 1, "with the first");
  constexpr char second[] = "void refine() { position.x += 4.0; }";
  give(program, second);
  t.expect_equal(source_length(program), length_of(second), "the length of the second");
  expect_draw(t, 4, 4, "with the second");
  give(program, good);
  expect_draw(t, 4, 1, "with the first again");
}

void check_relinked(Test& t) {
  const GLuint program = set_up_draw(t);
  give(program, good);
  expect_draw(t, 4, 1, "linked once");
  gl.LinkProgram(program);
  gl.UseProgram(program);
  t.expect_equal(source_length(program), length_of(good), "the length after LinkProgram");
  t.expect_equal(property(program, GL_REFINEMENT_STATUS_ARK), GLint{GL_TRUE}, "the status after LinkProgram");
  expect_draw(t, 4, 1, "linked again");
}

void check_before_link(Test& t) {
  const GLuint program = gl.CreateProgram();
  give(program, good);
  t.expect_no_error("RefinementShaderSourceARK of a program that is not linked");
  t.expect_equal(source_length(program), length_of(good), "the length");
  t.expect_equal(property(program, GL_REFINEMENT_STATUS_ARK), GLint{GL_FALSE}, "the status before LinkProgram");
  const std::string vertex = glsl_head(t) + "in vec4 position; void main() { gl_Position = position; }\n";
  const std::string fragment = glsl_head(t) + "out vec4 pixel; void main() { pixel = vec4(1.0); }\n";
  for (const auto& [stage, text] : {std::pair{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}}) {
    const GLuint shader = gl.CreateShader(static_cast<GLenum>(stage));
    const char* const source = text.c_str();
    gl.ShaderSource(shader, 1, &source, nullptr);
    gl.CompileShader(shader);
    gl.AttachShader(program, shader);
  }
  t.expect_equal(property(program, GL_REFINEMENT_STATUS_ARK), GLint{GL_FALSE}, "the status with shaders, not linked");
  gl.LinkProgram(program);
  t.expect_equal(property(program, GL_REFINEMENT_STATUS_ARK), GLint{GL_TRUE}, "the status once it is linked");
  t.expect_equal(source_length(program), length_of(good), "the length once it is linked");
}

void check_failed_link(Test& t) {
  const GLuint program = gl.CreateProgram();
  const GLuint shader = make_shader();
  const std::string text = glsl_head(t) + "void main() { gl_Position = undeclared; }\n";
  const char* const source = text.c_str();
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  gl.AttachShader(program, shader);
  gl.LinkProgram(program);
  t.expect_equal(property(program, GL_REFINEMENT_STATUS_ARK), GLint{GL_FALSE}, "the status of a link that failed");
  t.expect_no_error("the query");
}

void check_broken(Test& t) {
  const GLuint program = set_up_draw(t);
  give(program, broken);
  t.expect_no_error("a source with an error is no GL error");
  t.expect_equal(property(program, GL_REFINEMENT_LOG_LENGTH_ARK), 0, "no log: the source is not compiled");
  expect_draw(t, 1, 0, "drawn unrefined");
  t.expect_equal(property(program, GL_REFINEMENT_STATUS_ARK), GLint{GL_FALSE}, "the status");
  t.expect(property(program, GL_REFINEMENT_LOG_LENGTH_ARK) > 1, "there is a log");
  give(program, good);
  t.expect_equal(property(program, GL_REFINEMENT_STATUS_ARK), GLint{GL_TRUE}, "the status, once repaired");
  expect_draw(t, 4, 1, "once repaired");
}

struct Source {
  const char* leaf;
  const char* clause;
  const char* source;
  bool is_built;
};

const std::vector<Source>& sources() {
  static const std::vector<Source> all{
      {"no_refine", "11.R.9-12", "void other() { }", false},
      {"syntax", "11.R.9-28", "void refine() {", false},
      {"empty_body", "11.R.9-12", "void refine() { }", true},
      {"unknown_input", "11.R.9-14", "void refine() { position += no_input; }", false},
  };
  return all;
}

void check_source(Test& t, const Source& source) {
  const GLuint program =
      build_program(t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 3) in vec4 colour_input;\n"
                                  "out vec4 colour; void main() { colour = vec4(1.0); gl_Position = position; }\n"});
  gl.ARKinit(1);
  give(program, source.source);
  t.expect_equal(property(program, GL_REFINEMENT_STATUS_ARK), source.is_built ? GLint{GL_TRUE} : GLint{GL_FALSE},
                 "REFINEMENT_STATUS_ARK");
  t.expect_equal(source_length(program), length_of(source.source), "the length of the source");
  t.expect_no_error("the commands");
}

void check_shared(Test& t) {
  const GLuint program = capture_program(t);
  give(program, good);
  {
    const std::unique_ptr<Context> second = t.create_context(&t.context());
    t.expect_equal(source_length(program), length_of(good), "the length in the second context");
    gl.UseProgram(program);
    upload(one_triangle(), false);
    refine_uniformly(1);
    expect_draw(t, 4, 1, "in the second context");
    give(program, "void refine() { position.x += 2.0; }");
    if (t.is_compat()) t.expect_equal(source_length(0), 0, "the fixed function of the second context");
  }
  t.require(t.context().make_current(), "the first context can be made current again");
  set_up_draw(t);
  gl.UseProgram(program);
  expect_draw(t, 4, 2, "in the first context, with the source that the second gave");
}

// GL keeps a deleted program while it is in use, and so its refinement shader.
void check_deleted_in_use(Test& t) {
  const GLuint program = set_up_draw(t);
  give(program, good);
  expect_draw(t, 4, 1, "before DeleteProgram");
  gl.DeleteProgram(program);
  t.expect_equal(source_length(program), length_of(good), "the length while the program is in use");
  gl.UseProgram(program);
  t.expect_no_error("the program is still in use");
  t.expect_equal(source_length(program), length_of(good), "the length after UseProgram");
  gl.UseProgram(0);
  GLint length = 7;
  gl.GetRefinementivARK(program, GL_REFINEMENT_SOURCE_LENGTH_ARK, &length);
  t.expect_error(GL_INVALID_VALUE, "GetRefinementivARK once another program is in use");
  t.expect_equal(length, 7, "the value");
}

}  // namespace

Cases refinement_shader_api_cases() {
  Cases cases{
      {.name = "ark.shader.errors.values",
       .clauses = {"11.R.9-8", "11.R.9-32", "11.R.9-35", "errors-19", "errors-22", "errors-23", "errors-2"},
       .plan = "Negative counts, unknown properties and negative sizes; source and log stay.",
       .wrong = "A negative count removes the shader; -1 counts as a large size.",
       .check = check_counts_and_names},
      {.name = "ark.shader.strings",
       .clauses = {"11.R.9-1", "11.R.9-2", "11.R.9-3", "11.R.9-31", "functions-8"},
       .plan = "Give the same source in several strings, with lengths, without, and with negative ones; the strings "
               "change after the call.",
       .wrong = "A space or a line break between strings; a length is ignored; the pointer is kept.",
       .control = control,
       .check = check_strings},
      {.name = "ark.shader.removed",
       .clauses = {"11.R.9-37"},
       .plan = "Pass a count of 0 after a good and after a broken source, and draw after each.",
       .wrong = "An empty source without refine.",
       .control = control,
       .check = check_removed},
      {.name = "ark.shader.replaced",
       .clauses = {"11.R.9-6"},
       .plan = "Draw with no refinement shader, with one, with another, and with the first again.",
       .wrong = "The first source stays until LinkProgram; sources are appended to each other.",
       .control = control,
       .check = check_replaced},
      {.name = "ark.shader.relinked",
       .clauses = {"11.R.9-6"},
       .plan = "Link the program again and draw.",
       .wrong = "LinkProgram removes the refinement shader.",
       .control = control,
       .check = check_relinked},
      {.name = "ark.shader.before_link",
       .clauses = {"11.R.9-6", "11.R.9-29"},
       .plan = "Give a program its refinement shader before it has shaders, and link it.",
       .wrong = "INVALID_OPERATION; the source is forgotten; the earlier status is kept.",
       .check = check_before_link},
      {.name = "ark.shader.failed_link",
       .clauses = {"11.R.9-29"},
       .plan = "Ask for the status of a program whose link failed.",
       .wrong = "INVALID_OPERATION.",
       .check = check_failed_link},
      {.name = "ark.shader.broken",
       .clauses = {"11.R.9-7", "11.R.9-28", "11.R.9-30", "11.R.9-27"},
       .plan = "A source with an error: no GL error, no log until it is built, an unrefined draw, the status FALSE. "
               "Then a good source.",
       .wrong = "Compiled at once; refined without the shader; the draw generates an error.",
       .control = control,
       .check = check_broken},
      {.name = "ark.shader.deleted_in_use",
       .clauses = {"11.R.9-31", "11.R.9-36"},
       .plan = "Delete the program in use, ask for the length of its source, and use no program.",
       .wrong = "The length is 0 at once; or the name stays valid.",
       .control = control,
       .check = check_deleted_in_use},
      {.name = "ark.shader.shared",
       .clauses = {"11.R.9-2", "11.R.9-6", "state-28"},
       .plan =
           "Give a program its refinement shader in one context, draw in another of the share group, replace it there, "
           "and draw in the first.",
       .wrong = "A separate source for each context; the first context continues with the old one.",
       .control = control,
       .check = check_shared},
  };
  for (const BadProgram& bad : bad_programs()) {
    cases.push_back({.name = std::string("ark.shader.errors.program.") + bad.leaf,
                     .clauses = bad.clauses,
                     .plan = "Call the three commands with such a name: they generate the error and write nothing, and "
                             "the program in use keeps its source and log.",
                     .wrong = "The commands affect the program in use; another error.",
                     .check = [bad](Test& t) { check_bad_program(t, bad); }});
    if (!bad.is_compat) cases.back().apis = {Api::gl_core, Api::gles};
  }
  for (const Source& source : sources())
    cases.push_back(
        {.name = std::string("ark.shader.source.") + source.leaf,
         .clauses = {source.clause, "11.R.9-28", "state-29", "11.R.9-31"},
         .plan = std::string("Ask for the status with the source \"") + source.source + "\".",
         .wrong = "TRUE for everything that links; a search for the name refine finds it in a comment, or not at all.",
         .check = [source](Test& t) { check_source(t, source); }});
  return cases;
}

}  // namespace glark::conformance
