// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Programs that are loaded from the binary of another program. An implementation has no sources for them, unless it
// remembers what the binary was made of; a program of an earlier name must not be taken for them.
#include <string>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

struct Binary {
  GLenum format = 0;
  std::vector<unsigned char> bytes;
};

Binary binary_of(Test& t, GLuint program) {
  GLint formats = 0;
  gl.GetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
  if (formats == 0) t.not_supported("no program binaries");
  GLint length = 0;
  gl.GetProgramiv(program, GL_PROGRAM_BINARY_LENGTH, &length);
  Binary binary{.bytes = std::vector<unsigned char>(static_cast<std::size_t>(length))};
  GLsizei written = 0;
  gl.GetProgramBinary(program, length, &written, &binary.format, binary.bytes.data());
  t.expect_equal(written, length, "bytes of the binary");
  return binary;
}

void load(GLuint program, const Binary& binary) {
  gl.ProgramBinary(program, binary.format, binary.bytes.data(), static_cast<GLsizei>(binary.bytes.size()));
}

// Its triangle has another place and colour for each tint.
GLuint tinted_program(Test& t, const std::string& tint) {
  const GLuint program =
      build_program(t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 3) in vec4 colour;"
                                  "uniform float scale; out vec4 hue; void main() { hue = colour * vec4(" +
                                  tint + ", 1.0); gl_Position = vec4(position.xy * scale + 0.2 * vec3(" + tint +
                                  ").xy, position.zw); }",
                        .fragment = "in vec4 hue; out vec4 pixel; void main() { pixel = hue; }"});
  gl.UseProgram(program);
  gl.Uniform1f(gl.GetUniformLocation(program, "scale"), 0.7F);
  return program;
}

void set_scale(GLuint program, GLfloat scale) {
  gl.UseProgram(program);
  gl.Uniform1f(gl.GetUniformLocation(program, "scale"), scale);
}

void draw_loaded() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

Picture unrefined_picture() {
  gl.Disable(GL_ARK);
  Picture picture = conformance::picture_of(draw_loaded);
  gl.Enable(GL_ARK);
  return picture;
}

void expect_unrefined_picture(Test& t, const std::string& what) {
  const Picture expected = unrefined_picture();
  for (int again = 0; again < 2; ++again) {
    t.expect_same_picture(conformance::picture_of(draw_loaded), expected, what, 3, 40);
    repeat_often(draw_loaded);
  }
  t.expect_no_error(what);
}

struct Loading {
  const char* leaf;
  void (*check)(Test& t, GLuint red, GLuint green);
};

constexpr Loading loadings[] = {
    {"new_name",
     [](Test& t, GLuint, GLuint green) {
       const GLuint loaded = gl.CreateProgram();
       load(loaded, binary_of(t, green));
       set_scale(loaded, 0.9F);
       expect_unrefined_picture(t, "a new program");
     }},
    {"name_in_use",
     [](Test& t, GLuint red, GLuint green) {
       gl.UseProgram(red);
       repeat_often(draw_loaded);
       load(red, binary_of(t, green));
       set_scale(red, 0.9F);
       expect_unrefined_picture(t, "a program that was refined before");
     }},
    {"own_binary",
     [](Test& t, GLuint red, GLuint) {
       gl.UseProgram(red);
       repeat_often(draw_loaded);
       load(red, binary_of(t, red));
       set_scale(red, 0.5F);
       expect_unrefined_picture(t, "the program's own binary");
     }},
    {"refused",
     [](Test& t, GLuint red, GLuint) {
       gl.UseProgram(red);
       const Picture before = conformance::picture_of(draw_loaded);
       const GLuint loaded = gl.CreateProgram();
       const Binary nothing{binary_of(t, red).format, std::vector<unsigned char>(64, 0x55)};
       load(loaded, nothing);
       GLint is_linked = 1;
       gl.GetProgramiv(loaded, GL_LINK_STATUS, &is_linked);
       t.expect_equal(is_linked, 0, "LINK_STATUS of nonsense");
       while (gl.GetError() != GL_NO_ERROR) continue;
       t.expect_same_picture(conformance::picture_of(draw_loaded), before, "the program in use", 0, 0);
     }},
    {"linked_again",
     [](Test& t, GLuint red, GLuint green) {
       load(red, binary_of(t, green));
       set_scale(red, 0.9F);
       repeat_often(draw_loaded);
       gl.LinkProgram(red);  // its shaders are still attached
       set_scale(red, 0.6F);
       expect_unrefined_picture(t, "the program, linked again");
     }},
    {"later_link_of_source",
     [](Test& t, GLuint red, GLuint green) {
       const Binary binary = binary_of(t, green);
       gl.DeleteProgram(green);
       const GLuint loaded = gl.CreateProgram();
       load(loaded, binary);
       set_scale(loaded, 0.8F);
       expect_unrefined_picture(t, "a program whose source is deleted");
       gl.UseProgram(red);
       expect_unrefined_picture(t, "the other program");
     }},
};

void check_loading(Test& t, const Loading& loading, bool is_uniform) {
  upload(one_triangle());
  const GLuint red = tinted_program(t, "1.0, 0.2, 0.2");
  const GLuint green = tinted_program(t, "0.2, 1.0, 0.2");
  is_uniform ? refine_uniformly(2) : refine_by_tags(3);
  loading.check(t, red, green);
}

}  // namespace

Cases program_binaries_cases() {
  Cases cases;
  for (const Loading& loading : loadings)
    for (const bool is_uniform : {true, false})
      cases.push_back(
          {.name = std::string("ark.programs.binary.") + loading.leaf + (is_uniform ? ".uniform" : ".tags"),
           .clauses = {"10.R.2-2", "11.R.13-1"},
           .plan = "Load a program from a binary, and draw with it, often. The picture is the unrefined one.",
           .wrong = "The program is refined as what had its name before; or it draws nothing.",
           .is_optional = true,
           .check = [&loading, is_uniform](Test& t) { check_loading(t, loading, is_uniform); }});
  return cases;
}

}  // namespace glark::conformance
