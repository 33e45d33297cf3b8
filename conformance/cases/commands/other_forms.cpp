// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Commands of programs, vertex arrays and feedback in the forms that no other case calls. A refined draw looks like the
// unrefined one.
#include <array>
#include <string>

#include "conformance/cases/cases.h"
#include "conformance/cases/commands/as_plain.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

struct OtherForm {
  const char* leaf;  // the command
  void (*check)(Test&);
  Apis apis = every_api;
  int version = 0;
};

void draw_form() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

// Expects the unrefined picture now and often, and returns it.
Picture expect_form(Test& t, const std::string& what) {
  const PlainDraw plain = plain_draw(draw_form);
  expect_as_plain(t, plain, draw_form, what, {.is_often = true});
  return plain.picture;
}

// The surface shows the output at location 0.
void check_fragment_locations(Test& t) {
  upload(one_triangle());
  refine_uniformly(2);
  const GLuint program =
      build_program(t, {.vertex = plain_vertex_shader,
                        .fragment = "in vec4 colour; out vec4 pixel; out vec4 other;\n"
                                    "void main() { pixel = colour; other = vec4(1.0 - colour.rgb, 1.0); }"});
  gl.UseProgram(program);
  std::array<Picture, 2> pictures;
  for (const GLuint location : {0U, 1U}) {
    gl.BindFragDataLocation(program, location, "pixel");
    gl.BindFragDataLocation(program, 1 - location, "other");
    gl.LinkProgram(program);
    pictures[location] = expect_form(t, "another location");
  }
  t.expect(count_different(pictures[0], pictures[1], 8) > 400, "the location decides what shows");
}

// Makes an array object with positions at location 0. `format` says what location 3 reads behind them.
void make_named_array(GLsizei stride, const void* words, GLsizeiptr bytes, const std::function<void(GLuint)>& format) {
  GLuint array = 0;
  GLuint buffer = 0;
  gl.CreateVertexArrays(1, &array);
  gl.CreateBuffers(1, &buffer);
  gl.NamedBufferStorage(buffer, bytes, words, 0);
  gl.VertexArrayVertexBuffer(array, 0, buffer, 0, stride);
  gl.VertexArrayAttribFormat(array, at_position, 2, GL_FLOAT, GL_FALSE, 0);
  for (const GLuint location : {GLuint{at_position}, GLuint{at_colour}}) {
    gl.VertexArrayAttribBinding(array, location, 0);
    gl.EnableVertexArrayAttrib(array, location);
  }
  format(array);
  gl.BindVertexArray(array);
}

struct FormatVertex {
  std::array<GLfloat, 2> position;
  std::array<GLubyte, 8> integers;
  std::array<GLdouble, 4> doubles;
};
constexpr std::array<FormatVertex, 3> format_vertices = {
    {{{-0.8F, -0.7F}, {200, 30, 90, 255, 10, 250, 60, 255}, {0.9, 0.1, 0.4, 0.8}},
     {{0.8F, -0.6F}, {20, 130, 190, 255, 210, 50, 160, 255}, {0.2, 0.7, 0.9, 0.1}},
     {{-0.1F, 0.8F}, {120, 230, 9, 255, 100, 150, 6, 255}, {0.5, 0.3, 0.1, 0.6}}}};

void check_named_format(Test& t, const std::string& vertex, const std::string& fragment,
                        const std::function<void(GLuint, GLuint)>& format, bool may_stay) {
  gl.UseProgram(build_program(t, {.vertex = vertex, .fragment = fragment}));
  refine_uniformly(2);
  GLuint array = 0;
  make_named_array(sizeof(FormatVertex), format_vertices.data(), sizeof(format_vertices), [&](GLuint name) {
    array = name;
    format(array, 0);
  });
  std::array<Picture, 2> pictures;
  for (const GLuint half : {0U, 1U}) {
    format(array, half);
    const PlainDraw plain = plain_draw(draw_form);
    const bool stays = may_stay && count_generated(draw_form) == 1;
    expect_as_plain(t, plain, draw_form, "another offset", {.level = stays ? 0U : 2U, .is_often = true});
    pictures[half] = plain.picture;
  }
  t.expect(count_different(pictures[0], pictures[1], 8) > 400, "the offset decides what shows");
  t.expect_no_error("the draws");
}

void check_integer_format(Test& t) {
  check_named_format(
      t,
      "layout(location = 0) in vec4 position; layout(location = 3) in uvec4 integers; flat out vec4 colour;\n"
      "void main() { colour = vec4(integers) / 255.0; gl_Position = position; }",
      "flat in vec4 colour; out vec4 pixel; void main() { pixel = colour; }",
      [](GLuint array, GLuint half) {
        gl.VertexArrayAttribIFormat(array, at_colour, 4, GL_UNSIGNED_BYTE, offsetof(FormatVertex, integers) + 4 * half);
      },
      false);
}

// A draw with double-precision inputs may stay unrefined (11.R.11).
void check_double_format(Test& t) {
  check_named_format(
      t,
      "layout(location = 0) in vec4 position; layout(location = 3) in dvec2 doubles; out vec4 colour;\n"
      "void main() { colour = vec4(doubles, 0.5, 1.0); gl_Position = position; }",
      "in vec4 colour; out vec4 pixel; void main() { pixel = colour; }",
      [](GLuint array, GLuint half) {
        gl.VertexArrayAttribLFormat(array, at_colour, 2, GL_DOUBLE, offsetof(FormatVertex, doubles) + 16 * half);
      },
      true);
}

// An object of feedback gets its buffer without being bound.
void check_named_feedback(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(one_triangle());
  refine_uniformly(2);
  constexpr std::size_t count = 16 * 3;
  std::array<CapturedVertex, count> vertices{};
  GLuint object = 0;
  std::array<GLuint, 2> buffers{};
  gl.CreateTransformFeedbacks(1, &object);
  gl.CreateBuffers(2, buffers.data());
  for (const GLuint buffer : buffers) {
    gl.NamedBufferData(buffer, sizeof(vertices), vertices.data(), GL_STATIC_READ);
    gl.TransformFeedbackBufferBase(object, 0, buffer);
    gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, object);
    gl.BeginTransformFeedback(GL_TRIANGLES);
    draw_form();
    gl.EndTransformFeedback();
    gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
    gl.GetNamedBufferSubData(buffer, 0, sizeof(vertices), vertices.data());
    for (const CapturedVertex& vertex : vertices)
      if (!t.expect_near(vertex.weights[0] + vertex.weights[1] + vertex.weights[2], 1, 1e-6, "weights of a vertex"))
        return;
  }
  t.expect_no_error("the draws");
}

// Without its compiler, an implementation compiles again when it has to.
void check_released_compiler(Test& t) {
  upload(one_triangle());
  for (const GLenum refinement : {GL_LINEAR_INPUTS_ARK, GL_LINEAR_OUTPUTS_ARK, GL_PHONG_ARK}) {
    gl.UseProgram(colour_program(t));
    gl.ReleaseShaderCompiler();
    refine_uniformly(2, refinement);
    expect_form(t, "after ReleaseShaderCompiler");
    gl.ReleaseShaderCompiler();
    expect_form(t, "after another one");
  }
  t.expect_no_error("the draws");
}

// GL refuses the binary of a format that it does not have. The shader's source and its program stay.
void check_refused_binary(Test& t) {
  upload(one_triangle());
  refine_uniformly(2);
  const GLuint program = colour_program(t);
  gl.UseProgram(program);
  const Picture before = expect_form(t, "before");
  std::array<GLuint, 2> shaders{};
  GLsizei count = 0;
  gl.GetAttachedShaders(program, 2, &count, shaders.data());
  if (count == 0) shaders[0] = gl.CreateShader(GL_VERTEX_SHADER);
  constexpr GLuint words[] = {1, 2, 3, 4};
  gl.ShaderBinary(1, shaders.data(), 0x1234, words, sizeof(words));
  t.expect_error(GL_INVALID_ENUM, "ShaderBinary of no format");
  t.expect_same_picture(expect_form(t, "after a refused binary"), before, "the program stays");
  gl.LinkProgram(program);
  t.expect_same_picture(expect_form(t, "linked again"), before, "the sources stay");
}

constexpr OtherForm other_forms[] = {
    {"BindFragDataLocation", check_fragment_locations, desktop_apis},
    {"VertexArrayAttribIFormat", check_integer_format, desktop_apis, 45},
    {"VertexArrayAttribLFormat", check_double_format, desktop_apis, 45},
    {"TransformFeedbackBufferBase", check_named_feedback, desktop_apis, 45},
    {"ReleaseShaderCompiler", check_released_compiler},
    {"ShaderBinary", check_refused_binary},
};

}  // namespace

Cases other_forms_cases() {
  Cases cases;
  for (const OtherForm& form : other_forms)
    cases.push_back({.name = "ark.command.other." + leaf_of_command(form.leaf),
                     .clauses = {"10.R.2-2", "11.R.13-1"},
                     .plan = "Draw often before and after this command, refined and unrefined.",
                     .wrong = "The command is not passed on, or a kept draw has the state of before.",
                     .apis = form.apis,
                     .is_optional = form.version != 0,
                     .check = [&form](Test& t) {
                       if (t.version() < form.version) t.not_supported("no such command");
                       form.check(t);
                     }});
  return cases;
}

}  // namespace glark::conformance
