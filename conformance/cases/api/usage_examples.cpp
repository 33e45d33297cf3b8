// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The four usage examples, the fixed function's refinement shader, and what is different in the core profile and OpenGL ES.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/state.h"

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

GLuint primitives_of(const std::function<void()>& draw) {
  GLuint query = 0;
  GLuint primitives = 0;
  gl.GenQueries(1, &query);
  gl.BeginQuery(GL_PRIMITIVES_GENERATED, query);
  draw();
  gl.EndQuery(GL_PRIMITIVES_GENERATED);
  gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &primitives);
  return primitives;
}

void example_1_triangle() {
  gl.Begin(GL_TRIANGLES);
  gl.Vertex2f(-1, -1);
  gl.Vertex2f(1, -1);
  gl.Vertex2f(0, 1);
  gl.End();
}

void control_fixed(Test& t) { t.expect_equal(primitives_of(example_1_triangle), 1U, "primitives of the triangle"); }

void check_example_1(Test& t) {
  clear_surface();
  example_1_triangle();
  const Picture expected = read_picture(surface_size, surface_size);
  clear_surface();
  gl.ARKinit(6);
  gl.Enable(GL_ARK);
  gl.DepthTag1i(2);
  t.expect_equal(primitives_of(example_1_triangle), 16U, "primitives of the triangle");
  t.expect_no_error("the example");
  t.expect_same_picture(read_picture(surface_size, surface_size), expected, "the picture of a flat triangle");
}

void check_example_2(Test& t) {
  gl.UseProgram(capture_program(t));
  Mesh mesh = one_triangle();
  mesh.push_back({.position = {0.75F, 0.75F, 0, 1}});
  const GLuint vao = upload(mesh, false).array;
  const GLuint indices[] = {0, 1, 2, 2, 1, 3};
  GLuint buffers[2] = {};
  gl.GenBuffers(2, buffers);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[0]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffers[1]);
  gl.BufferData(GL_ARRAY_BUFFER, 4, nullptr, GL_DYNAMIC_DRAW);
  gl.ARKinit(8);
  gl.BindVertexArray(vao);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffers[1]);
  gl.DepthTagPointerARK(GL_UNSIGNED_BYTE, 0, nullptr);
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  for (const std::array<GLubyte, 4>& tags : {std::array<GLubyte, 4>{4, 1, 2, 6}, {0, 1, 0, 0}, {0, 4, 3, 2}}) {
    gl.BufferSubData(GL_ARRAY_BUFFER, 0, tags.size(), tags.data());
    const GLuint triangles = primitives_of([] { gl.DrawARPElementsARK(GL_TRIANGLES, 6, GL_UNSIGNED_INT, nullptr); });
    std::size_t expected = 0;
    for (const auto& [a, b, c] : {std::array<std::size_t, 3>{0, 1, 2}, {2, 1, 3}}) {
      const int d[] = {(tags[a] + tags[b]) / 2, (tags[b] + tags[c]) / 2, (tags[c] + tags[a]) / 2};
      const int m = 1 << std::min({d[0], d[1], d[2]});
      expected += static_cast<std::size_t>((m - 1) * (m - 2) + (1 << d[0]) + (1 << d[1]) + (1 << d[2]) - 2);
    }
    t.expect_equal(std::size_t{triangles}, expected, "triangles of the frame");
  }
  t.expect_equal(int{gl.IsEnabled(GL_ARK)}, int{GL_FALSE}, "IsEnabled(ARK)");
}

GLuint displaced_program(Test& t) {
  return build_program(
      t, {.vertex = "layout(location = 0) in vec4 position_and_w; layout(location = 1) in vec3 normal;\n"
                    "layout(location = 4) in vec2 uv; layout(location = 8) in vec3 position; out vec4 colour;\n"
                    "out vec4 where; out vec4 from;\n"
                    "void main() { colour = vec4(uv, normal.xy); where = vec4(position, 1.0); from = position_and_w;\n"
                    "  gl_Position = vec4(position, 1.0); }\n",
          .captured = {"where", "from"}});
}

struct Displaced {
  Vec4 position;
  Vec4 from;
};

void check_example_3(Test& t) {
  const GLuint program = displaced_program(t);
  static const char* displace =
      "uniform sampler2D height;\n"
      "uniform float scale;\n"
      "void refine() {\n"
      "  float h = textureLod(height, uv, 0.0).r;\n"
      "  position += scale * h * normalize(normal);\n"
      "}\n";
  GLint built = GL_FALSE;
  gl.RefinementShaderSourceARK(program, 1, &displace, nullptr);
  gl.GetRefinementivARK(program, GL_REFINEMENT_STATUS_ARK, &built);
  t.require(built == GL_TRUE, "the refinement program is built");
  gl.UseProgram(program);
  gl.Uniform1f(gl.GetUniformLocation(program, "scale"), 0.5F);
  Mesh mesh = one_triangle();
  for (MeshVertex& vertex : mesh) vertex.normal = {0, 3, 4};  // not of unit length
  const MeshBuffers buffers = upload(mesh, false);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffers.buffer);
  gl.VertexAttribPointer(8, 3, GL_FLOAT, GL_FALSE, sizeof(MeshVertex), nullptr);
  gl.EnableVertexAttribArray(8);
  GLuint texture = 0;
  const GLfloat texel[] = {0.25F, 9, 9, 9};
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, texel);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  refine_uniformly(2);
  const auto vertices = capture_as<Displaced>(t, 100, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
  t.expect_equal(vertices.size(), 48U, "vertices");
  for (const Displaced& vertex : vertices) {
    t.expect_near(double{vertex.position[0]}, double{vertex.from[0]}, 1e-6, "x");
    t.expect_near(double{vertex.position[1]} - double{vertex.from[1]}, 0.5 * 0.25 * 0.6, 1e-6, "y, displaced");
    t.expect_near(double{vertex.position[2]} - double{vertex.from[2]}, 0.5 * 0.25 * 0.8, 1e-6, "z, displaced");
  }
}

// An octant of the unit sphere: with CURVED_PN_ARK its refined vertices come near to the sphere.
void check_example_4(Test& t) {
  const GLuint program = build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal; out vec4 colour;\n"
                    "void main() { colour = vec4(normal, 1.0); gl_Position = position; }\n",
          .captured = {"gl_Position"}});
  gl.UseProgram(program);
  Mesh mesh = one_triangle();
  for (std::size_t i = 0; i < 3; ++i) {
    mesh[i].position = {0, 0, 0, 1};
    mesh[i].position[i] = 1;
    mesh[i].normal = {0, 0, 0};
    mesh[i].normal[i] = 1;
  }
  upload(mesh, false);
  gl.ARKinit(4);
  gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 3);
  gl.Enable(GL_ARK);
  const auto vertices = capture_as<Vec4>(t, 1000, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
  t.expect_no_error("the example");
  t.expect_equal(vertices.size(), 3U * 64U, "vertices");
  // By 11.R.7, b_01 = (1, 1/3, 0): half way along the edge x = y = (1 + 3 + 1) / 8.
  const auto is_half_way = [](const Vec4& vertex) {
    return std::abs(vertex[0] - 0.625F) < 1e-5F && std::abs(vertex[1] - 0.625F) < 1e-5F && std::abs(vertex[2]) < 1e-5F;
  };
  t.expect(std::any_of(vertices.begin(), vertices.end(), is_half_way), "there is a vertex at (0.625, 0.625, 0)");
  float least = 2;
  for (const Vec4& vertex : vertices) least = std::min(least, std::hypot(vertex[0], vertex[1], vertex[2]));
  t.expect(least > 0.75F, "no vertex is as near to the centre as those of a flat triangle: " + as_text(least));
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

// refine() writes what it sees into the colour.
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
  t.expect_equal(length, 0, "the source of a program has nothing of the fixed function's");
  t.expect_same_picture(draw_fixed(0), expected, "the fixed function");
}

void check_attribute_zero(Test& t) {
  const GLuint program = build_program(t, {.vertex = "layout(location = 8) in vec4 position; out vec4 colour;\n"
                                                     "void main() { colour = vec4(1.0); gl_Position = position; }\n",
                                           .captured = {"gl_Position"}});
  gl.UseProgram(program);
  const MeshBuffers mesh = upload(one_triangle({4, 1, 2}), false);
  gl.DisableVertexAttribArray(at_position);
  gl.BindBuffer(GL_ARRAY_BUFFER, mesh.buffer);
  gl.VertexAttribPointer(8, 4, GL_FLOAT, GL_FALSE, sizeof(MeshVertex), nullptr);
  gl.EnableVertexAttribArray(8);
  gl.ARKinit(4);
  gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, 0);
  gl.DepthTag1i(2);
  gl.Enable(GL_ARK);
  const auto vertices = [&] { return capture_as<Vec4>(t, 1000, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }).size(); };
  t.expect_equal(vertices(), 48U, "vertices with the current tag in attribute 0");
  gl.DepthTagPointerARK(GL_FLOAT, sizeof(MeshVertex), reinterpret_cast<const void*>(offsetof(MeshVertex, tag)));
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  t.expect_equal(vertices(), 36U, "vertices with the array of attribute 0");
}

void check_split_without_effect(Test& t) {
  gl.UseProgram(capture_program(t));
  upload(one_triangle({3, 1, 2}));
  refine_by_tags(4);
  const auto captured = [&] {
    std::vector<Vec4> positions;
    for (const CapturedVertex& vertex : capture(t, [] { gl.DrawArrays(GL_TRIANGLE_FAN, 0, 3); }))
      positions.push_back(vertex.position);
    std::sort(positions.begin(), positions.end());
    return positions;
  };
  const auto before = captured();
  gl.ARKParameteriARK(GL_POLYGON_SPLIT_ARK, GL_POLYGON_CENTROID_ARK);
  t.expect_no_error("POLYGON_SPLIT_ARK");
  t.expect(before.size() > 3 && captured() == before, "the same vertices");
}

void check_requirements(Test& t) {
  t.expect(t.has_extension("GL_ARK_adaptive_refinement"), "the name is among the extensions");
  if (t.is_compat() || t.is_gles()) {
    const auto* const text = reinterpret_cast<const char*>(gl.GetString(GL_EXTENSIONS));
    const std::string names = " " + std::string(text == nullptr ? "" : text) + " ";
    t.expect(names.find(" GL_ARK_adaptive_refinement ") != std::string::npos, "the name is in GetString(EXTENSIONS)");
  }
  t.expect(t.version() >= (t.is_gles() ? 32 : 43), "the version is OpenGL 4.3 or OpenGL ES 3.2 at least");
  t.expect(integer_of(GL_MAX_DEPTH_ARK) >= 11, "MAX_DEPTH_ARK is at least 11");
  t.expect_no_error("the queries");
}

Case of_fixed(const char* name, std::vector<std::string> clauses, const char* plan, const char* wrong,
              std::function<void(Test&)> check) {
  return {.name = name,
          .clauses = std::move(clauses),
          .plan = plan,
          .wrong = wrong,
          .apis = compat_only,
          .control = control_fixed,
          .check = std::move(check)};
}

}  // namespace

Cases usage_examples_cases() {
  return {
      of_fixed("ark.usage.fixed_function", {"usage-1", "usage-2", "overview-2", "overview-3", "overview-7"},
               "Example 1, with the primitives counted by a query, and the picture.", "64 triangles, or one.",
               check_example_1),
      {.name = "ark.usage.tags_in_a_buffer",
       .clauses = {"usage-3", "usage-4", "functions-6", "functions-7"},
       .plan = "Example 2 for three frames of two triangles with other tags.",
       .wrong = "Tags of the first frame.",
       .check = check_example_2},
      {.name = "ark.usage.displaced",
       .clauses = {"usage-5", "usage-6", "usage-7", "overview-6"},
       .plan = "Example 3 with a height of 0.25 and a scale of 0.5: vertices move along the unit normal.",
       .wrong = "The scale stays 0; corners stay where they are.",
       .check = check_example_3},
      {.name = "ark.usage.smooth",
       .clauses = {"usage-8", "usage-9", "overview-6"},
       .plan = "Example 4 for an octant of a sphere.",
       .wrong = "A flat triangle.",
       .check = check_example_4},
      of_fixed("ark.shader.fixed.moves", {"11.R.9-4", "11.R.9-16", "11.R.9-37"},
               "A refinement shader of the fixed function moves the triangle; then it is taken away.",
               "Program 0 is an error; it stays for draws that are not refined.", check_fixed_shader),
      of_fixed("ark.shader.fixed.version", {"11.R.9-10"}, "refine shows whether __VERSION__ is 150.",
               "The version of another program.",
               [](Test& t) {
                 check_fixed_inputs(t, "vec3(__VERSION__ == 150 ? 1.0 : 0.0, 0.5, 0.25)", {1, 0.5F, 0.25F});
               }),
      of_fixed("ark.shader.fixed.corners", {"11.R.9-16", "11.R.9-14"},
               "The colour is made of ark_corner_gl_Vertex and ark_corner_gl_Color.",
               "ark_corner_Vertex; another corner.",
               [](Test& t) {
                 check_fixed_inputs(t, "ark_corner_gl_Vertex[1].x, ark_corner_gl_Vertex[2].y, ark_corner_gl_Color[0].b",
                                    {0.25F, 0.625F, 0.25F});
               }),
      of_fixed("ark.shader.fixed.own", {"11.R.9-4", "11.R.9-31"}, "The fixed function's source is none of a program's.",
               "One source for all.", check_fixed_uniform),
      {.name = "ark.core.attribute_zero",
       .clauses = {"core-5", "es-1", "11.R.2-7"},
       .plan = "Tags in attribute 0, current and in an array, and positions elsewhere.",
       .wrong = "INVALID_VALUE; the tag of attribute 0 is never read.",
       .apis = {Api::gl_core, Api::gles},
       .check = check_attribute_zero},
      {.name = "ark.core.split",
       .clauses = {"core-3", "es-1"},
       .plan = "Capture a triangle fan with both values of POLYGON_SPLIT_ARK.",
       .wrong = "INVALID_ENUM; fans are split at a centroid.",
       .apis = {Api::gl_core, Api::gles},
       .check = check_split_without_effect},
      {.name = "ark.requirements",
       .clauses = {"name-1", "dependencies-1", "es-3", "limits-1"},
       .plan = "The extension's name, the version of the context, and the limit.",
       .wrong = "The name is missing from GetString or GetStringi.",
       .check = check_requirements},
  };
}

}  // namespace glark::conformance
