// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws that are repeated after a change of the format of an array, of the restart index, or of the buffer that a later
// write goes to. Each change is made back and forth, while draws are refined.
#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/expect_change.h"

namespace glark::conformance {
namespace {

constexpr GLsizei stride = 4;

// A triangle with positions in a buffer of their own. The bytes of its colours mean something else in each format.
void set_up(Test& t, bool is_uniform) {
  gl.UseProgram(build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 3) in vec4 c; out vec4 colour;\n"
                    "void main() { colour = vec4(abs(fract(0.37 * c.rgb + 0.1 * c.a)), 1.0);\n"
                    "  gl_Position = position; }\n"}));
  upload(one_triangle({2, 2, 2}));
  const GLubyte bytes[24] = {200, 30, 0,  255, 10, 220, 90, 255, 60, 160, 250, 255,
                             20,  30, 40, 50,  60, 70,  80, 90,  91, 92,  93,  94};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(bytes), bytes, GL_STATIC_DRAW);
  gl.VertexAttribPointer(at_colour, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, nullptr);
  gl.EnableVertexAttribArray(at_colour);
  is_uniform ? refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK) : refine_by_tags(3, GL_LINEAR_OUTPUTS_ARK);
}

void draw() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

struct Format {
  const char* name;
  GLint size;
  GLenum type;
  GLboolean normalized;
};

constexpr Format formats[] = {{"unsigned bytes", 4, GL_UNSIGNED_BYTE, GL_FALSE},
                              {"normalized unsigned bytes", 4, GL_UNSIGNED_BYTE, GL_TRUE},
                              {"unsigned bytes again", 4, GL_UNSIGNED_BYTE, GL_FALSE},
                              {"bytes", 4, GL_BYTE, GL_FALSE},
                              {"normalized bytes", 4, GL_BYTE, GL_TRUE},
                              {"bytes again", 4, GL_BYTE, GL_FALSE},
                              {"three bytes", 3, GL_BYTE, GL_FALSE},
                              {"two bytes", 2, GL_BYTE, GL_FALSE},
                              {"two shorts", 2, GL_SHORT, GL_FALSE},
                              {"two normalized shorts", 2, GL_SHORT, GL_TRUE},
                              {"two unsigned shorts", 2, GL_UNSIGNED_SHORT, GL_TRUE},
                              {"one short", 1, GL_SHORT, GL_TRUE}};

void check_formats(Test& t, bool is_uniform, void (*set)(const Format&)) {
  set_up(t, is_uniform);
  for (const Format& format : formats)
    expect_change(
        t, draw, [&] { set(format); }, format.name);
}

void set_pointer(const Format& f) { gl.VertexAttribPointer(at_colour, f.size, f.type, f.normalized, stride, nullptr); }
void set_format(const Format& f) { gl.VertexAttribFormat(at_colour, f.size, f.type, f.normalized, 0); }

// Indices of a strip. With the restart, they are two triangles; without it, the greatest index is that of a vertex.
void check_restart(Test& t, bool is_uniform, bool is_fixed) {
  gl.UseProgram(colour_program(t));
  Mesh mesh(256, one_triangle({2, 2, 2})[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    mesh[i] = mesh[i + 3] = one_triangle({2, 2, 2})[i];
    mesh[i].position[0] = 0.4F * mesh[i].position[0] - 0.5F;
    mesh[i + 3].position[0] = 0.4F * mesh[i + 3].position[0] + 0.5F;
  }
  upload(mesh);
  const GLubyte indices[] = {0, 1, 2, 255, 3, 4, 5, 5};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
  const GLenum capability = is_fixed ? GL_PRIMITIVE_RESTART_FIXED_INDEX : GL_PRIMITIVE_RESTART;
  if (!is_fixed) gl.PrimitiveRestartIndex(255);
  is_uniform ? refine_uniformly(2) : refine_by_tags(3);
  const Draw draw_strip = [] { gl.DrawElements(GL_TRIANGLE_STRIP, 7, GL_UNSIGNED_BYTE, nullptr); };
  for (int again = 0; again < 2; ++again) {
    expect_change(
        t, draw_strip, [=] { gl.Enable(capability); }, "restart", 100);
    if (!is_fixed) {
      expect_change(
          t, draw_strip, [] { gl.PrimitiveRestartIndex(4); }, "another restart index", 100);
      gl.PrimitiveRestartIndex(255);
    }
    expect_change(
        t, draw_strip, [=] { gl.Disable(capability); }, "no restart", 100);
  }
}

// The write goes to the buffer that PopClientAttrib binds again, with the vertices of the draw.
void check_popped_buffer(Test& t, bool is_uniform) {
  set_up(t, is_uniform);
  for (const GLubyte red : {GLubyte{250}, GLubyte{10}, GLubyte{130}})
    expect_change(
        t, draw,
        [&] {
          gl.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
          GLuint other = 0;
          gl.GenBuffers(1, &other);
          gl.BindBuffer(GL_ARRAY_BUFFER, other);
          gl.BufferData(GL_ARRAY_BUFFER, 24, nullptr, GL_STATIC_DRAW);
          gl.PopClientAttrib();
          const GLubyte bytes[12] = {red, 30, 0, 255, red, 220, 90, 255, red, 160, 250, 255};
          gl.BufferSubData(GL_ARRAY_BUFFER, 0, sizeof(bytes), bytes);
        },
        "red " + as_text(int{red}));
}

}  // namespace

Cases changed_formats_cases() {
  Cases cases;
  const std::vector<std::string> clauses = {"11.R.10-1", "11.R.13-1"};
  const char* const wrong = "The draw has the earlier vertices.";
  for (const bool is_uniform : {true, false}) {
    const std::string end = is_uniform ? ".uniform" : ".tags";
    cases.push_back({.name = "ark.draw.again.format.pointer" + end,
                     .clauses = clauses,
                     .plan = "Give the array of colours one format after another by VertexAttribPointer.",
                     .wrong = wrong,
                     .check = [=](Test& t) { check_formats(t, is_uniform, set_pointer); }});
    cases.push_back({.name = "ark.draw.again.format.vertex_format" + end,
                     .clauses = clauses,
                     .plan = "Give the array of colours one format after another by VertexAttribFormat.",
                     .wrong = wrong,
                     .check = [=](Test& t) { check_formats(t, is_uniform, set_format); }});
    cases.push_back({.name = "ark.draw.again.restart.fixed" + end,
                     .clauses = clauses,
                     .plan = "Enable and disable PRIMITIVE_RESTART_FIXED_INDEX between draws of the same indices.",
                     .wrong = wrong,
                     .check = [=](Test& t) { check_restart(t, is_uniform, true); }});
    cases.push_back({.name = "ark.draw.again.restart.index" + end,
                     .clauses = clauses,
                     .plan = "Enable PRIMITIVE_RESTART, change its index, and disable it between draws.",
                     .wrong = wrong,
                     .apis = desktop_apis,
                     .check = [=](Test& t) { check_restart(t, is_uniform, false); }});
    cases.push_back(
        {.name = "ark.draw.again.popped_buffer" + end,
         .clauses = clauses,
         .plan = "Bind another buffer between PushClientAttrib and PopClientAttrib, and write to the first.",
         .wrong = wrong,
         .apis = compat_only,
         .check = [=](Test& t) { check_popped_buffer(t, is_uniform); }});
  }
  return cases;
}

}  // namespace glark::conformance
