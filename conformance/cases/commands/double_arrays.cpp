// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Arrays of doubles in client memory and in buffers, whose content changes between draws that repeat.
#include <fmt/core.h>

#include <array>

#include "conformance/cases/cases.h"
#include "conformance/cases/commands/as_plain.h"

namespace glark::conformance {
namespace {

using DoubleContent = std::array<GLdouble, 12>;  // four components of three vertices

struct DoubleArray {
  const char* leaf;
  const char* value;  // in the vertex stage
  void (*point)(const void* content);
  void (*enable)();
};

constexpr GLuint double_generic = 9;

constexpr DoubleArray double_arrays[] = {
    {"vertexpointer", "vec4(0.5 + 0.5 * gl_Vertex.xy, 0.5, 1.0)",
     [](const void* content) { gl.VertexPointer(4, GL_DOUBLE, 0, content); },
     [] { gl.EnableClientState(GL_VERTEX_ARRAY); }},
    {"normalpointer", "vec4(abs(gl_Normal), 1.0)",
     [](const void* content) { gl.NormalPointer(GL_DOUBLE, 4 * sizeof(GLdouble), content); },
     [] { gl.EnableClientState(GL_NORMAL_ARRAY); }},
    {"colorpointer", "abs(gl_Color)", [](const void* content) { gl.ColorPointer(4, GL_DOUBLE, 0, content); },
     [] { gl.EnableClientState(GL_COLOR_ARRAY); }},
    {"texcoordpointer", "abs(gl_MultiTexCoord0)",
     [](const void* content) { gl.TexCoordPointer(3, GL_DOUBLE, 4 * sizeof(GLdouble), content); },
     [] { gl.EnableClientState(GL_TEXTURE_COORD_ARRAY); }},
    {"secondarycolorpointer", "abs(gl_SecondaryColor)",
     [](const void* content) { gl.SecondaryColorPointer(3, GL_DOUBLE, 4 * sizeof(GLdouble), content); },
     [] { gl.EnableClientState(GL_SECONDARY_COLOR_ARRAY); }},
    {"fogcoordpointer", "vec4(abs(gl_FogCoord))",
     [](const void* content) { gl.FogCoordPointer(GL_DOUBLE, 4 * sizeof(GLdouble), content); },
     [] { gl.EnableClientState(GL_FOG_COORD_ARRAY); }},
    {"vertexattribpointer", "abs(double_generic)",
     [](const void* content) { gl.VertexAttribPointer(double_generic, 4, GL_DOUBLE, GL_FALSE, 0, content); },
     [] { gl.EnableVertexAttribArray(double_generic); }},
};

// Corners of a triangle, which each turn moves; other arrays take them as colours.
DoubleContent double_content(int turn) {
  const GLdouble moved = 0.125 * turn;
  return {-0.75 + moved, -0.5, 0.25, 1, 0.75, -0.75 + moved, 0.5, 1, 0.25 - moved, 0.75, 0.875 - moved, 1};
}

GLuint double_program(Test& t, const DoubleArray& array) {
  return build_program(t, {.vertex = fmt::format("layout(location = {}) in vec4 double_generic; out vec4 colour;\n"
                                                 "void main() {{ gl_Position = gl_Vertex; vec4 value = {};\n"
                                                 "  colour = vec4(0.1 + 0.8 * value.rgb, 1.0); }}\n",
                                                 double_generic, array.value)});
}

void check_double_array(Test& t, const DoubleArray& array) {
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  const DoubleContent places = double_content(0);
  DoubleContent content = double_content(0);
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.UseProgram(double_program(t, array));
  gl.VertexPointer(4, GL_DOUBLE, 0, places.data());
  gl.EnableClientState(GL_VERTEX_ARRAY);
  array.enable();
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  for (const bool is_buffer : {false, true}) {
    content = double_content(0);
    gl.BindBuffer(GL_ARRAY_BUFFER, is_buffer ? buffer : 0);
    if (is_buffer) gl.BufferData(GL_ARRAY_BUFFER, sizeof(content), content.data(), GL_DYNAMIC_DRAW);
    array.point(is_buffer ? nullptr : content.data());
    Picture before;
    for (int turn = 0; turn < 4; ++turn) {
      content = double_content(turn);
      if (is_buffer) gl.BufferSubData(GL_ARRAY_BUFFER, 0, sizeof(content), content.data());
      const std::string what = fmt::format("{}, content {}", is_buffer ? "a buffer" : "client memory", turn);
      // The refined draw comes first: nothing else tells the implementation of new content.
      const Picture first = picture_of(draw);
      const PlainDraw plain = plain_draw(draw);
      t.expect_same_picture(first, plain.picture, what + ", first", 4, 40);
      expect_as_plain(t, plain, draw, what, {.is_often = true});
      if (turn > 0) t.expect(count_different(before, plain.picture, 4) > 40, what + ": differs unrefined");
      before = plain.picture;
    }
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases double_arrays_cases() {
  Cases cases;
  for (const DoubleArray& array : double_arrays)
    cases.push_back({.name = fmt::format("ark.command.double.{}", array.leaf),
                     .clauses = {"10.R.2-1", "11.R.13-1"},
                     .plan = "Draw an array of doubles often, in client memory and in a buffer, and change its content "
                             "between draws: each draw is the unrefined one.",
                     .wrong = "A draw keeps vertices of earlier content; doubles are read as floats.",
                     .apis = compat_only,
                     .check = [&array](Test& t) { check_double_array(t, array); }});
  return cases;
}

}  // namespace glark::conformance
