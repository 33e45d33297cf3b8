// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The four usage examples, and what is different in the core profile and in OpenGL ES.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

void example_1_triangle() {
  gl.Begin(GL_TRIANGLES);
  gl.Vertex2f(-1, -1);
  gl.Vertex2f(1, -1);
  gl.Vertex2f(0, 1);
  gl.End();
}

void control_fixed(Test& t) { t.expect_equal(count_generated(example_1_triangle), 1U, "primitives of the triangle"); }

void check_example_1(Test& t) {
  clear_surface();
  example_1_triangle();
  const Picture expected = read_picture(surface_size, surface_size);
  clear_surface();
  gl.ARKinit(6);
  gl.Enable(GL_ARK);
  gl.DepthTag1i(2);
  t.expect_equal(count_generated(example_1_triangle), 16U, "primitives of the triangle");
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
    const GLuint triangles = count_generated([] { gl.DrawARPElementsARK(GL_TRIANGLES, 6, GL_UNSIGNED_INT, nullptr); });
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

// An octant of the unit sphere: with CURVED_PN_ARK its refined vertices come close to the sphere.
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
  // By 11.R.7, b_01 = (1, 1/3, 0). The middle of the edge has x = y = (1 + 3 + 1) / 8.
  const auto is_half_way = [](const Vec4& vertex) {
    return std::abs(vertex[0] - 0.625F) < 1e-5F && std::abs(vertex[1] - 0.625F) < 1e-5F && std::abs(vertex[2]) < 1e-5F;
  };
  t.expect(std::any_of(vertices.begin(), vertices.end(), is_half_way), "there is a vertex at (0.625, 0.625, 0)");
  float least = 2;
  for (const Vec4& vertex : vertices) least = std::min(least, std::hypot(vertex[0], vertex[1], vertex[2]));
  t.expect(least > 0.75F, "no vertex is as close to the centre as in a flat triangle: " + as_text(least));
}

constexpr Area fixed_function_case{.prefix = "ark.usage.", .control = control_fixed, .apis = compat_only};

}  // namespace

Cases usage_examples_cases() {
  return {
      fixed_function_case("fixed_function", {"usage-1", "usage-2", "overview-2", "overview-3", "overview-7"},
                          "Draw example 1, count its primitives by a query, and compare the picture.",
                          "64 triangles, or one.", check_example_1),
      {.name = "ark.usage.tags_in_a_buffer",
       .clauses = {"usage-3", "usage-4", "functions-6", "functions-7"},
       .plan = "Draw example 2 for three frames of two triangles with different tags.",
       .wrong = "The tags of the first frame.",
       .check = check_example_2},
      {.name = "ark.usage.displaced",
       .clauses = {"usage-5", "usage-6", "usage-7", "overview-6"},
       .plan = "Draw example 3 with a height of 0.25 and a scale of 0.5: vertices move along the unit normal.",
       .wrong = "The scale stays 0; corners stay where they are.",
       .check = check_example_3},
      {.name = "ark.usage.smooth",
       .clauses = {"usage-8", "usage-9", "overview-6"},
       .plan = "Draw example 4 for an octant of a sphere.",
       .wrong = "A flat triangle.",
       .check = check_example_4},
  };
}

}  // namespace glark::conformance
