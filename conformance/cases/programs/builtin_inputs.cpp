// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Built-in inputs of the vertex stage of a refined draw (11.R.10): gl_VertexID, gl_InstanceID and draw parameters.
#include <algorithm>
#include <set>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/cases/programs/recorded_value.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

// The outputs of the three corners, refined by (11.R.1).
void expect_corner_values(Test& t, const std::vector<RecordedVertex>& records, const std::array<float, 3>& values,
                          const std::string& what) {
  std::set<float> expected;
  for (const reference::Weights& at : reference::minimum_vertices({2, 2, 2}))
    expected.insert(reference::refined(values[0], values[1], values[2], at));
  std::set<float> found;
  for (const RecordedVertex& record : records) found.insert(record[4]);
  t.expect_equal(records.size(), 48U, what + ": refined vertices");
  t.expect(found == expected, what + ": the numbers of the corners, refined");
}

void check_vertex_id(Test& t) {
  const GLuint program = record_program(t, "", "vec4(float(gl_VertexID * gl_VertexID))");
  gl.UseProgram(program);
  Mesh mesh = one_triangle();
  mesh.insert(mesh.begin(), 4, mesh[0]);
  upload(mesh);
  refine_uniformly(2);
  expect_corner_values(t, capture_as<RecordedVertex>(t, 1000, [] { gl.DrawArrays(GL_TRIANGLES, 4, 3); }), {16, 25, 36},
                       "DrawArrays");
  const GLubyte indices[] = {3, 1, 2};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
  expect_corner_values(t,
                       capture_as<RecordedVertex>(
                           t, 1000, [] { gl.DrawElementsBaseVertex(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, nullptr, 3); }),
                       {36, 16, 25}, "DrawElementsBaseVertex");
}

// If the vertex stage reads gl_VertexID, the refinement shader is ignored and its status stays.
void check_vertex_id_shader(Test& t) {
  const GLuint program = record_program(t, "", "vec4(float(gl_VertexID))");
  gl.UseProgram(program);
  upload(one_triangle());
  refine_uniformly(2);
  const auto sorted = [&] {
    auto records = capture_as<RecordedVertex>(t, 1000, draw_one);
    std::sort(records.begin(), records.end());
    return records;
  };
  const auto without = sorted();
  set_refinement_shader(t, program, "void refine() { position.xyz += 5.0; }\n");
  t.expect(sorted() == without, "the refinement shader is ignored");
}

// The colour is no linear function of the position, so refined inputs would give other values than refined outputs.
void check_cull_distance(Test& t) {
  if (!t.has_extension("GL_ARB_cull_distance")) t.not_supported("no GL_ARB_cull_distance");
  std::string log;
  const GLuint program = try_program(
      {.vertex = "#version 430\n#extension GL_ARB_cull_distance : require\n"
                 "layout(location = 0) in vec4 position; out vec4 colour; out float gl_CullDistance[1];\n"
                 "void main() { gl_Position = position; gl_CullDistance[0] = 1.0;\n"
                 "  colour = vec4(floor(8.0 * position.x * position.x) + 16.0 * floor(8.0 * position.y)); }\n",
       .fragment = "#version 430\nin vec4 colour; out vec4 pixel; void main() { pixel = colour; }",
       .captured = {"gl_Position", "colour"}},
      log);
  if (program == 0) t.internal_error(log);
  gl.UseProgram(program);
  upload(one_triangle());
  const auto coarse = capture_as<RecordedVertex>(t, 3, draw_one);
  t.require(coarse.size() == 3, "the unrefined triangle");
  refine_uniformly(2);
  const std::array<float, 3> corners = {coarse[0][4], coarse[1][4], coarse[2][4]};
  expect_corner_values(t, capture_as<RecordedVertex>(t, 1000, draw_one), corners, "gl_CullDistance is written");
  set_refinement_shader(t, program, "void refine() { position.xyz += 5.0; }\n");
  expect_corner_values(t, capture_as<RecordedVertex>(t, 1000, draw_one), corners, "with a refinement shader");
}

void check_draw_parameters(Test& t) {
  if (!t.has_extension("GL_ARB_shader_draw_parameters")) t.not_supported("no GL_ARB_shader_draw_parameters");
  std::string log;
  const std::string stage =
      "#version 430\n#extension GL_ARB_shader_draw_parameters : require\n"
      "layout(location = 0) in vec4 position; out vec4 colour;\n"
      "void main() { gl_Position = position;\n"
      "  colour = vec4(gl_BaseVertexARB, gl_BaseInstanceARB, gl_DrawIDARB, gl_InstanceID); }\n";
  const GLuint program =
      try_program({.vertex = stage,
                   .fragment = "#version 430\nin vec4 colour; out vec4 pixel; void main() { pixel = colour; }",
                   .captured = {"gl_Position", "colour"}},
                  log);
  if (program == 0) t.internal_error(log);
  gl.UseProgram(program);
  Mesh mesh = one_triangle();
  mesh.insert(mesh.begin(), 2, mesh[0]);
  upload(mesh);
  const GLuint indices[] = {0, 1, 2};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
  const GLuint records[] = {3, 1, 0, 2, 5, 3, 2, 0, 2, 7};
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, buffer);
  gl.BufferData(GL_DRAW_INDIRECT_BUFFER, sizeof(records), records, GL_STATIC_DRAW);
  const auto values = [&] {
    std::set<std::array<float, 4>> all;
    for (const RecordedVertex& record : capture_as<RecordedVertex>(
             t, 1000, [] { gl.MultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr, 2, 0); }))
      all.insert({record[4], record[5], record[6], record[7]});
    return all;
  };
  const auto unrefined = values();
  const std::set<std::array<float, 4>> expected = {{2, 5, 0, 0}, {2, 7, 1, 0}, {2, 7, 1, 1}};
  if (unrefined != expected)
    t.not_supported("gl_BaseVertex, gl_BaseInstance or gl_DrawID are wrong without refinement");
  refine_uniformly(1);
  t.expect(values() == expected, "the values of the coarse vertices, at every refined one");
}

void check_instance_id(Test& t, GLenum refinement) {
  gl.UseProgram(record_program(t, "", "vec4(float(gl_InstanceID))"));
  upload(one_triangle());
  refine_uniformly(2, refinement);
  std::array<int, 3> counts{};
  for (const RecordedVertex& record :
       capture_as<RecordedVertex>(t, 1000, [] { gl.DrawArraysInstanced(GL_TRIANGLES, 0, 3, 3); })) {
    const auto instance = static_cast<std::size_t>(record[4]);
    if (instance > 2 || static_cast<float>(instance) != record[4]) return t.fail("an instance " + as_text(record[4]));
    ++counts[instance];
  }
  for (const int count : counts) t.expect_equal(count, 48, "refined vertices of an instance");
}

constexpr Area stage_case{"ark.stage."};

}  // namespace

Cases builtin_inputs_cases() {
  Cases cases = {
      stage_case("vertex_id", {"11.R.10-3", "11.R.10-9"},
                 "The stage squares gl_VertexID. Its outputs are refined from the corners.",
                 "Numbers of refined vertices; the square of a refined number.", check_vertex_id, every_api),
      stage_case("vertex_id.refinement_shader", {"11.R.10-9"}, "Use a refinement shader together with gl_VertexID.",
                 "The shader is executed; the status becomes FALSE.", check_vertex_id_shader, every_api),
      optional(stage_case("cull_distance", {"11.R.10-9"}, "The stage writes gl_CullDistance; with a refinement shader.",
                          "Refined inputs; the shader is executed.", check_cull_distance, desktop_apis)),
      optional(stage_case("draw_parameters", {"11.R.10-3", "11.R.10-5"},
                          "Two indirect draws with base vertices and base instances.",
                          "Values of the implementation's own draws.", check_draw_parameters, desktop_apis))};
  for (const GLenum refinement : {GL_LINEAR_INPUTS_ARK, GL_LINEAR_OUTPUTS_ARK})
    cases.push_back(
        {.name = std::string("ark.stage.instance_id.") + (refinement == GL_LINEAR_INPUTS_ARK ? "inputs" : "outputs"),
         .clauses = {"11.R.10-5"},
         .plan = "Three instances write gl_InstanceID.",
         .wrong = "The implementation's own instance numbers.",
         .check = [refinement](Test& t) { check_instance_id(t, refinement); }});
  return cases;
}

}  // namespace glark::conformance
