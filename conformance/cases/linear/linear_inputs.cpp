// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Refined inputs (11.R.6): every type of input compared with (11.R.1), by bits.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "conformance/cases/cases.h"
#include "conformance/reference/refinement.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

constexpr GLuint first_location = 7;
constexpr std::size_t most_components = 16;
using Values = std::array<float, most_components>;

struct InputType {
  const char* leaf;
  const char* declaration;  // of the input "a"
  std::size_t locations;
  GLint components;       // of one location
  const char* component;  // in GLSL: the element with the index i
  bool is_array = false;
};

const InputType input_types[] = {
    {"float", "float a", 1, 1, "a"},
    {"vec2", "vec2 a", 1, 2, "a[i]"},
    {"vec3", "vec3 a", 1, 3, "a[i]"},
    {"vec4", "vec4 a", 1, 4, "a[i]"},
    {"mat2", "mat2 a", 2, 2, "a[i / 2][i % 2]"},
    {"mat3", "mat3 a", 3, 3, "a[i / 3][i % 3]"},
    {"mat4", "mat4 a", 4, 4, "a[i / 4][i % 4]"},
    {"mat2x3", "mat2x3 a", 2, 3, "a[i / 3][i % 3]"},
    {"mat4x2", "mat4x2 a", 4, 2, "a[i / 2][i % 2]"},
    {"float_array", "float a[3]", 3, 1, "a[i]", true},
    {"vec3_array", "vec3 a[2]", 2, 3, "a[i / 3][i % 3]", true},
};

std::size_t components_of(const InputType& type) { return type.locations * static_cast<std::size_t>(type.components); }

// All values differ, have both signs, use all bits of the mantissa, and are of very different magnitudes.
std::array<Values, 3> random_values(Test& t) {
  std::array<Values, 3> corners;
  for (Values& corner : corners)
    for (float& value : corner) value = std::ldexp(t.random_float(-1, 1), t.random_int(-12, 12));
  return corners;
}

GLuint input_program(Test& t, const InputType& type) {
  const std::string count = std::to_string(components_of(type));
  std::vector<const char*> captured = {"gl_Position", "weights_out", "triangle_out"};
  static const std::string names[most_components] = {"r[0]",  "r[1]",  "r[2]",  "r[3]", "r[4]",  "r[5]",
                                                     "r[6]",  "r[7]",  "r[8]",  "r[9]", "r[10]", "r[11]",
                                                     "r[12]", "r[13]", "r[14]", "r[15]"};
  for (std::size_t i = 0; i < components_of(type); ++i) captured.push_back(names[i].c_str());
  return build_program(t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 2) in vec3 weights;\n"
                                     "layout(location = 7) in " +
                                     std::string(type.declaration) + "; out float r[" + count +
                                     "]; out vec4 colour;\n"
                                     "out vec3 weights_out; out float triangle_out;\n"
                                     "void main() { for (int i = 0; i < " +
                                     count + "; ++i) r[i] = " + type.component +
                                     ";\n"
                                     "  weights_out = weights; triangle_out = 0.0; colour = vec4(r[0]);\n"
                                     "  gl_Position = position; }\n",
                           .captured = captured});
}

void upload_values(const std::array<Values, 3>& corners, const InputType& type) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(corners), corners.data(), GL_STATIC_DRAW);
  for (std::size_t i = 0; i < type.locations; ++i) {
    const auto location = static_cast<GLuint>(first_location + i);
    gl.VertexAttribPointer(
        location, type.components, GL_FLOAT, GL_FALSE, sizeof(Values),
        reinterpret_cast<const void*>(i * static_cast<std::size_t>(type.components) * sizeof(float)));
    gl.EnableVertexAttribArray(location);
  }
}

// A language that cannot forbid contraction may leave out one rounding: at most half a unit in the last place of the
// unrounded product.
bool is_refined(Test& t, float actual, const Vec3& weights, float a0, float a1, float a2) {
  const float expected = reference::refined(weights, a0, a1, a2);
  if (actual == expected) return true;
  const float largest = std::max({std::abs(weights[0] * a0), std::abs(weights[1] * a1), std::abs(weights[2] * a2)});
  return t.is_gles() && std::abs(actual - expected) <= std::ldexp(largest, -22);
}

void check_values(Test& t, const std::vector<unsigned char>& bytes, const std::array<Values, 3>& corners,
                  std::size_t components) {
  const std::size_t stride = 8 + components;
  std::vector<float> floats(bytes.size() / sizeof(float));
  std::memcpy(floats.data(), bytes.data(), bytes.size());
  t.require(floats.size() > 3 * stride, "the triangle is refined");
  for (std::size_t vertex = 0; vertex < floats.size(); vertex += stride) {
    const Vec3 weights = {floats[vertex + 4], floats[vertex + 5], floats[vertex + 6]};
    for (std::size_t i = 0; i < components; ++i) {
      const float actual = floats[vertex + 8 + i];
      if (!t.expect(is_refined(t, actual, weights, corners[0][i], corners[1][i], corners[2][i]),
                    fmt::format("component {} at ({}, {}, {}) has the bits of (11.R.1): {} instead of {}", i,
                                as_text(weights[0]), as_text(weights[1]), as_text(weights[2]), as_text(actual),
                                as_text(reference::refined(weights, corners[0][i], corners[1][i], corners[2][i])))))
        return;
    }
  }
}

void check_type(Test& t, const InputType& type) {
  const GLuint program = input_program(t, type);
  gl.UseProgram(program);
  upload(one_triangle({5, 2, 3}));
  const auto corners = random_values(t);
  upload_values(corners, type);
  refine_by_tags(5);
  require_refinable(t, program);
  const std::size_t components = components_of(type);
  check_values(t,
               capture_bytes(t, (8 + components) * sizeof(float), 3, 4000, GL_TRIANGLES,
                             [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }),
               corners, components);
}

Case type_case(const InputType& type) {
  const bool is_plain = std::string(type.leaf) == "vec4";
  return {.name = std::string("ark.linear.inputs.type.") + type.leaf,
          .clauses = is_plain ? std::vector<std::string>{"11.R.6-1", "11.R.6-2", "11.R.6-4", "11.R.6-5"}
                              : std::vector<std::string>{"11.R.6-2", "11.R.6-4", "11.R.6-6"},
          .plan =
              "Give a triangle with tags 5, 2, 3 random values of this type, capture the vertex stage's input, and "
              "compare each component with (11.R.1), with every operation rounded separately.",
          .wrong =
              "Contracted, or summed in another order: last bits differ. Columns or elements after the first keep a "
              "corner's value. A normalized vector has another length.",
          .apis = type.is_array ? desktop_apis : every_api,
          .check = [type](Test& t) { check_type(t, type); }};
}

struct PlainVertex {
  Vec4 position;
  Vec4 value;
  Vec3 weights;
};

GLuint value_program(Test& t) {
  return build_program(t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 2) in vec3 weights;\n"
                                     "layout(location = 3) in vec4 value; out vec4 value_out; out vec3 weights_out;\n"
                                     "out vec4 colour;\n"
                                     "void main() { value_out = value; weights_out = weights; colour = value;\n"
                                     "  gl_Position = position; }\n",
                           .captured = {"gl_Position", "value_out", "weights_out"}});
}

Mesh random_triangle(Test& t) {
  Mesh mesh = one_triangle();
  for (MeshVertex& vertex : mesh)
    for (std::size_t i = 0; i < 4; ++i) {
      vertex.colour[i] = std::ldexp(t.random_float(-1, 1), t.random_int(-9, 9));
      vertex.position[i] += i < 3 ? t.random_float(-0.2F, 0.2F) : t.random_float(0, 1);
    }
  return mesh;
}

void check_corners(Test& t, GLenum refinement) {
  gl.UseProgram(value_program(t));
  const Mesh mesh = random_triangle(t);
  upload(mesh);
  refine_uniformly(4, refinement);
  std::array<int, 3> seen{};
  for (const PlainVertex& vertex : capture_as<PlainVertex>(t, 2000, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }))
    for (std::size_t i = 0; i < 3; ++i) {
      if (vertex.weights[i] != 1) continue;
      ++seen[i];
      t.expect(vertex.value == mesh[i].colour && vertex.position == mesh[i].position, "a corner has the corner's bits");
    }
  t.expect(seen[0] > 0 && seen[1] > 0 && seen[2] > 0, "all corners are drawn");
}

// The vertices on the first edge, sorted by their distance from `from`.
std::vector<PlainVertex> edge_vertices(Test& t, const Mesh& mesh, std::size_t from, std::size_t steps) {
  upload(mesh);
  std::vector<PlainVertex> edge(steps + 1);
  std::vector<bool> has(steps + 1, false);
  for (const PlainVertex& vertex : capture_as<PlainVertex>(t, 4000, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); })) {
    if (vertex.weights[2] != 0) continue;
    const auto k = static_cast<std::size_t>(std::lround(vertex.weights[1 - from] * static_cast<float>(steps)));
    t.require(k <= steps, "weights lie between 0 and 1");
    edge[k] = vertex;
    has[k] = true;
  }
  for (const bool each : has) t.require(each, "every vertex of the edge is drawn");
  return edge;
}

void check_edge_order(Test& t, GLenum refinement) {
  gl.UseProgram(value_program(t));
  refine_uniformly(5, refinement);
  for (int round = 0; round < 5; ++round) {
    const Mesh mesh = random_triangle(t);
    Mesh turned = random_triangle(t);
    for (const std::size_t i : {0U, 1U}) turned[i] = mesh[1 - i];
    for (const std::size_t i : {0U, 1U}) turned[i].weights = mesh[i].weights;
    const auto there = edge_vertices(t, mesh, 0, 32);
    const auto back = edge_vertices(t, turned, 1, 32);
    for (std::size_t i = 0; i <= 32; ++i)
      t.expect(there[i].value == back[i].value && there[i].position == back[i].position,
               fmt::format("step {} of the edge has the same bits from both ends", i));
  }
}

struct DifferenceVertex {
  std::array<float, 6> difference;
  Vec3 weights;
};

// The corners exceed 1, -3, 2, 5, -1 and 7 by very little. Cases compare this difference, times 1e10.
constexpr double near_by[6] = {1, -3, 2, 5, -1, 7};
constexpr double differences[3][6] = {{1, 0, 4, -2, 3, -6}, {3, 2, -5, 8, 0, 1}, {-7, -5, 2, 6, -4, 9}};

struct DoubleType {
  const char* leaf;
  const char* declaration;  // of the input "d"
  GLuint columns, rows;
  const char* component;  // in GLSL: the element with the index i
};
constexpr DoubleType double_types[] = {{"doubles", "dvec2 d", 1, 2, "d[i]"},
                                       {"double_matrix", "dmat2x3 d", 2, 3, "d[i / 3][i % 3]"},
                                       {"double_matrix_high", "dmat3x2 d", 3, 2, "d[i / 2][i % 2]"}};

GLuint difference_program(Test& t, const DoubleType& type) {
  return build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 2) in vec3 weights;\n"
                    "layout(location = 7) in " +
                    std::string(type.declaration) +
                    "; out float difference[6]; out vec3 weights_out; out vec4 colour;\n"
                    "const double near_by[6] = double[](1.0LF, -3.0LF, 2.0LF, 5.0LF, -1.0LF, 7.0LF);\n"
                    "void main() { for (int i = 0; i < 6; ++i) difference[i] = 0.0;\n"
                    "  for (int i = 0; i < " +
                    std::to_string(type.columns * type.rows) + "; ++i) difference[i] = float((" + type.component +
                    " - near_by[i]) * 1e10LF);\n"
                    "  weights_out = weights; colour = vec4(1.0); gl_Position = position; }\n",
          .captured = {"difference", "weights_out"}});
}

// The draw may be unrefined (11.R.11). If it is refined, the values are those of (11.R.1) in the type's precision;
// single precision would lose the difference.
void check_doubles(Test& t, const DoubleType& type) {
  gl.UseProgram(difference_program(t, type));
  upload(one_triangle());
  double corners[3][6] = {};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 6; ++i) corners[k][i] = near_by[i] + 1e-10 * differences[k][i];
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(corners), corners, GL_STATIC_DRAW);
  for (GLuint column = 0; column < type.columns; ++column) {
    gl.VertexAttribLPointer(first_location + column, static_cast<GLint>(type.rows), GL_DOUBLE, sizeof(corners[0]),
                            reinterpret_cast<const void*>(column * type.rows * sizeof(double)));
    gl.EnableVertexAttribArray(first_location + column);
  }
  refine_uniformly(3);
  const auto vertices = capture_as<DifferenceVertex>(t, 1000, [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
  t.require(vertices.size() == 3 || vertices.size() == std::size_t{3} * 64, "refined, or left unrefined");
  for (const DifferenceVertex& vertex : vertices)
    for (std::size_t i = 0; i < std::size_t{type.columns} * type.rows; ++i) {
      double expected = 0;
      for (std::size_t k = 0; k < 3; ++k) expected += vertex.weights[k] * differences[k][i];
      if (!t.expect_near(vertex.difference[i], expected, 1e-4, "a double-precision input, from near by, times 1e10"))
        return;
    }
}

Case corner_case(const char* leaf, GLenum refinement) {
  return {.name = std::string("ark.linear.corners.") + leaf,
          .clauses = {"11.R.6-3"},
          .plan = "Capture a triangle of random values at depth 4; where a weight is 1, compare bits with the corner.",
          .wrong = "w = 1 - u - v is not exactly 1, or products with 0 are replaced: the last bits of a corner change.",
          .check = [refinement](Test& t) { check_corners(t, refinement); }};
}

Case edge_case(const char* leaf, GLenum refinement) {
  return {
      .name = std::string("ark.linear.edge_order.") + leaf,
      .clauses = {"11.R.6-3", "11.R.8-3"},
      .plan = "Capture an edge of a triangle, then the same edge in another triangle from its other end, at depth 5.",
      .wrong = "A_0 + u (A_1 - A_0), or one product contracted with the sum: last bits differ, and edges crack.",
      .check = [refinement](Test& t) { check_edge_order(t, refinement); }};
}

}  // namespace

Cases linear_inputs_cases() {
  Cases cases;
  for (const InputType& type : input_types) cases.push_back(type_case(type));
  for (const DoubleType& type : double_types)
    cases.push_back({.name = std::string("ark.linear.inputs.") + type.leaf,
                     .clauses = {"11.R.6-4", "11.R.6-6", "11.R.11-10"},
                     .plan = std::string("An input ") + type.declaration +
                             " whose corners differ by 1e-10, if the implementation refines it.",
                     .wrong = "Refined in single precision, so the differences are gone; columns overlap.",
                     .apis = desktop_apis,
                     .check = [&type](Test& t) { check_doubles(t, type); }});
  cases.push_back(corner_case("inputs", GL_LINEAR_INPUTS_ARK));
  cases.push_back(corner_case("outputs", GL_LINEAR_OUTPUTS_ARK));
  cases.push_back(edge_case("inputs", GL_LINEAR_INPUTS_ARK));
  cases.push_back(edge_case("outputs", GL_LINEAR_OUTPUTS_ARK));
  return cases;
}

}  // namespace glark::conformance
