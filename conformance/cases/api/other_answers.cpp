// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What the GL answers besides the extension's own state: its strings, errors that were there before, logs, uniforms that live on.
#include <cstring>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

void draw_triangle() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

void check_strings(Test& t) {
  GLint count = 0;
  gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
  t.require(count > 0, "there are extensions");
  GLint64 long_count = 0;
  GLfloat number = 0;
  gl.GetInteger64v(GL_NUM_EXTENSIONS, &long_count);
  gl.GetFloatv(GL_NUM_EXTENSIONS, &number);
  t.expect_equal(long_count, GLint64{count}, "GetInteger64v");
  t.expect_equal(number, static_cast<GLfloat>(count), "GetFloatv");
  int named = 0;
  for (GLint i = 0; i < count; ++i) {
    const auto* const name = reinterpret_cast<const char*>(gl.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
    if (!t.expect(name != nullptr, "extension " + as_text(i) + " has a name")) return;
    named += std::strcmp(name, "GL_ARK_adaptive_refinement") == 0 ? 1 : 0;
  }
  t.expect_equal(named, 1, "the extension is named once");
  t.expect_no_error("names within the number of extensions");
  for (const GLuint index : {static_cast<GLuint>(count), static_cast<GLuint>(count) + 1, 0xffffffffU}) {
    t.expect(gl.GetStringi(GL_EXTENSIONS, index) == nullptr, "no name beyond the last");
    t.expect_error(GL_INVALID_VALUE, "an index beyond the last");
  }
}

// Errors of before are neither lost nor taken for the draw's.
void check_pending(Test& t) {
  gl.UseProgram(colour_program(t));
  upload(one_triangle());
  clear_surface();
  gl.Enable(0x1234);
  refine_uniformly(2);
  draw_triangle();
  t.expect_error(GL_INVALID_ENUM, "the error of before the first refined draw");
  t.expect_no_error("no other error");
  const Picture first = read_picture(surface_size, surface_size);
  t.expect(count_different(first, Picture(surface_size, surface_size), 8) > 1000, "the triangle is drawn all the same");
  for (int again = 0; again < 4; ++again) {
    clear_surface();
    gl.LineWidth(-1);
    draw_triangle();
    t.expect_error(GL_INVALID_VALUE, "the error of before a repeated draw");
    t.expect_no_error("no other error");
    t.expect_same_picture(read_picture(surface_size, surface_size), first, "the repeated draw");
    gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, -1);
    gl.ARKinit(3);
    t.expect_error(GL_INVALID_VALUE, "the error of before ARKinit");
    t.expect_no_error("no other error");
  }
}

// The program has the tags as a vec4 whose other components would give other depths.
void check_wide_tags(Test& t) {
  const GLuint program = build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 5) in vec4 tag; out vec4 colour;\n"
                    "void main() { colour = tag; gl_Position = position; }\n"});
  gl.UseProgram(program);
  upload(one_triangle(), false);
  gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, at_tag);
  const GLfloat tags[] = {1, 3, 0, 4, 2, 0, 4, 1, 3, 4, 1, 0};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(tags), tags, GL_STATIC_DRAW);
  gl.VertexAttribPointer(at_tag, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.EnableVertexAttribArray(at_tag);
  refine_by_tags(4);
  const std::int64_t expected = reference::minimum_triangles(reference::edge_depths({1, 2, 3}));
  t.expect_equal(std::int64_t{count_generated(draw_triangle)}, expected, "triangles of tags in vectors");
}

// After a failure and its mending the log is that of the last attempt.
void check_log(Test& t) {
  const GLuint program = colour_program(t);
  const auto build = [program](const char* source) {
    GLint status = -1;
    gl.RefinementShaderSourceARK(program, 1, &source, nullptr);
    gl.GetRefinementivARK(program, GL_REFINEMENT_STATUS_ARK, &status);
    return status;
  };
  const auto log_of = [program] {
    GLint length = 0;
    gl.GetRefinementivARK(program, GL_REFINEMENT_LOG_LENGTH_ARK, &length);
    std::string log(static_cast<std::size_t>(length) + 1, '\0');
    gl.GetRefinementInfoLogARK(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
    log.resize(std::strlen(log.c_str()));
    return log;
  };
  gl.ARKinit(2);
  t.expect_equal(build("void refine() { colour_of_nothing = 1.0; }"), GLint{GL_FALSE}, "the status of a faulty shader");
  const std::string first = log_of();
  t.expect(first.find("colour_of_nothing") != std::string::npos, "the log names what is wrong");
  t.expect_equal(build("void refine() { position.x += 0.0; }"), GLint{GL_TRUE}, "the status of the mended shader");
  t.expect(log_of().find("colour_of_nothing") == std::string::npos, "the log of the failure is gone");
  t.expect_equal(build("void refine() { other_mistake = 1.0; }"), GLint{GL_FALSE}, "the status of another fault");
  t.expect(log_of().find("other_mistake") != std::string::npos, "the log is that of the last attempt");
}

// Set once, with one refinement parameter, and used with all others.
void check_uniform_stays(Test& t) {
  const GLuint program = colour_program(t);
  const char* const source = "uniform vec4 shift;\nvoid refine() { position.xy += shift.zw; }\n";
  GLint status = GL_FALSE;
  gl.UseProgram(program);
  upload(one_triangle());
  refine_uniformly(2);
  gl.RefinementShaderSourceARK(program, 1, &source, nullptr);
  gl.GetRefinementivARK(program, GL_REFINEMENT_STATUS_ARK, &status);
  t.require(status == GL_TRUE, "the refinement program is built");
  const auto picture = [] {
    clear_surface();
    draw_triangle();
    return read_picture(surface_size, surface_size);
  };
  const Picture unmoved = picture();
  gl.Uniform4f(gl.GetUniformLocation(program, "shift"), 9, 9, 0.25F, -0.125F);
  const Picture moved = picture();
  t.expect(count_different(moved, unmoved, 8) > 500, "the uniform shows");
  struct Parameter {
    GLenum name;
    GLenum value;
  };
  for (const Parameter& parameter :
       {Parameter{GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK}, Parameter{GL_REFINEMENT_ARK, GL_CURVED_PN_ARK},
        Parameter{GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK}, Parameter{GL_REFINEMENT_ARK, GL_LINEAR_OUTPUTS_ARK},
        Parameter{GL_GEOMORPH_ARK, GL_TRUE}, Parameter{GL_WELD_ARK, GL_TRUE},
        Parameter{GL_REFINEMENT_ARK, GL_LINEAR_INPUTS_ARK}, Parameter{GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK}}) {
    gl.ARKParameteriARK(parameter.name, static_cast<GLint>(parameter.value));
    t.expect_same_picture(picture(), moved, "with parameter " + as_text(parameter.name), 4, 60);
  }
}

// The source that is linked is the one that was compiled.
void check_source_not_compiled(Test& t) {
  const std::string fragment = glsl_head(t) + Sources{}.fragment;
  const auto vertex = [&t](const char* colour) {
    return glsl_head(t) + "layout(location = 0) in vec4 position; out vec4 colour;\nvoid main() { colour = " + colour +
           "; gl_Position = position; }\n";
  };
  const std::string compiled = vertex("vec4(0.0, 1.0, 0.0, 1.0)");
  const std::string later = vertex("vec4(1.0, 0.0, 0.0, 1.0)");
  const GLuint program = gl.CreateProgram();
  GLuint shaders[2];
  for (int i = 0; i < 2; ++i) {
    shaders[i] = gl.CreateShader(i == 0 ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
    const char* const text = i == 0 ? compiled.c_str() : fragment.c_str();
    gl.ShaderSource(shaders[i], 1, &text, nullptr);
    gl.CompileShader(shaders[i]);
    gl.AttachShader(program, shaders[i]);
  }
  const char* const text = later.c_str();
  gl.ShaderSource(shaders[0], 1, &text, nullptr);
  gl.LinkProgram(program);
  gl.UseProgram(program);
  upload(one_triangle());
  clear_surface();
  draw_triangle();
  const Picture plain = read_picture(surface_size, surface_size);
  refine_uniformly(2);
  clear_surface();
  draw_triangle();
  t.expect_same_picture(read_picture(surface_size, surface_size), plain, "the compiled source, refined", 1, 30);
}

// What is refused is not on the stack.
void check_enable_group_overflow(Test& t) {
  gl.ARKinit(2);
  const GLint depth = integer_of(GL_MAX_ATTRIB_STACK_DEPTH);
  const auto is_enabled_at = [](GLint i) { return i % 3 == 0; };
  for (GLint i = 0; i <= depth; ++i) {
    (is_enabled_at(i) ? gl.Enable : gl.Disable)(GL_ARK);
    gl.PushAttrib(GL_ENABLE_BIT);
  }
  t.expect_error(GL_STACK_OVERFLOW, "PushAttrib once more than MAX_ATTRIB_STACK_DEPTH");
  for (GLint i = depth; i-- > 0;) {
    gl.PopAttrib();
    t.expect_equal(gl.IsEnabled(GL_ARK) == GL_TRUE, is_enabled_at(i), "after PopAttrib to depth " + std::to_string(i));
  }
}

constexpr Area answer_case{""};

}  // namespace

Cases other_answers_cases() {
  Cases cases{
      answer_case("ark.query.strings", {"name-1"}, "Ask for the number of extensions in every way, and beyond it.",
                  "One query has the number without this extension; a name for any index.", check_strings),
      answer_case("ark.error.pending", {"10.R.2-13", "errors-2"},
                  "Errors that are there before a refined draw: still there after it, and once.",
                  "They are lost, doubled, or taken for the draw's, which is then not drawn.", check_pending),
      answer_case("ark.tags.readable.vector", {"10.R.1-3", "10.R.1-8"},
                  "The program reads the tags' attribute as a vec4 with something else in the other components.",
                  "Another component counts.", check_wide_tags),
      answer_case("ark.shader.log.last", {"11.R.9-30", "11.R.9-34"}, "Build a faulty shader, a good one, a faulty one.",
                  "The log of an earlier attempt.", check_log),
      answer_case("ark.shader.uniform.stays", {"11.R.9-21", "11.R.9-22"},
                  "Set a uniform of the refinement shader once, and change every refinement parameter.",
                  "It is 0 in the programs of other parameters.", check_uniform_stays),
      answer_case("ark.stage.source_not_compiled", {"11.R.10-1"},
                  "Give the vertex shader another source after it was compiled, and link.",
                  "The refined draw has the source that was never compiled.", check_source_not_compiled)};
  cases.push_back(answer_case("ark.group.overflow", {"chapter-22-1"},
                              "PushAttrib until the stack is full and once more, then PopAttrib down to the first.",
                              "What was refused is restored: each level has the value of the one above.",
                              check_enable_group_overflow, compat_only));
  return cases;
}

}  // namespace glark::conformance
