// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The refinement shader of the fixed-function vertex stage (11.R.9).
#include <array>
#include <string>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

Picture draw_fixed(float shift) {
  clear_surface();
  gl.Begin(GL_TRIANGLES);
  gl.Color3f(1, 0.5F, 0.25F);
  gl.Vertex2f(-0.75F + shift, -0.5F);
  gl.Vertex2f(0.25F + shift, -0.75F);
  gl.Vertex2f(-0.5F + shift, 0.625F);
  gl.End();
  return read_picture(surface_size, surface_size);
}

void control(Test& t) {
  t.expect(count_different(draw_fixed(0), Picture(surface_size, surface_size), 8) > 1000, "the triangle is drawn");
}

void check_fixed_shader(Test& t) {
  const Picture expected = draw_fixed(0.5F);
  const Picture unmoved = draw_fixed(0);
  refine_uniformly(2);
  set_refinement_shader(t, 0, "void refine() { gl_Vertex.x += 0.5; }");
  t.expect_same_picture(draw_fixed(0), expected, "moved by the refinement shader");
  gl.Disable(GL_ARK);
  t.expect_same_picture(draw_fixed(0), unmoved, "while refinement is disabled");
  gl.Enable(GL_ARK);
  gl.RefinementShaderSourceARK(0, 0, nullptr, nullptr);
  t.expect_same_picture(draw_fixed(0), unmoved, "without a refinement shader");
}

// refine() writes its inputs into the colour.
void check_fixed_inputs(Test& t, const std::string& colour, const std::array<float, 3>& expected) {
  refine_uniformly(1);
  set_refinement_shader(t, 0, "void refine() { gl_Color = vec4(" + colour + ", 1.0); }");
  const Picture picture = draw_fixed(0);
  const auto pixel = picture.at(surface_size * 3 / 10, surface_size * 4 / 10);
  for (std::size_t i = 0; i < 3; ++i)
    t.expect_near(pixel[i], 255 * double{expected[i]}, 2, "channel " + as_text(i) + " of the colour");
}

void check_fixed_uniform(Test& t) {
  const Picture expected = draw_fixed(0.25F);
  refine_uniformly(1);
  const GLuint program = colour_program(t);
  set_refinement_shader(t, 0, "void refine() { gl_Vertex.x += 0.25; }");
  GLint length = -7;
  gl.GetRefinementivARK(program, GL_REFINEMENT_SOURCE_LENGTH_ARK, &length);
  t.expect_equal(length, 0, "the program's source contains nothing of the fixed function's");
  t.expect_same_picture(draw_fixed(0), expected, "the fixed function");
}

constexpr Area shader_case{.prefix = "ark.shader.fixed.", .control = control, .apis = compat_only};

}  // namespace

Cases fixed_function_shader_cases() {
  return {
      shader_case("moves", {"11.R.9-4", "11.R.9-16", "11.R.9-37"},
                  "A refinement shader of the fixed function moves the triangle; then it is removed.",
                  "Program 0 is an error; the shader still applies to unrefined draws.", check_fixed_shader),
      shader_case("version", {"11.R.9-10"}, "refine() shows whether __VERSION__ is 150.",
                  "The version of another program.",
                  [](Test& t) {
                    check_fixed_inputs(t, "vec3(__VERSION__ == 150 ? 1.0 : 0.0, 0.5, 0.25)", {1, 0.5F, 0.25F});
                  }),
      shader_case(
          "corners", {"11.R.9-16", "11.R.9-14"}, "The colour comes from ark_corner_gl_Vertex and ark_corner_gl_Color.",
          "ark_corner_Vertex; another corner.",
          [](Test& t) {
            check_fixed_inputs(t, "ark_corner_gl_Vertex[1].x, ark_corner_gl_Vertex[2].y, ark_corner_gl_Color[0].b",
                               {0.25F, 0.625F, 0.25F});
          }),
      shader_case("own", {"11.R.9-4", "11.R.9-31"},
                  "The source of the fixed function is separate from every program's.", "One source for all programs.",
                  check_fixed_uniform),
  };
}

}  // namespace glark::conformance
