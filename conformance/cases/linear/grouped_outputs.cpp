// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Outputs in structures, arrays and blocks, and outputs that several vertex shaders of a program share, under each
// refinement and with geomorphing.
#include <string>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

struct GroupedOutput {
  const char* leaf;
  const char* output;    // of the vertex stage
  const char* input;     // the same, of the fragment stage
  const char* assigned;  // from `c`
  const char* read;      // a vec4
  Apis apis = every_api;
};
constexpr GroupedOutput grouped_outputs[] = {
    {"structure", "struct Pair { vec2 a; vec2 b; }; out Pair pair;", "struct Pair { vec2 a; vec2 b; }; in Pair pair;",
     "pair.a = c.xy; pair.b = c.zw;", "vec4(pair.a, pair.b)"},
    {"structure_of_array", "struct Many { float a[3]; float b; }; out Many many;",
     "struct Many { float a[3]; float b; }; in Many many;",
     "many.a[0] = c.x; many.a[1] = c.y; many.a[2] = c.z; many.b = c.w;",
     "vec4(many.a[0], many.a[1], many.a[2], many.b)", desktop_apis},
    {"array_of_vectors", "out vec2 both[2];", "in vec2 both[2];", "both[0] = c.xy; both[1] = c.zw;",
     "vec4(both[0], both[1])"},
    {"matrix", "out mat2 both;", "in mat2 both;", "both = mat2(c.xy, c.zw);", "vec4(both[0], both[1])"},
    {"block", "out Both { vec2 a; vec2 b; } both;", "in Both { vec2 a; vec2 b; } both;",
     "both.a = c.xy; both.b = c.zw;", "vec4(both.a, both.b)"},
    {"array_of_blocks", "out Half { vec2 a; } halves[2];", "in Half { vec2 a; } halves[2];",
     "halves[0].a = c.xy; halves[1].a = c.zw;", "vec4(halves[0].a, halves[1].a)", desktop_apis},
    {"block_without_name", "out Both { vec2 first_half; vec2 second_half; };",
     "in Both { vec2 first_half; vec2 second_half; };", "first_half = c.xy; second_half = c.zw;",
     "vec4(first_half, second_half)"},
};

struct OutputWay {
  const char* leaf;
  GLenum refinement;
  bool is_morphed;
};
constexpr OutputWay output_ways[] = {{"inputs", GL_LINEAR_INPUTS_ARK, false},
                                     {"outputs", GL_LINEAR_OUTPUTS_ARK, false},
                                     {"inputs_morphed", GL_LINEAR_INPUTS_ARK, true},
                                     {"outputs_morphed", GL_LINEAR_OUTPUTS_ARK, true}};

void refine_in(const OutputWay& way) {
  refine_by_tags(3, way.refinement);
  gl.ARKParameteriARK(GL_GEOMORPH_ARK, way.is_morphed ? GL_TRUE : GL_FALSE);
}

void expect_same_as_unrefined(Test& t, const OutputWay& way) {
  upload(one_triangle({1, 3, 2}));
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  const Picture plain = picture_of(draw);
  t.expect(count_different(plain, Picture(surface_size, surface_size), 8) > 200, "the unrefined triangle shows");
  refine_in(way);
  for (int again = 0; again < 2; ++again) t.expect_same_picture(picture_of(draw), plain, way.leaf, 3, 40);
  t.expect_no_error("the draws");
}

void check_grouped(Test& t, const GroupedOutput& output, const OutputWay& way) {
  gl.UseProgram(build_program(
      t,
      {.vertex = std::string("layout(location = 0) in vec4 position; layout(location = 3) in vec4 colour;\n") +
                 output.output + "\nvoid main() { vec4 c = colour; " + output.assigned + " gl_Position = position; }",
       .fragment = std::string(output.input) + "\nout vec4 pixel; void main() { pixel = " + output.read + "; }"}));
  expect_same_as_unrefined(t, way);
}

// The vertex shaders of a program: each is a text of its own.
struct SharedOutputs {
  const char* leaf;
  std::vector<const char*> texts;
};
const std::vector<SharedOutputs>& shared_outputs() {
  static const std::vector<SharedOutputs> all = {
      {"second_writes",
       {"in vec4 position; in vec4 colour; void shade(vec4 c); void main() { shade(colour); gl_Position = position; }",
        "out vec4 hue; void shade(vec4 c) { hue = c; }"}},
      {"both_write",
       {"in vec4 position; in vec4 colour; out vec4 hue; void shade(vec4 c);"
        "void main() { hue = colour * 0.5; shade(colour); gl_Position = position; }",
        "out vec4 hue; void shade(vec4 c) { hue += c * 0.5; }"}},
      {"second_reads",
       {"in vec4 position; void shade(); void main() { shade(); gl_Position = position; }",
        "in vec4 colour; out vec4 hue; void shade() { hue = colour; }"}},
      {"position_in_second",
       {"in vec4 colour; out vec4 hue; void place(); void main() { hue = colour; place(); }",
        "in vec4 position; void place() { gl_Position = position; }"}},
      {"three",
       {"void place(); void shade(); void main() { place(); shade(); }",
        "in vec4 position; void place() { gl_Position = position; }",
        "in vec4 colour; out vec4 hue; float half_of(float x) { return 0.5 * x; }"
        "void shade() { hue = vec4(half_of(colour.r), half_of(colour.g), colour.b, 1.0); }"}},
      {"own_globals",
       {"in vec4 position; in vec4 colour; float factor; out vec4 hue; void shade(vec4 c);"
        "void main() { factor = 0.5; shade(colour); hue *= factor; gl_Position = position; }",
        "out vec4 hue; vec4 kept; void shade(vec4 c) { kept = c; hue = kept + c; }"}},
  };
  return all;
}

GLuint compiled_text(Test& t, GLenum stage, const std::string& body) {
  const std::string source = glsl_head(t) + body;
  const char* text = source.c_str();
  const GLuint shader = gl.CreateShader(stage);
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  return shader;
}

void check_shared(Test& t, const SharedOutputs& shared, const OutputWay& way) {
  const GLuint program = gl.CreateProgram();
  for (const char* const text : shared.texts) gl.AttachShader(program, compiled_text(t, GL_VERTEX_SHADER, text));
  gl.AttachShader(program, compiled_text(t, GL_FRAGMENT_SHADER,
                                         "in vec4 hue; out vec4 pixel; void main() { pixel = vec4(hue.rgb, 1.0); }"));
  gl.BindAttribLocation(program, at_position, "position");
  gl.BindAttribLocation(program, at_colour, "colour");
  gl.LinkProgram(program);
  GLint is_linked = 0;
  gl.GetProgramiv(program, GL_LINK_STATUS, &is_linked);
  t.require(is_linked != 0, "GL links several vertex shaders");
  gl.UseProgram(program);
  expect_same_as_unrefined(t, way);
}

}  // namespace

Cases grouped_outputs_cases() {
  Cases cases;
  for (const OutputWay& way : output_ways) {
    for (const GroupedOutput& output : grouped_outputs)
      cases.push_back({.name = std::string("ark.linear.grouped.") + output.leaf + "." + way.leaf,
                       .clauses = {"11.R.6-1", "10.R.2-1"},
                       .plan = "The colour is in a structure, an array or a block. The picture is the unrefined one.",
                       .wrong = "A member keeps the value of one corner, or the program is not derived.",
                       .apis = output.apis,
                       .check = [&output, &way](Test& t) { check_grouped(t, output, way); }});
    for (const SharedOutputs& shared : shared_outputs())
      cases.push_back(
          {.name = std::string("ark.linear.shaders.") + shared.leaf + "." + way.leaf,
           .clauses = {"11.R.6-1", "10.R.2-1"},
           .plan = "Several vertex shaders of a program share inputs, outputs and functions.",
           .wrong = "Only the shader with main is refined; or a global of the same name is another variable.",
           .apis = desktop_apis,
           .check = [&shared, &way](Test& t) { check_shared(t, shared, way); }});
  }
  return cases;
}

}  // namespace glark::conformance
