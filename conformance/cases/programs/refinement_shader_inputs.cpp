// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The inputs that refine() reads and the variables that it may change, captured (11.R.9).
#include <algorithm>
#include <cstddef>
#include <map>
#include <tuple>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

using Captured = std::vector<CapturedVertex>;

// Two triangles without symmetry. No two coordinates are the same.
Mesh two_triangles() {
  Mesh mesh(6);
  const Vec4 positions[] = {{-0.75F, -0.625F, 0.25F, 1}, {0.5F, -0.5F, -0.25F, 1}, {-0.25F, 0.75F, 0.5F, 1},
                            {0.625F, 0.25F, 0.125F, 1},  {0.875F, 0.375F, 0, 1},   {0.125F, 0.5F, -0.375F, 1}};
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    mesh[i].position = positions[i];
    mesh[i].normal = {0.25F * float(i), 0.5F, 1};
    mesh[i].tag = float(i % 3);
  }
  number_triangles(mesh);
  return mesh;
}

void draw_two() { gl.DrawArrays(GL_TRIANGLES, 0, 6); }

GLuint set_up(Test& t, const std::string& refinement = {}) {
  const GLuint program = capture_program(t);
  gl.UseProgram(program);
  upload(two_triangles());
  gl.ARKinit(3);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK);
  gl.Enable(GL_ARK);
  if (!refinement.empty()) set_refinement_shader(t, program, refinement);
  return program;
}

void control(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(two_triangles(), false);
  const Captured vertices = capture(t, draw_two);
  t.require(vertices.size() == 6, "six vertices");
  const Mesh mesh = two_triangles();
  for (std::size_t i = 0; i < 6; ++i)
    t.expect(vertices[i].position == mesh[i].position && vertices[i].weights == mesh[i].weights, "vertices as given");
}

// Sorted by triangle and weights, so that comparisons do not depend on the order.
using Key = std::array<float, 4>;
std::multimap<Key, CapturedVertex> sorted(const Captured& vertices) {
  std::multimap<Key, CapturedVertex> all;
  for (const CapturedVertex& vertex : vertices)
    all.insert({{vertex.triangle, vertex.weights[0], vertex.weights[1], vertex.weights[2]}, vertex});
  return all;
}

bool same(const Captured& a, const Captured& b) {
  const auto first = sorted(a);
  const auto second = sorted(b);
  return std::equal(first.begin(), first.end(), second.begin(), second.end(), [](const auto& left, const auto& right) {
    return left.first == right.first && left.second.position == right.second.position;
  });
}

void check_barycentric(Test& t) {
  set_up(t);
  const Captured plain = capture(t, draw_two);
  t.require(plain.size() > 6, "the triangles are refined");
  const GLuint program = set_up(t, "void refine() { weights = ark_barycentric; }");
  t.expect(same(capture(t, draw_two), plain), "ark_barycentric is the refined (1, 0, 0), (0, 1, 0), (0, 0, 1)");
  set_refinement_shader(t, program, "void refine() { weights = ark_barycentric - weights; }");
  for (const CapturedVertex& vertex : capture(t, draw_two))
    t.expect(vertex.weights == Vec3{0, 0, 0}, "the difference of both is 0");
}

void check_corners(Test& t) {
  set_up(t,
         "void refine() { weights = vec3(ark_corner_position[0].x, ark_corner_position[1].y,"
         " ark_corner_position[2].z); }");
  const Mesh mesh = two_triangles();
  const Captured vertices = capture(t, draw_two);
  t.require(vertices.size() > 6, "the triangles are refined");
  for (const CapturedVertex& vertex : vertices) {
    const std::size_t first = vertex.triangle == 0 ? 0 : 3;
    t.expect(vertex.weights == Vec3{mesh[first].position[0], mesh[first + 1].position[1], mesh[first + 2].position[2]},
             "the corners of triangle " + as_text(vertex.triangle));
  }
}

void check_corners_of_indices(Test& t) {
  const GLuint program = set_up(t,
                                "void refine() { weights = vec3(ark_corner_position[0].x,"
                                " ark_corner_position[1].x, ark_corner_position[2].x); }");
  gl.UseProgram(program);
  const GLuint indices[] = {4, 1, 3, 2, 5, 0};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
  const Mesh mesh = two_triangles();
  std::size_t counts[2] = {};
  for (const CapturedVertex& vertex : capture(t, [] { gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, nullptr); }))
    for (std::size_t i = 0; i < 2; ++i)
      counts[i] += vertex.weights == Vec3{mesh[indices[3 * i]].position[0], mesh[indices[3 * i + 1]].position[0],
                                          mesh[indices[3 * i + 2]].position[0]};
  // Tags 1, 1, 0 and 2, 2, 0: edge depths 1, 0, 0 and 2, 1, 1.
  t.expect_equal(counts[0], 3U * 2U, "vertices with the corners 4, 1 and 3");
  t.expect_equal(counts[1], 3U * 6U, "vertices with the corners 2, 5 and 0");
}

void check_refined_value(Test& t) {
  set_up(t, "void refine() { weights = position.xyz; }");
  for (const CapturedVertex& vertex : capture(t, draw_two))
    t.expect(vertex.weights == Vec3{vertex.position[0], vertex.position[1], vertex.position[2]},
             "the input is the refined position");
}

void check_curved_value(Test& t) {
  const auto curved = [&](const std::string& refinement) {
    const GLuint program = build_program(
        t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
                      "layout(location = 2) in vec3 weights; layout(location = 6) in float triangle;\n"
                      "out vec3 weights_out; out float triangle_out; out vec4 colour;\n"
                      "void main() { weights_out = weights; triangle_out = triangle; colour = vec4(normal, 1.0);\n"
                      "  gl_Position = position; }\n",
            .captured = {"gl_Position", "weights_out", "triangle_out"}});
    gl.UseProgram(program);
    upload(two_triangles());
    gl.ARKinit(3);
    gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
    gl.Enable(GL_ARK);
    if (!refinement.empty()) set_refinement_shader(t, program, refinement);
    return capture(t, draw_two);
  };
  const Captured plain = curved("");
  t.expect(same(curved("void refine() { }"), plain), "a refinement shader that does nothing changes nothing");
  for (const CapturedVertex& vertex : curved("void refine() { weights = position.xyz; }"))
    t.expect(vertex.weights == Vec3{vertex.position[0], vertex.position[1], vertex.position[2]},
             "the input is the curved position");
  gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_INPUTS_ARK);
  t.expect(!same(capture(t, draw_two), plain), "CURVED_PN_ARK moves vertices of this mesh");
}

void check_written(Test& t) {
  set_up(t);
  Captured expected = capture(t, draw_two);
  for (CapturedVertex& vertex : expected) vertex.position = {vertex.position[0] + 1, 2 * vertex.position[1], 0.5F, 2};
  set_up(t, "void refine() { position = vec4(position.x + 1.0, 2.0 * position.y, 0.5, 2.0); }");
  t.expect(same(capture(t, draw_two), expected), "the vertex stage reads the values that refine left, applied once");
}

void check_input_of_another(Test& t) {
  set_up(t);
  Captured expected = capture(t, draw_two);
  for (CapturedVertex& vertex : expected) vertex.position[0] += vertex.weights[1];
  set_up(t, "void refine() { position.x += weights.y; }");
  t.expect(same(capture(t, draw_two), expected), "the refined weight moves the vertex");
}

void check_depth_zero(Test& t, bool is_uniform) {
  set_up(t, "void refine() { position.x += 1.0; }");
  upload(two_triangles(), false);
  if (is_uniform) gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  const Mesh mesh = two_triangles();
  const Captured vertices = capture(t, draw_two);
  t.require(vertices.size() == 6, "six vertices");
  for (const CapturedVertex& vertex : vertices)
    t.expect(std::any_of(mesh.begin(), mesh.end(),
                         [&](const MeshVertex& corner) { return vertex.position[0] == corner.position[0] + 1; }),
             "every vertex moves");
  gl.ARKinit(0);
  t.expect(capture(t, draw_two).front().position[0] == vertices.front().position[0], "the same with a pool of level 0");
}

// A vertex stage that is not linear shows whether inputs or outputs are refined.
Captured draw_squares(Test& t, GLenum refinement, bool has_shader) {
  const GLuint program =
      build_program(t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 2) in vec3 weights;\n"
                                  "layout(location = 6) in float triangle;\n"
                                  "out vec3 weights_out; out float triangle_out; out vec4 colour;\n"
                                  "void main() { weights_out = weights; triangle_out = triangle; colour = vec4(1.0);\n"
                                  "  gl_Position = vec4(position.xy * position.xy, position.zw); }\n",
                        .captured = {"gl_Position", "weights_out", "triangle_out"}});
  gl.UseProgram(program);
  upload(two_triangles());
  gl.ARKinit(3);
  gl.ARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(refinement));
  gl.Enable(GL_ARK);
  if (has_shader) set_refinement_shader(t, program, "void refine() { position.y += 0.25; }");
  return capture(t, draw_two);
}

void check_linear_outputs(Test& t) {
  const Captured inputs = draw_squares(t, GL_LINEAR_INPUTS_ARK, true);
  t.expect(same(draw_squares(t, GL_LINEAR_OUTPUTS_ARK, true), inputs), "LINEAR_OUTPUTS_ARK with a refinement shader");
  t.expect(!same(draw_squares(t, GL_LINEAR_OUTPUTS_ARK, false), draw_squares(t, GL_LINEAR_INPUTS_ARK, false)),
           "without a refinement shader, both differ");
}

// Matrices and integers: the corners, and the provoking corner's integers.
void check_types(Test& t) {
  const GLuint program = build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in ivec2 number;\n"
                    "layout(location = 8) in mat2 matrix; layout(location = 3) in float single;\n"
                    "out vec4 result; out vec4 colour;\n"
                    "void main() { result = vec4(matrix[1], single, float(number.y)); colour = vec4(number.x);\n"
                    "  gl_Position = position; }\n",
          .captured = {"result"}});
  gl.UseProgram(program);
  struct Vertex {
    Vec4 position;
    std::array<GLint, 2> number;
    Vec4 matrix;
    float single;
  };
  const Vertex vertices[] = {{{0, 0, 0, 1}, {3, 4}, {1, 2, 3, 4}, 0.5F},
                             {{0.5F, 0, 0, 1}, {5, 6}, {5, 6, 7, 8}, 1.5F},
                             {{0, 0.5F, 0, 1}, {7, 8}, {9, 10, 11, 13}, 2.5F}};
  GLuint array = 0;
  GLuint buffer = 0;
  gl.GenVertexArrays(1, &array);
  gl.BindVertexArray(array);
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(vertices), vertices, GL_STATIC_DRAW);
  const auto at = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
  for (const auto& [index, size, place] : {std::tuple{0U, 4, offsetof(Vertex, position)},
                                           {8U, 2, offsetof(Vertex, matrix)},
                                           {9U, 2, offsetof(Vertex, matrix) + 8},
                                           {3U, 1, offsetof(Vertex, single)}}) {
    gl.VertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, sizeof(Vertex), at(place));
    gl.EnableVertexAttribArray(index);
  }
  gl.VertexAttribIPointer(1, 2, GL_INT, sizeof(Vertex), at(offsetof(Vertex, number)));
  gl.EnableVertexAttribArray(1);
  refine_uniformly(1);
  set_refinement_shader(t, program,
                        "void refine() { matrix[1] = vec2(ark_corner_matrix[2][1].y, ark_corner_matrix[0][1].x);\n"
                        "  single = ark_corner_single[1]; number.y = 10 * ark_corner_number[1].y + number.y; }");
  const auto results = capture_as<Vec4>(t, 100, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
  t.expect_equal(results.size(), 12U, "vertices");
  for (const Vec4& result : results)  // the last vertex is the provoking one
    t.expect(result == Vec4{13, 3, 1.5F, 68}, "the corners' values, and the provoking corner's integers");
}

struct Version {
  const char* leaf;
  const char* directive;
  float value;
  Api api;
};

constexpr Version versions[] = {
    {"gl_150", "#version 150\n", 150, Api::gl_core},
    {"gl_330", "#version 330 core\n", 330, Api::gl_core},
    {"gl_400", "#version 400\n", 400, Api::gl_core},
    {"gl_430", "#version 430\n", 430, Api::gl_core},
    {"gl_130_compat", "#version 130\n", 130, Api::gl_compat},
    {"gl_150_compat", "#version 150 compatibility\n", 150, Api::gl_compat},
    {"gl_430_compat", "#version 430 compatibility\n", 430, Api::gl_compat},
    {"es_300", "#version 300 es\nprecision highp float;\n", 300, Api::gles},
    {"es_310", "#version 310 es\nprecision highp float;\n", 310, Api::gles},
    {"es_320", "#version 320 es\nprecision highp float;\n", 320, Api::gles},
};

void check_version(Test& t, const Version& version) {
  const std::string head = version.directive;
  std::string log;
  const GLuint program = try_program(
      {.vertex = head + "in vec4 position; out float seen; void main() { seen = 0.0; gl_Position = position; }\n",
       .fragment = head + "in float seen; out vec4 pixel; void main() { pixel = vec4(seen); }\n",
       .captured = {"gl_Position"}},
      log);
  if (program == 0) t.internal_error("a program does not build: " + log);
  gl.UseProgram(program);
  const MeshBuffers mesh = upload(one_triangle(), false);
  const auto location = static_cast<GLuint>(gl.GetAttribLocation(program, "position"));
  gl.BindBuffer(GL_ARRAY_BUFFER, mesh.buffer);
  gl.VertexAttribPointer(location, 4, GL_FLOAT, GL_FALSE, sizeof(MeshVertex), nullptr);
  gl.EnableVertexAttribArray(location);
  refine_uniformly(1);
  set_refinement_shader(t, program, "void refine() { position.z = float(__VERSION__); }");
  const auto positions = capture_as<Vec4>(t, 100, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
  t.expect_equal(positions.size(), 12U, "vertices");
  for (const Vec4& position : positions) t.expect_equal(position[2], version.value, "__VERSION__ in refine");
}

constexpr Area look{"ark.shader.input.", control};

}  // namespace

Cases refinement_shader_inputs_cases() {
  Cases cases{
      look("barycentric", {"11.R.9-14", "11.R.9-15"},
           "Compare ark_barycentric with an input that is (1, 0, 0), (0, 1, 0) and (0, 0, 1) at the corners.",
           "(u, v, w); weights of another corner; 0 at the edges.", check_barycentric),
      look("corners", {"11.R.9-14", "11.R.9-15"}, "Capture one component of ark_corner_position of each corner.",
           "Corners of the refined triangle, in another order, or of the other coarse triangle.", check_corners),
      look("corners_indexed", {"11.R.9-15"}, "The same for an indexed draw, and count the vertices of each triangle.",
           "Corners by vertex number, not by index.", check_corners_of_indices),
      look("refined", {"11.R.9-15", "11.R.9-13"}, "Copy the position to another input and compare both outputs.",
           "The value of corner 0 or of the provoking corner.", check_refined_value),
      look("curved", {"11.R.9-15", "11.R.9-13"},
           "With CURVED_PN_ARK, use a refinement shader that does nothing, and one that copies the position.",
           "A refinement shader makes refinement linear, or runs before the curve.", check_curved_value),
      look("written", {"11.R.9-13", "11.R.9-15", "overview-6"},
           "Move, scale and replace components, and compare with the draw without a refinement shader.",
           "Executed twice; after the vertex stage; only at new vertices.", check_written),
      look("another", {"11.R.9-14", "11.R.9-15"}, "One input moves another.",
           "Inputs that refine() only writes are missing.", check_input_of_another),
      look("depth_zero", {"11.R.9-18"}, "Draw with tags of 0, and with a pool of level 0.",
           "Coarse triangles bypass the refinement shader.", [](Test& t) { check_depth_zero(t, false); }),
      look("uniform_depth_zero", {"11.R.9-18"}, "Draw with a uniform depth of 0.",
           "A uniform depth of 0 is drawn as without the extension.", [](Test& t) { check_depth_zero(t, true); }),
      look("linear_outputs", {"11.R.9-19"},
           "With a vertex stage that squares positions, LINEAR_OUTPUTS_ARK with a refinement shader gives the result "
           "of LINEAR_INPUTS_ARK, bit for bit.",
           "Outputs are refined, and the refinement shader runs only at the corners or not at all.",
           check_linear_outputs),
      look("types", {"11.R.9-14", "11.R.9-15"}, "Read the corners of a matrix, a float and integers, and write them.",
           "Columns exchanged; integers of corner 0.", check_types),
  };
  for (const Version& version : versions)
    cases.push_back({.name = std::string("ark.shader.version.") + version.leaf,
                     .clauses = version.api == Api::gles ? std::vector<std::string>{"11.R.9-10", "11.R.9-11", "es-2"}
                                                         : std::vector<std::string>{"11.R.9-10", "11.R.9-11"},
                     .plan = "refine writes __VERSION__ to transform feedback.",
                     .wrong = "The version of the implementation's own programs.",
                     .apis = {version.api},
                     .check = [version](Test& t) { check_version(t, version); }});
  return cases;
}

}  // namespace glark::conformance
