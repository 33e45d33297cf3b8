// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Geomorphing (11.R.14) of colours. GL clamps the colours of a vertex stage to 0..1 (CLAMP_VERTEX_COLOR). They must be
// clamped before they are blended.
#include <algorithm>
#include <cmath>

#include "conformance/cases/cases.h"
#include "conformance/support/geomorph.h"

namespace glark::conformance {
namespace {

constexpr float tag = 0.5F;  // of all corners, so that each edge has one odd vertex

struct ColourOutput {
  const char* leaf;
  const char* statement;  // assigns `c` in the vertex stage; empty: the fixed function
  const char* pixel = "gl_Color";
  bool is_back = false;
};
constexpr ColourOutput outputs[] = {
    {"fixed_function", ""},
    {"front", "gl_FrontColor = c;"},
    {"back", "gl_FrontColor = vec4(0.0); gl_BackColor = c;", "gl_Color", true},
    {"front_secondary", "gl_FrontSecondaryColor = c;", "gl_SecondaryColor"},
    {"back_secondary", "gl_FrontSecondaryColor = vec4(0.0); gl_BackSecondaryColor = c;", "gl_SecondaryColor", true},
};

void use(Test& t, const ColourOutput& output) {
  if (output.statement[0] == '\0') return;
  std::string log;
  const GLuint program = try_program({.vertex = std::string("#version 120\nvoid main() { vec4 c = gl_Color; ") +
                                                output.statement + " gl_Position = gl_Vertex; }\n",
                                      .fragment = std::string("#version 120\nvoid main() { gl_FragColor = vec4(") +
                                                  output.pixel + ".rgb * 0.5, 1.0); }\n"},
                                     log);
  if (program == 0) t.internal_error(log);
  gl.UseProgram(program);
  if (output.is_back) gl.Enable(GL_VERTEX_PROGRAM_TWO_SIDE);
}

// (11.R.8) for the vertex between two corners of depth `tag`.
double blended(double from, double to, bool is_clamped) {
  const auto stage = [=](double value) { return is_clamped ? std::clamp(value, 0.0, 1.0) : value; };
  const double s = static_cast<double>(tag);
  return (1 - s) / 2 * (stage(from) + stage(to)) + s * stage((from + to) / 2);
}

// The middle of the lower edge, which is long. Red is above 1 at one corner, green below 0, blue in between.
void check_colours(Test& t, const ColourOutput& output, bool is_clamped) {
  use(t, output);
  gl.ClampColor(GL_CLAMP_VERTEX_COLOR, is_clamped ? GL_TRUE : GL_FALSE);
  const Vec3 colours[3] = {{3, -2, 0.8F}, {-0.5F, 1, 0.2F}, {0, 0, 0}};
  const auto draw = [&] {
    gl.Begin(GL_TRIANGLES);
    for (const int corner : output.is_back ? std::array<int, 3>{0, 2, 1} : std::array<int, 3>{0, 1, 2}) {
      gl.Color3fv(colours[corner].data());
      gl.Vertex2f(corner == 1 ? 1.0F : -1.0F, corner == 2 ? 1.0F : -1.0F);
    }
    gl.End();
  };
  morph_by_tags(3);
  GLint attribute = 0;
  gl.GetIntegerv(GL_DEPTH_TAG_ATTRIBUTE_ARK, &attribute);
  gl.VertexAttrib1f(static_cast<GLuint>(attribute), tag);
  const double factor = output.statement[0] == '\0' ? 1 : 0.5;
  for (int again = 0; again < 3; ++again) {
    const auto pixel = picture_of(draw).at(surface_size / 2, 0);
    for (std::size_t i = 0; i < 3; ++i) {
      const double red = blended(static_cast<double>(colours[0][i]), static_cast<double>(colours[1][i]), is_clamped);
      t.expect_near(pixel[i], 255 * std::clamp(factor * red, 0.0, 1.0), 6, "channel " + as_text(i) + " in the middle");
    }
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases morphed_colours_cases() {
  Cases cases;
  for (const ColourOutput& output : outputs)
    for (const bool is_clamped : {true, false})
      cases.push_back({.name = std::string("ark.geomorph.colour.") + output.leaf + (is_clamped ? "" : ".not_clamped"),
                       .clauses = {"11.R.14-10"},
                       .plan = "An edge of depth 0.5 whose corners have colours above 1 and below 0: its middle.",
                       .wrong = "Colours are blended before they are clamped.",
                       .apis = compat_only,
                       .check = [&output, is_clamped](Test& t) { check_colours(t, output, is_clamped); }});
  return cases;
}

}  // namespace glark::conformance
