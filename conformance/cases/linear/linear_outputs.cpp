// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Refined outputs, and values that are constant within a coarse triangle (11.R.6).
#include <fmt/core.h>
#include <cmath>

#include "conformance/cases/cases.h"
#include "conformance/reference/refinement.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

// gl_Position, weights, then the floats under test.
constexpr std::size_t most_floats = 20;
struct OutputVertex {
  Vec4 position;
  Vec3 weights;
  std::array<float, most_floats> r;
};

// The corners' outputs are far from linear in the inputs, and exact: the inputs are multiples of 1/4 below 4.
struct OutputKind {
  const char* leaf;
  const char* declarations;
  const char* statements;
  std::vector<const char*> captured;  // as many floats as `count`
  std::size_t count;
  Apis apis = every_api;
};

const OutputKind output_kinds[] = {
    {"vec4", "out vec4 r;", "r = a * a;", {"r"}, 4},
    {"centroid", "centroid out vec4 r;", "r = a * a;", {"r"}, 4},
    {"matrix", "out mat2 r;", "r = mat2(a.xy * a.yz, a.zw * a.wx);", {"r"}, 4},
    {"array", "out float r[4];", "for (int i = 0; i < 4; ++i) r[i] = a[i] * a[0];", {"r"}, 4},
    {"long_array", "out float r[20];", "for (int i = 0; i < 20; ++i) r[i] = a[i % 4] * a[0] + float(i);", {"r"}, 20},
    {"structure",
     "struct S { vec3 n; float m; }; out S r;",
     "r.n = a.xyz * a.yzw; r.m = a.w * a.w;",
     {"r.n", "r.m"},
     4},
    {"block", "out Block { vec3 n; float m; } r;", "r.n = a.xyz * a.yzw; r.m = a.w * a.w;", {"Block.n", "Block.m"}, 4},
    {"point_size", "", "gl_PointSize = a.x * a.x + 1.0;", {"gl_PointSize"}, 1, desktop_apis},
    {"clip_distance",
     "out float gl_ClipDistance[3];",
     "gl_ClipDistance[0] = a.x * a.x; gl_ClipDistance[1] = a.y * a.x; gl_ClipDistance[2] = a.z * a.z;",
     {"gl_ClipDistance"},
     3,
     desktop_apis},
};

GLuint output_program(Test& t, const std::string& declarations, const std::string& statements,
                      const std::vector<const char*>& captured) {
  std::vector<const char*> names = {"gl_Position", "weights_out"};
  names.insert(names.end(), captured.begin(), captured.end());
  return build_program(t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 3) in vec4 a;\n"
                                     "layout(location = 2) in vec3 weights; out vec3 weights_out; out vec4 colour;\n" +
                                     declarations + "\nvoid main() { " + statements +
                                     "\n  weights_out = weights; colour = a;\n"
                                     "  gl_Position = vec4(position.xyz * position.w, position.w); }\n",
                           .captured = names});
}

Mesh exact_triangle() {
  Mesh mesh = one_triangle({4, 2, 1});
  mesh[0].colour = {0.25F, 1.5F, 2, 3.75F};
  mesh[1].colour = {3, 0.75F, 1.25F, 0.5F};
  mesh[2].colour = {1.75F, 2.5F, 0.5F, 1};
  mesh[0].position[3] = 1;
  mesh[1].position[3] = 2;
  mesh[2].position[3] = 0.5F;
  return mesh;
}

// The `count` floats of each corner without refinement.
std::vector<OutputVertex> captured(Test& t, std::size_t count, const std::function<void()>& draw) {
  const std::size_t stride = 7 + count;
  const auto bytes = capture_bytes(t, stride * sizeof(float), 3, 4000, GL_TRIANGLES, draw);
  std::vector<OutputVertex> vertices(bytes.size() / (stride * sizeof(float)));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    std::memcpy(&vertices[i], bytes.data() + i * stride * sizeof(float), stride * sizeof(float));
  return vertices;
}

void draw_triangle() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

void check_output(Test& t, const OutputKind& kind) {
  const GLuint program = output_program(t, kind.declarations, kind.statements, kind.captured);
  gl.UseProgram(program);
  upload(exact_triangle());
  const auto corners = captured(t, kind.count, draw_triangle);
  t.require(corners.size() == 3, "the unrefined triangle is captured");
  refine_by_tags(4, GL_LINEAR_OUTPUTS_ARK);
  require_refinable(t, program);
  const auto vertices = captured(t, kind.count, draw_triangle);
  t.require(vertices.size() > 3, "the triangle is refined");
  for (const OutputVertex& vertex : vertices) {
    bool holds = true;
    for (std::size_t i = 0; i < kind.count; ++i)
      holds =
          holds && vertex.r[i] == reference::refined(vertex.weights, corners[0].r[i], corners[1].r[i], corners[2].r[i]);
    for (std::size_t i = 0; i < 4; ++i)
      holds = holds && vertex.position[i] == reference::refined(vertex.weights, corners[0].position[i],
                                                                corners[1].position[i], corners[2].position[i]);
    if (!t.expect(holds, "outputs are those of the corners, refined by (11.R.1)")) return;
  }
}

Case output_case(const OutputKind& kind) {
  return {.name = std::string("ark.linear.outputs.") + kind.leaf,
          .clauses = {"11.R.6-8", "11.R.6-9"},
          .plan =
              "A vertex stage squares its inputs. Capture the unrefined corners, refine outputs by tags 4, 2, 1, and "
              "compare gl_Position and this output with (11.R.1) of the corners' outputs.",
          .wrong = "Squares of refined inputs; only the first element or member is refined; this output is left out.",
          .apis = kind.apis,
          .check = [kind](Test& t) { check_output(t, kind); }};
}

void check_executed_again(Test& t) {
  const GLuint program = output_program(t, "out vec4 r;", "r = a * a;", {"r"});
  gl.UseProgram(program);
  const Mesh mesh = exact_triangle();
  upload(mesh);
  refine_by_tags(4);
  for (const OutputVertex& vertex : captured(t, 4, draw_triangle))
    for (std::size_t i = 0; i < 4; ++i) {
      const float a = reference::refined(vertex.weights, mesh[0].colour[i], mesh[1].colour[i], mesh[2].colour[i]);
      t.expect_near(vertex.r[i], a * a, 1e-6, "the square of the refined input");
    }
}

// A compiler may drop an input from an expression that it finds to be 0. The value in its place must not be NaN.
void check_removed_input(Test& t, GLenum refinement) {
  const GLuint program = build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 3) in vec4 a;\n"
                    "layout(location = 1) in vec3 normal; layout(location = 2) in vec3 weights;\n"
                    "out vec3 weights_out; out vec4 r; out vec4 colour;\n"
                    "void main() { r = a + vec4(normal.z - normal.z); weights_out = weights; colour = a;\n"
                    "  gl_Position = position * (1.0 + (normal.x - normal.x)); }\n",
          .captured = {"gl_Position", "weights_out", "r"}});
  gl.UseProgram(program);
  upload(exact_triangle());
  const auto corners = captured(t, 4, draw_triangle);
  t.require(corners.size() == 3, "the unrefined triangle is captured");
  refine_by_tags(4, refinement);
  const auto vertices = captured(t, 4, draw_triangle);
  t.require(vertices.size() > 3, "the triangle is refined");
  for (const OutputVertex& vertex : vertices) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto refined = [&](float x, float y, float z) { return reference::refined(vertex.weights, x, y, z); };
      const bool holds =
          t.expect_near(vertex.r[i], refined(corners[0].r[i], corners[1].r[i], corners[2].r[i]), 1e-6, "the output") &&
          t.expect_near(vertex.position[i],
                        refined(corners[0].position[i], corners[1].position[i], corners[2].position[i]), 1e-6,
                        "gl_Position");
      if (!holds) return;
    }
  }
}

void check_noperspective(Test& t) {
  const GLuint program = output_program(t, "noperspective out vec4 r;", "r = a;", {"r"});
  gl.UseProgram(program);
  const Mesh mesh = exact_triangle();
  upload(mesh);
  refine_by_tags(4, GL_LINEAR_OUTPUTS_ARK);
  const auto vertices = captured(t, 4, draw_triangle);
  t.require(vertices.size() > 3, "the triangle is refined");
  for (const OutputVertex& vertex : vertices) {
    double weights[3];
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
      sum += weights[i] = static_cast<double>(vertex.weights[i]) * mesh[i].position[3];
    for (std::size_t i = 0; i < 4; ++i) {
      const double expected =
          (weights[0] * mesh[0].colour[i] + weights[1] * mesh[1].colour[i] + weights[2] * mesh[2].colour[i]) / sum;
      if (!t.expect_near(vertex.r[i], expected, 2e-6, "linear in window coordinates")) return;
    }
  }
}

struct DrawForm {
  const char* leaf;
  GLenum mode;
  GLsizei count;
  std::array<int, 3> last;   // the provoking vertex of triangles 0, 1, 2 under LAST_VERTEX_CONVENTION
  std::array<int, 3> first;  // under FIRST_VERTEX_CONVENTION
  bool is_compat = false;
};

// Based on: table 13.2 of OpenGL 4.6.
const DrawForm draw_forms[] = {
    {"triangles", GL_TRIANGLES, 9, {2, 5, 8}, {0, 3, 6}},
    {"triangle_strip", GL_TRIANGLE_STRIP, 5, {2, 3, 4}, {0, 1, 2}},
    {"triangle_fan", GL_TRIANGLE_FAN, 5, {2, 3, 4}, {1, 2, 3}},
};

Mesh many_vertices() {
  Mesh mesh(9);
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const auto k = static_cast<float>(i);
    mesh[i].position = {std::cos(2 * k), std::sin(3 * k + 0.5F), 0.1F * k, 1};
    mesh[i].triangle = 10 * k + 1;
    mesh[i].colour = {k / 9, 1 - k / 9, k * k / 81, 1};
  }
  return mesh;
}

struct ProvokedVertex {
  GLint integer[2];
  GLuint natural;
  Vec4 flat;
};

struct Provoking {
  const char* leaf;
  std::string declarations;
  std::string statements;
  GLenum refinement;
  std::vector<std::string> clauses;
  const char* wrong;
};

// i: integer inputs; flat: a flat output that comes from a float input.
const Provoking provoking_kinds[] = {
    {"integer_input",
     "flat out vec4 f;",
     "i_out = i; u_out = u; f = vec4(0.0);",
     GL_LINEAR_INPUTS_ARK,
     {"11.R.6-7"},
     "Always corner 0, or interpolated integers."},
    {"integer_input_nonflat",
     "out vec4 f;",
     "i_out = i; u_out = u; f = vec4(i.xyxy);",
     GL_LINEAR_INPUTS_ARK,
     {"11.R.6-7"},
     "A float made from an integer input varies within the triangle."},
    {"flat_output",
     "flat out vec4 f;",
     "i_out = i; u_out = u; f = c * c;",
     GL_LINEAR_INPUTS_ARK,
     {"11.R.6-12"},
     "A flat output of the refined triangle's own corner: facets appear."},
    {"outputs",
     "flat out vec4 f;",
     "i_out = i; u_out = u; f = c * c;",
     GL_LINEAR_OUTPUTS_ARK,
     {"11.R.6-10"},
     "Interpolated flat outputs; the wrong convention."},
};

void upload_integers(const Mesh& mesh) {
  std::vector<std::array<GLint, 3>> values;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const auto k = static_cast<GLint>(i);
    values.push_back({100 - 7 * k, 0x7ffffff0 + k, static_cast<GLint>(0x80000001U + i)});
  }
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * 12), values.data(), GL_STATIC_DRAW);
  gl.VertexAttribIPointer(7, 2, GL_INT, 12, nullptr);
  gl.VertexAttribIPointer(8, 1, GL_UNSIGNED_INT, 12, reinterpret_cast<const void*>(std::size_t{8}));
  gl.EnableVertexAttribArray(7);
  gl.EnableVertexAttribArray(8);
}

void check_provoking(Test& t, const DrawForm& form, const Provoking& kind, bool is_first) {
  gl.UseProgram(build_program(t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 3) in vec4 c;\n"
                                            "layout(location = 7) in ivec2 i; layout(location = 8) in uint u;\n"
                                            "flat out ivec2 i_out; flat out uint u_out; out vec4 colour;\n" +
                                            kind.declarations + "\nvoid main() { " + kind.statements +
                                            "\n  colour = c; gl_Position = position; }\n",
                                  .captured = {"i_out", "u_out", "f"}}));
  const Mesh mesh = many_vertices();
  upload(mesh);
  upload_integers(mesh);
  if (is_first) gl.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
  refine_uniformly(2, kind.refinement);
  const auto vertices = capture_as<ProvokedVertex>(t, 4000, [&] { gl.DrawArrays(form.mode, 0, form.count); });
  t.require(vertices.size() == 3U * 3 * 16, "three triangles are refined to 16 each");
  const bool is_colour = kind.statements.find("c * c") != std::string::npos;
  const bool is_integer = kind.statements.find("i.xyxy") != std::string::npos;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const std::size_t triangle = k / 48;
    const auto from = static_cast<std::size_t>((is_first ? form.first : form.last)[triangle]);
    const GLint expected = 100 - 7 * static_cast<GLint>(from);
    bool holds = vertices[k].integer[0] == expected &&
                 vertices[k].integer[1] == 0x7ffffff0 + static_cast<GLint>(from) &&
                 vertices[k].natural == 0x80000001U + from;
    for (std::size_t i = 0; i < 4; ++i) {
      const float c = mesh[from].colour[i];
      if (is_colour) holds = holds && std::abs(vertices[k].flat[i] - c * c) < 1e-6F;
      if (is_integer && i % 2 == 0) holds = holds && vertices[k].flat[i] == static_cast<float>(expected);
    }
    if (!t.expect(holds, fmt::format("triangle {} has the values of vertex {}", triangle, from))) return;
  }
}

Case provoking_case(const DrawForm& form, const Provoking& kind, bool is_first) {
  return {.name = std::string("ark.linear.provoking.") + kind.leaf + "." + form.leaf + (is_first ? ".first" : ".last"),
          .clauses = kind.clauses,
          .plan =
              "Draw vertices with different integers and colours in this mode under this convention, at depth 2. The "
              "captured values of every refined triangle are those of its coarse triangle's provoking vertex.",
          .wrong = kind.wrong,
          .apis = is_first ? desktop_apis : every_api,
          .check = [form, kind, is_first](Test& t) { check_provoking(t, form, kind, is_first); }};
}

// Integers within outputs that are not flat: the rest of the output is refined, they are not.
struct IntegerMembers {
  const char* leaf;
  const char* declarations;
  const char* statements;  // give `i` and `u` to the members
  std::vector<const char*> captured;
};

const IntegerMembers integer_members[] = {
    {"variables",
     "out ivec2 i_out; out uint u_out; out vec4 f;",
     "i_out = i; u_out = u; f = c;",
     {"i_out", "u_out", "f"}},
    {"structure",
     "struct S { ivec2 i; uint u; vec4 f; }; out S s;",
     "s.i = i; s.u = u; s.f = c;",
     {"s.i", "s.u", "s.f"}},
    {"nested",
     "struct N { vec2 unused; ivec2 i; }; struct S { uint u; N n; vec4 f; }; out S s;",
     "s.n.unused = c.xy; s.n.i = i; s.u = u; s.f = c;",
     {"s.n.i", "s.u", "s.f"}},
    {"structures",
     "struct S { int i[2]; uint u; vec4 f; }; out S s[2];",
     "for (int k = 0; k < 2; ++k) { s[k].i[0] = i.x; s[k].i[1] = i.y; s[k].u = u; s[k].f = c; }",
     {"s[1].i", "s[1].u", "s[0].f"}},
    {"array",
     "out ivec2 i_out[2]; out uint u_out[20]; out vec4 f;",
     "for (int k = 0; k < 20; ++k) { i_out[k % 2] = i; u_out[k] = u; } f = c;",
     {"i_out[1]", "u_out[19]", "f"}},
    {"block",
     "out Block { ivec2 i; vec4 f; uint u; } b;",
     "b.i = i; b.u = u; b.f = c;",
     {"Block.i", "Block.u", "Block.f"}},
};

struct IntegersVertex {
  GLint integer[2];
  GLuint natural;
  Vec4 refined;
};

void check_integer_members(Test& t, const IntegerMembers& kind, bool is_first) {
  const GLuint program = build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 3) in vec4 c;\n"
                    "layout(location = 7) in ivec2 i; layout(location = 8) in uint u; out vec4 colour;\n" +
                    std::string(kind.declarations) + "\nvoid main() { " + kind.statements +
                    "\n  colour = c; gl_Position = position; }\n",
          .captured = kind.captured});
  gl.UseProgram(program);
  const Mesh mesh = many_vertices();
  upload(mesh);
  upload_integers(mesh);
  gl.ProvokingVertex(is_first ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
  refine_uniformly(1, GL_LINEAR_OUTPUTS_ARK);
  require_refinable(t, program);
  for (const DrawForm& form : draw_forms) {
    const auto vertices = capture_as<IntegersVertex>(t, 4000, [&] { gl.DrawArrays(form.mode, 0, form.count); });
    t.require(vertices.size() == 3U * 3 * 4, "three triangles are refined to 4 each");
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      const std::size_t triangle = k / 12;
      const auto from = static_cast<std::size_t>((is_first ? form.first : form.last)[triangle]);
      const bool holds = vertices[k].integer[0] == 100 - 7 * static_cast<GLint>(from) &&
                         vertices[k].integer[1] == 0x7ffffff0 + static_cast<GLint>(from) &&
                         vertices[k].natural == 0x80000001U + from;
      if (!t.expect(holds, fmt::format("{}: triangle {} has the integers of vertex {}", form.leaf, triangle, from)))
        return;
    }
    t.expect(vertices[0].refined != vertices[1].refined, "the other members are refined");
  }
}

Case integer_members_case(const IntegerMembers& kind, bool is_first) {
  return {.name = std::string("ark.linear.integer_members.") + kind.leaf + (is_first ? ".first" : ".last"),
          .clauses = {"11.R.6-10"},
          .plan =
              "Outputs that are not flat have integer members. Draw triangles, a strip and a fan at depth 1 with "
              "LINEAR_OUTPUTS_ARK: these members are those of the provoking vertex.",
          .wrong = "Members have the value of another corner, or of the corner whose weight is greatest.",
          .apis = desktop_apis,
          .check = [kind, is_first](Test& t) { check_integer_members(t, kind, is_first); }};
}

}  // namespace

Cases linear_outputs_cases() {
  Cases cases;
  for (const OutputKind& kind : output_kinds) cases.push_back(output_case(kind));
  for (const DrawForm& form : draw_forms)
    for (const Provoking& kind : provoking_kinds)
      for (const bool is_first : {false, true}) cases.push_back(provoking_case(form, kind, is_first));
  for (const IntegerMembers& kind : integer_members)
    for (const bool is_first : {false, true}) cases.push_back(integer_members_case(kind, is_first));
  cases.push_back({.name = "ark.linear.inputs.executed_again",
                   .clauses = {"11.R.6-4", "overview-5"},
                   .plan = "A vertex stage squares its input: captured values are squares of refined inputs.",
                   .wrong = "Outputs are refined whatever REFINEMENT_ARK is.",
                   .check = check_executed_again});
  for (const bool of_outputs : {false, true})
    cases.push_back({.name = std::string("ark.linear.") + (of_outputs ? "outputs" : "inputs") + ".removed_input",
                     .clauses = {of_outputs ? "11.R.6-8" : "11.R.6-4"},
                     .plan = "A vertex stage adds normal.z - normal.z, and a compiler may remove this with the input. "
                             "Outputs are those of the corners, refined.",
                     .wrong = "The input is left without a value: outputs are NaN, or undefined.",
                     .check = [of_outputs](Test& t) {
                       check_removed_input(t, of_outputs ? GL_LINEAR_OUTPUTS_ARK : GL_LINEAR_INPUTS_ARK);
                     }});
  cases.push_back({.name = "ark.linear.outputs.noperspective",
                   .clauses = {"11.R.6-11"},
                   .plan = "Corners have w of 1, 2 and 1/2. A noperspective output is compared with the formula.",
                   .wrong = "The output is refined by (11.R.1), as if it were perspective.",
                   .apis = desktop_apis,
                   .check = check_noperspective});
  return cases;
}

}  // namespace glark::conformance
