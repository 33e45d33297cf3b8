// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Outputs of every type whose values are the same at two corners and differ at the third: all components, or one alone.
#include <fmt/core.h>

#include <array>
#include <bit>
#include <cstring>
#include <optional>

#include "conformance/cases/cases.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

constexpr GLuint at_values = 7;

// An output of the vertex stage. `first` is the value of all components but the last, `last` that of the last one.
struct CornerOutput {
  const char* leaf;
  const char* declaration;  // without in or out
  const char* assignment;   // from `first` and `last`
  std::vector<const char*> captured;
  std::size_t components;
  const char* sum;  // in the fragment stage
  bool is_flat = false;
  bool is_integer = false;  // captured integers; each value is a whole number
  Apis apis = every_api;
};

// The last component is the last that is captured.
const std::vector<CornerOutput>& corner_outputs() {
  static const std::vector<CornerOutput> all = {
      {"float", "float value;", "value = last;", {"value"}, 1, "value"},
      {"vec2", "vec2 value;", "value = vec2(first, last);", {"value"}, 2, "value.x + 2.0 * value.y"},
      {"vec3", "vec3 value;", "value = vec3(first, first, last);", {"value"}, 3, "value.x + 2.0 * value.z"},
      {"vec4", "vec4 value;", "value = vec4(first, first, first, last);", {"value"}, 4, "value.x + 2.0 * value.w"},
      {"mat2",
       "mat2 value;",
       "value = mat2(first, first, first, last);",
       {"value"},
       4,
       "value[0][1] + 2.0 * value[1][1]"},
      {"mat3",
       "mat3 value;",
       "value = mat3(vec3(first), vec3(first), vec3(first, first, last));",
       {"value"},
       9,
       "value[1][0] + 2.0 * value[2][2]"},
      {"mat4",
       "mat4 value;",
       "value = mat4(vec4(first), vec4(first), vec4(first), vec4(first, first, first, last));",
       {"value"},
       16,
       "value[1][0] + 2.0 * value[3][3]"},
      {"mat2x3",
       "mat2x3 value;",
       "value = mat2x3(vec3(first), vec3(first, first, last));",
       {"value"},
       6,
       "value[0][0] + 2.0 * value[1][2]"},
      {"mat3x2",
       "mat3x2 value;",
       "value = mat3x2(vec2(first), vec2(first), vec2(first, last));",
       {"value"},
       6,
       "value[0][0] + 2.0 * value[2][1]"},
      {"mat4x3",
       "mat4x3 value;",
       "value = mat4x3(vec3(first), vec3(first), vec3(first), vec3(first, first, last));",
       {"value"},
       12,
       "value[0][0] + 2.0 * value[3][2]"},
      {"mat2x4",
       "mat2x4 value;",
       "value = mat2x4(vec4(first), vec4(first, first, first, last));",
       {"value"},
       8,
       "value[0][0] + 2.0 * value[1][3]"},
      {"floats",
       "float value[3];",
       "value[0] = first; value[1] = first; value[2] = last;",
       {"value"},
       3,
       "value[0] + 2.0 * value[2]"},
      {"vectors",
       "vec3 value[2];",
       "value[0] = vec3(first); value[1] = vec3(first, first, last);",
       {"value"},
       6,
       "value[0].x + 2.0 * value[1].z"},
      {"matrices",
       "mat2 value[2];",
       "value[0] = mat2(vec2(first), vec2(first)); value[1] = mat2(first, first, first, last);",
       {"value"},
       8,
       "value[0][0].x + 2.0 * value[1][1].y"},
      {"structure",
       "Structure value;",
       "value.a = first; value.b = vec3(first); value.c = mat2(first, first, first, last);",
       {"value.a", "value.b", "value.c"},
       8,
       "value.b.y + 2.0 * value.c[1][1]"},
      {"block",
       "Block { vec3 a; mat2 b; float c; } value;",
       "value.a = vec3(first); value.b = mat2(vec2(first), vec2(first)); value.c = last;",
       {"Block.a", "Block.b", "Block.c"},
       8,
       "value.a.x + 2.0 * value.c"},
      {"flat_vec3", "vec3 value;", "value = vec3(first, first, last);", {"value"}, 3, "value.x + 2.0 * value.z", true},
      {"flat_mat2",
       "mat2 value;",
       "value = mat2(first, first, first, last);",
       {"value"},
       4,
       "value[0][1] + 2.0 * value[1][1]",
       true},
      {"int", "int value;", "value = int(16.0 * last);", {"value"}, 1, "float(value) / 16.0", true, true},
      {"ivec3",
       "ivec3 value;",
       "value = ivec3(16.0 * vec3(first, first, last));",
       {"value"},
       3,
       "(float(value.x) + 2.0 * float(value.z)) / 16.0",
       true,
       true},
      {"uvec4",
       "uvec4 value;",
       "value = uvec4(16.0 * vec4(first, first, first, last));",
       {"value"},
       4,
       "(float(value.x) + 2.0 * float(value.w)) / 16.0",
       true,
       true},
      {"uints",
       "uint value[2];",
       "value[0] = uint(16.0 * first); value[1] = uint(16.0 * last);",
       {"value"},
       2,
       "(float(value[0]) + 2.0 * float(value[1])) / 16.0",
       true,
       true},
  };
  return all;
}

// Doubles are flat outputs, and are captured as two words.
const CornerOutput double_output{"doubles",
                                 "dvec2 value;",
                                 "value = dvec2(first, last);",
                                 {"value"},
                                 4,
                                 "float(value.x) + 2.0 * float(value.y)",
                                 true,
                                 false,
                                 desktop_apis};

GLuint corner_program(Test& t, const CornerOutput& output) {
  const std::string flat = output.is_flat ? "flat " : "";
  const std::string structure = "struct Structure { float a; vec3 b; mat2 c; };\n";
  Sources sources{.vertex = fmt::format("layout(location = 0) in vec4 position; layout(location = 2) in vec3 weights;\n"
                                        "layout(location = 7) in vec2 values;\n{}{}out {}\nout vec3 weights_out;\n"
                                        "void main() {{ float first = values.x; float last = values.y;\n  {}\n"
                                        "  weights_out = weights; gl_Position = position; }}\n",
                                        structure, flat, output.declaration, output.assignment),
                  .fragment = fmt::format("{}{}in {}\nout vec4 pixel;\nvoid main() {{ float sum = 0.3 * ({});\n"
                                          "  pixel = vec4(sum, 1.0 - sum, 0.5, 1.0); }}\n",
                                          structure, flat, output.declaration, output.sum),
                  .captured = {"weights_out"}};
  sources.captured.insert(sources.captured.end(), output.captured.begin(), output.captured.end());
  return build_program(t, sources);
}

// Values at the three corners.
struct CornerValues {
  const char* name;
  std::array<Vec2, 3> values;
};
constexpr CornerValues corner_values[] = {
    {"0 and 1 alike", {{{0.25F, 0.25F}, {0.25F, 0.25F}, {1, 1}}}},
    {"1 and 2 alike", {{{0.75F, 0.75F}, {0.1875F, 0.1875F}, {0.1875F, 0.1875F}}}},
    {"2 and 0 alike", {{{0.5F, 0.5F}, {1, 1}, {0.5F, 0.5F}}}},
    {"the last of corner 0 differs", {{{0.5F, 1}, {0.5F, 0.25F}, {0.5F, 0.25F}}}},
    {"the last of corner 1 differs", {{{0.25F, 0.5F}, {0.25F, 1}, {0.25F, 0.5F}}}},
    {"the last of corner 2 differs", {{{0.375F, 0.25F}, {0.375F, 0.25F}, {0.375F, 0.875F}}}},
    {"all but the last of corner 0 differ", {{{1, 0.5F}, {0.25F, 0.5F}, {0.25F, 0.5F}}}},
    {"all but the last of corner 1 differ", {{{0.5F, 0.25F}, {1, 0.25F}, {0.5F, 0.25F}}}},
    {"all but the last of corner 2 differ", {{{0.25F, 0.375F}, {0.25F, 0.375F}, {0.875F, 0.375F}}}},
    {"all alike", {{{0.5F, 0.25F}, {0.5F, 0.25F}, {0.5F, 0.25F}}}},
    {"all differ", {{{0.25F, 1}, {0.75F, 0.5F}, {0.5F, 0.125F}}}},
};

void upload_corner_values(const CornerValues& each) {
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(each.values), each.values.data(), GL_STATIC_DRAW);
}

// What a flat or refined component is in each captured vertex: the provoking corner is the last one.
float expected_component(const CornerOutput& output, const CornerValues& each, std::size_t component,
                         const reference::Weights& at) {
  const std::size_t k = component + 1 == output.components ? 1 : 0;
  if (output.is_flat) return each.values[2][k];
  return reference::refined(each.values[0][k], each.values[1][k], each.values[2][k], at);
}

std::optional<std::string> fault_of_outputs(const CornerOutput& output, const CornerValues& each,
                                            const std::vector<float>& captured) {
  const std::size_t stride = 3 + output.components;
  for (std::size_t at = 0; at < captured.size(); at += stride) {
    const auto weights = reference::exact_weights(captured[at], captured[at + 1], captured[at + 2]);
    if (!weights.has_value()) return "weights that are none";
    for (std::size_t k = 0; k < output.components; ++k) {
      const float expected = expected_component(output, each, k, *weights);
      float actual = captured[at + 3 + k];
      if (output.is_integer) actual = static_cast<float>(std::bit_cast<GLint>(actual)) / 16;
      if (actual != expected)
        return fmt::format("component {} at ({}, {}, {}): expected {}, got {}", k, captured[at], captured[at + 1],
                           captured[at + 2], expected, actual);
    }
  }
  return std::nullopt;
}

void expect_corner_outputs(Test& t, const CornerOutput& output, const CornerValues& each, std::size_t triangles,
                           const std::string& what) {
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  if (output.apis.contains(Api::gles)) {  // doubles are compared by the picture alone
    const auto bytes = capture_bytes(t, 4 * (3 + output.components), 3, 2000, GL_TRIANGLES, draw);
    std::vector<float> captured(bytes.size() / 4);
    std::memcpy(captured.data(), bytes.data(), bytes.size());
    t.expect_equal(captured.size(), 3 * triangles * (3 + output.components), what + ": captured components");
    const std::optional<std::string> fault = fault_of_outputs(output, each, captured);
    t.expect(!fault.has_value(), what + ": " + fault.value_or(""));
  }
  const Picture refined = picture_of(draw);
  gl.Disable(GL_ARK);
  t.expect_same_picture(refined, picture_of(draw), what, 4, 80);
}

void check_corner_outputs(Test& t, const CornerOutput& output) {
  gl.UseProgram(corner_program(t, output));
  upload(one_triangle(), false);
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.VertexAttribPointer(at_values, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.EnableVertexAttribArray(at_values);
  bool by_tags = false;
  for (const CornerValues& each : corner_values) {
    upload_corner_values(each);
    for (const GLenum refinement : {GL_LINEAR_OUTPUTS_ARK, GL_LINEAR_INPUTS_ARK}) {
      by_tags = !by_tags;
      const std::string what =
          fmt::format("{}, refinement 0x{:x}, {}", each.name, refinement, by_tags ? "tags" : "a uniform depth");
      by_tags ? refine_by_tags(2, refinement) : refine_uniformly(2, refinement);
      gl.DepthTag1i(2);
      expect_corner_outputs(t, output, each, 16, what);
    }
    by_tags = !by_tags;
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases shared_corners_cases() {
  Cases cases;
  const auto add = [&](const CornerOutput& output) {
    cases.push_back(
        {.name = fmt::format("ark.linear.alike.{}", output.leaf),
         .clauses = {"11.R.6-8", "11.R.6-6", "11.R.6-10", "11.R.6-2"},
         .plan = "Two corners give this output the same value, or all components of it but one. Capture "
                 "the refined values, and compare the picture.",
         .wrong = "A value that two corners share is taken for constant; components after the first differ.",
         .apis = output.apis,
         .check = [&output](Test& t) { check_corner_outputs(t, output); }});
  };
  for (const CornerOutput& output : corner_outputs()) add(output);
  add(double_output);
  return cases;
}

}  // namespace glark::conformance
