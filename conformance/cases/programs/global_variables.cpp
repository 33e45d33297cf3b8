// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Global variables of the vertex stage that main() changes. Each execution begins with the values of their declarations
// (GLSL 4.30, 4.3), also where an implementation executes the application's main() several times in one invocation.
#include <fmt/core.h>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/expect_change.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

// `value` is 0.25 in each execution that begins with the declared values. A second execution that goes on with the
// values of the first one gives at least 0.5, or less than 0.
struct Global {
  const char* leaf;
  const char* declarations;
  const char* statements;  // in main()
  const char* value;       // a float
  Apis apis = every_api;
};

constexpr Global globals[] = {
    {"float", "float sum = 0.125;", "sum += 0.125;", "sum"},
    {"float_of_several", "float one = 0.0, sum = 0.125, two = 0.0;", "one += 0.25; sum += 0.125; two -= 0.25;",
     "sum + one + two"},
    {"last_of_several", "float unused, zero = 0.0, sum = 0.0;", "sum += 0.25; unused = zero;", "sum + unused"},
    {"product", "float factor = 0.125;", "factor *= 2.0;", "factor"},
    {"increment", "int calls = 0;", "++calls;", "0.25 * float(calls)"},
    {"increment_after", "int calls = 0;", "calls++;", "0.25 * float(calls)"},
    {"decrement", "int left = 2;", "--left;", "0.25 * float(left)"},
    {"unsigned", "uint bits = 1u;", "bits <<= 1u;", "0.125 * float(bits)"},
    {"flag", "bool is_first = true;", "float seen = is_first ? 0.25 : 1.0; is_first = false;", "seen"},
    {"flag_of_function",
     "bool is_done;\nfloat once() { float now = is_done ? 1.0 : 0.25; is_done = true; return now; }",
     "is_done = false; float got = once();", "got"},
    {"vector", "vec3 sum = vec3(0.0, 0.125, 0.0);", "sum += vec3(0.0, 0.125, 0.5);", "sum.y"},
    {"component", "vec4 sum = vec4(0.0);", "sum.w += 0.25;", "sum.w"},
    {"integer_vector", "ivec2 counts = ivec2(0, 3);", "counts += ivec2(1, 2);",
     "0.25 * float(counts.x + counts.y - 5)"},
    {"matrix", "mat2 turn = mat2(0.5);", "turn *= mat2(0.5);", "turn[1][1]"},
    {"column", "mat3 turn = mat3(0.125);", "turn[2] += vec3(0.0, 0.0, 0.125);", "turn[2].z"},
    {"array", "float sums[3] = float[3](0.0, 0.125, 0.0);", "for (int i = 0; i < 3; ++i) { sums[i] += 0.125; }",
     "sums[1]"},
    {"array_of_unsized", "float sums[] = float[](0.125, 0.0);", "sums[0] += 0.125;", "sums[0]"},
    {"array_before_name", "float[2] sums = float[2](0.125, 0.0);", "sums[0] += 0.125;", "sums[0]"},
    {"array_of_several", "float sums[2] = float[2](0.0, 0.0), sum = 0.125;", "sums[1] += 0.125; sum += 0.0;",
     "sum + sums[1]"},
    {"vectors_in_array", "vec2 sums[2] = vec2[2](vec2(0.0), vec2(0.125));", "sums[1].y += 0.125;", "sums[1].y"},
    {"structure", "struct State { float sum; int calls; };\nState state = State(0.125, 0);",
     "state.sum += 0.125; state.calls++;", "state.sum + 0.25 * float(state.calls - 1)"},
    {"structure_in_place", "struct State { float sum; } state = State(0.0);", "state.sum += 0.25;", "state.sum"},
    {"nested_structure",
     "struct Inner { vec2 sum; };\nstruct Outer { Inner inner; };\nOuter outer = Outer(Inner(vec2(0.0)));",
     "outer.inner.sum.x += 0.25;", "outer.inner.sum.x"},
    {"in_function", "float sum = 0.0;\nvoid add(float more) { sum += more; }", "add(0.125); add(0.125);", "sum"},
    {"argument", "float sum = 0.0;\nvoid add(inout float to, float more) { to += more; }", "add(sum, 0.25);", "sum"},
    {"argument_out", "float sum = 0.125;\nvoid twice(float from, out float to) { to = 2.0 * from; }",
     "twice(sum, sum);", "sum"},
    {"between_functions", "void add();\nfloat sum = 0.0;\nvoid add() { sum += 0.25; }", "add();", "sum"},
    {"two_functions", "float sum = 0.0;\nfloat get() { return sum; }\nvoid add() { sum = get() + 0.25; }", "add();",
     "get()"},
    {"constant_expression", "const float start = 0.0625;\nfloat sum = start * 2.0;", "sum += start * 2.0;", "sum"},
    {"of_constant_array", "const float starts[2] = float[2](0.0, 0.125);\nfloat sum = starts[1];", "sum += starts[1];",
     "sum"},
    {"function_of_constant", "float sum = max(0.125, -1.0);", "sum += 0.125;", "sum"},
    {"precision", "highp float sum = 0.125;\nmediump int calls = 0;", "sum += 0.125; calls += 1;",
     "sum + 0.25 * float(calls - 1)"},
    {"negative", "float sum = -0.25;", "sum += 0.5;", "sum"},
    {"macro", "#define ACCUMULATED(name) float name = 0.0\nACCUMULATED(sum);", "sum += 0.25;", "sum"},
    {"conditional", "#if 1\nfloat sum = 0.0;\n#else\nfloat sum = 9.0;\n#endif", "sum += 0.25;", "sum"},
    {"comments", "float /* of = all */ sum = /* from */ 0.0; // sum = 1.0;", "sum += 0.25;", "sum"},
    {"name_of_main", "float mainly = 0.0;", "mainly += 0.25;", "mainly"},
    {"shadowed", "float sum = 0.0;", "{ float sum = 7.0; sum += 1.0; }\n  sum += 0.25;", "sum"},
    {"early_return", "float sum = 0.0;\nvoid add() { if (sum > 0.2) { sum = 1.0; return; } sum += 0.25; }", "add();",
     "sum"},
    {"loop", "int at = 0;", "while (at < 8) { at += 3; }\n  float found = at == 9 ? 0.25 : 1.0; at = 5;", "found"},
    {"swap", "float one = 0.25;\nfloat two = 0.75;", "float now = one; one = two; two = now;", "now"},
    {"double", "double sum = 0.125lf;", "sum += 0.125lf;", "float(sum)", desktop_apis},
    {"list_in_braces", "float sums[2] = {0.0, 0.125};", "sums[1] += 0.125;", "sums[1]", desktop_apis},
    {"old_style", "float sum = 0.0;", "sum += 0.25 + 0.0 * gl_Normal.x;", "sum", compat_only},
};

// The stage gives the global's value to smooth and flat outputs, and places the triangle by it.
std::string text_of(const Global& global) {
  return fmt::format(
      "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
      "layout(location = 3) in vec4 vertex_colour; layout(location = 4) in vec2 texcoord;\n"
      "{}\nout vec4 colour; flat out vec4 even; flat out int steps;\n"
      "void main() {{\n  {}\n  float value = {};\n"
      "  colour = vec4(0.5 * vertex_colour.rg + vec2(value), 0.2 + 0.001 * (normal.z + texcoord.x), 1.0);\n"
      "  even = vec4(0.0, 0.0, value, 1.0); steps = int(8.0 * value);\n"
      "  gl_Position = vec4(position.x + value, position.y - value, position.zw);\n}}\n",
      global.declarations, global.statements, global.value);
}

constexpr char fragment[] =
    "in vec4 colour; flat in vec4 even; flat in int steps; out vec4 pixel;\n"
    "void main() { pixel = vec4(colour.rg, colour.b + even.b + 0.125 * float(steps), 1.0); }";

// A way to refine that leaves flat triangles where they are.
struct Way {
  const char* name;
  void (*set)();
};

void displace_by_nothing() {
  const GLubyte heights[4] = {0, 0, 0, 0};
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.ActiveTexture(GL_TEXTURE1);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, heights);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 1);
}

void measure(GLenum refinement, GLenum parameter) {
  refine_by_tags(4, refinement);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  if (parameter == GL_SCREEN_ERROR_ARK)
    gl.ARKParameterfARK(GL_SCREEN_ERROR_ARK, 0.05F);
  else
    gl.ARKParameteriARK(parameter, 9);
}

constexpr Way ways[] = {
    {"inputs at a uniform depth", [] { refine_uniformly(2, GL_LINEAR_INPUTS_ARK); }},
    {"inputs at tags", [] { refine_by_tags(3, GL_LINEAR_INPUTS_ARK); }},
    {"outputs at a uniform depth", [] { refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK); }},
    {"outputs at tags", [] { refine_by_tags(3, GL_LINEAR_OUTPUTS_ARK); }},
    {"outputs at depth 0", [] { refine_uniformly(0, GL_LINEAR_OUTPUTS_ARK); }},
    {"curved triangles", [] { refine_uniformly(2, GL_CURVED_PN_ARK); }},
    {"Phong tessellation", [] { refine_by_tags(3, GL_PHONG_ARK); }},
    {"displaced inputs",
     [] {
       refine_uniformly(2, GL_LINEAR_INPUTS_ARK);
       displace_by_nothing();
     }},
    {"displaced curved triangles",
     [] {
       refine_by_tags(3, GL_CURVED_PN_ARK);
       displace_by_nothing();
     }},
    {"geomorphing inputs",
     [] {
       refine_by_tags(3, GL_LINEAR_INPUTS_ARK);
       gl.ARKParameteriARK(GL_GEOMORPH_ARK, GL_TRUE);
     }},
    {"geomorphing outputs",
     [] {
       refine_by_tags(3, GL_LINEAR_OUTPUTS_ARK);
       gl.ARKParameteriARK(GL_GEOMORPH_ARK, GL_TRUE);
     }},
    {"geomorphing curved triangles",
     [] {
       refine_by_tags(3, GL_CURVED_PN_ARK);
       gl.ARKParameteriARK(GL_GEOMORPH_ARK, GL_TRUE);
     }},
    {"welded curved triangles",
     [] {
       refine_uniformly(2, GL_CURVED_PN_ARK);
       gl.ARKParameteriARK(GL_WELD_ARK, GL_TRUE);
     }},
    {"measured inputs", [] { measure(GL_LINEAR_INPUTS_ARK, GL_EDGE_PIXELS_ARK); }},
    {"measured outputs", [] { measure(GL_LINEAR_OUTPUTS_ARK, GL_EDGE_PIXELS_ARK); }},
    {"curved triangles by the error on the screen", [] { measure(GL_CURVED_PN_ARK, GL_SCREEN_ERROR_ARK); }},
};

void reset_parameters() {
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, -1);
  gl.ARKParameteriARK(GL_GEOMORPH_ARK, GL_FALSE);
  gl.ARKParameteriARK(GL_WELD_ARK, GL_FALSE);
  gl.ARKParameterfARK(GL_SCREEN_ERROR_ARK, 0);
}

void draw_one() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

Mesh mesh_of_globals() {
  Mesh mesh = one_triangle({1.25F, 2.5F, 2.25F});  // geomorphing morphs between whole depths
  for (MeshVertex& vertex : mesh)
    for (std::size_t k = 0; k < 2; ++k) vertex.position[k] *= 0.9F;
  return mesh;
}

void check_global(Test& t, const Global& global) {
  gl.UseProgram(build_program(t, {.vertex = text_of(global), .fragment = fragment}));
  upload(mesh_of_globals());
  gl.ARKinit(4);
  const Picture plain = picture_of(draw_one);
  const auto middle = plain.at(surface_size / 2 + 12, surface_size / 2 - 24);
  t.expect(middle[2] > 160 && middle[2] < 200, "the value of the unrefined draw is a quarter");
  for (const Way& way : ways) {
    reset_parameters();
    way.set();
    t.expect_same_picture(expect_as_unrefined(t, draw_one, way.name), plain, "the unrefined draw", 0, 0);
  }
  t.expect_no_error("the draws");
}

// The values that are captured are those of the declarations, whatever was executed before.
struct GlobalVertex {
  Vec4 position;
  float value;
};

void check_captured(Test& t, const Global& global) {
  const std::string text = fmt::format(
      "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
      "{}\nout float value_out; out vec4 colour;\n"
      "void main() {{\n  {}\n  value_out = {};\n  colour = vec4(normal, 1.0); gl_Position = position;\n}}\n",
      global.declarations, global.statements, global.value);
  gl.UseProgram(build_program(t, {.vertex = text, .captured = {"gl_Position", "value_out"}}));
  upload(mesh_of_globals());
  gl.ARKinit(4);
  for (const Way& way : ways) {
    reset_parameters();
    way.set();
    for (int again = 0; again < 3; ++again) {
      const auto vertices = capture_as<GlobalVertex>(t, 4000, draw_one);
      t.expect(!vertices.empty(), std::string("something is captured with ") + way.name);
      for (const GlobalVertex& vertex : vertices)
        if (!t.expect_near(vertex.value, 0.25, 1e-6, std::string("the value with ") + way.name)) return;
    }
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases global_variables_cases() {
  Cases cases;
  const char* const wrong = "A vertex goes on with the values that another execution of main() has left.";
  for (const Global& global : globals) {
    const std::string plan =
        fmt::format("The vertex stage declares '{}' and changes it in main(). Refine it in every way", global.leaf);
    cases.push_back({.name = fmt::format("ark.program.globals.{}", global.leaf),
                     .clauses = {"11.R.6-4", "11.R.6-8", "11.R.6-12"},
                     .plan = plan + " that leaves flat triangles where they are, and compare with the unrefined draw.",
                     .wrong = wrong,
                     .apis = global.apis,
                     .check = [&global](Test& t) { check_global(t, global); }});
    cases.push_back({.name = fmt::format("ark.program.globals.{}.captured", global.leaf),
                     .clauses = {"11.R.6-4", "11.R.6-8"},
                     .plan = plan + ", and capture its value at all vertices.",
                     .wrong = wrong,
                     .apis = global.apis,
                     .check = [&global](Test& t) { check_captured(t, global); }});
  }
  return cases;
}

}  // namespace glark::conformance
