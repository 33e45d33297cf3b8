// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The attribute of the depth tags is one of the locations of an input that takes several: a column of a matrix, an element
// of an array (10.R.1). The tag is the first component of that location.
#include <fmt/core.h>

#include "conformance/cases/cases.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

constexpr GLuint first_wide = 4;  // the first location of the input

struct WideInput {
  const char* declaration;  // of `wide`
  GLuint locations;
  const char* sum;  // of some component of each location
};

constexpr WideInput wide_inputs[] = {
    {"mat2 wide", 2, "wide[0].x + wide[1].x"},
    {"mat2x3 wide", 2, "wide[0].y + wide[1].z"},
    {"mat2x4 wide", 2, "wide[0].w + wide[1].w"},
    {"mat3 wide", 3, "wide[0].x + wide[1].y + wide[2].z"},
    {"mat3x2 wide", 3, "wide[0].y + wide[1].y + wide[2].y"},
    {"mat3x4 wide", 3, "wide[0].x + wide[1].x + wide[2].w"},
    {"mat4 wide", 4, "wide[0].x + wide[1].y + wide[2].z + wide[3].w"},
    {"mat4x2 wide", 4, "wide[0].x + wide[1].y + wide[2].x + wide[3].y"},
    {"mat4x3 wide", 4, "wide[0].z + wide[1].z + wide[2].z + wide[3].z"},
    {"float wide[3]", 3, "wide[0] + wide[1] + wide[2]"},
    {"vec2 wide[2]", 2, "wide[0].y + wide[1].y"},
    {"vec4 wide[4]", 4, "wide[0].x + wide[1].y + wide[2].z + wide[3].w"},
    {"mat2 wide[2]", 4, "wide[0][0].x + wide[0][1].y + wide[1][0].x + wide[1][1].y"},
    {"mat3x2 wide[2]", 6, "wide[0][0].x + wide[0][1].y + wide[0][2].x + wide[1][0].x + wide[1][1].y + wide[1][2].x"}};

bool is_array(const WideInput& input) { return std::string_view(input.declaration).ends_with(']'); }

void use_wide_program(Test& t, const WideInput& input) {
  gl.UseProgram(build_program(
      t, {.vertex = fmt::format("layout(location = 0) in vec4 position; layout(location = {}) in {};\n"
                                "out vec4 colour; void main() {{ float sum = {};\n"
                                "  colour = vec4(0.5, 1.0, 0.25 + 0.01 * sum, 1.0); gl_Position = position; }}\n",
                                first_wide, input.declaration, input.sum)}));
}

// Four components for each vertex: the first one is the tag, the others would be other tags.
void set_wide_location(GLuint location, float tag, bool from_array) {
  if (!from_array) {
    gl.DisableVertexAttribArray(location);
    gl.VertexAttrib4f(location, tag, 3, 1, 2);
    return;
  }
  const Vec4 value = {tag, 3, 1, 2};
  const Vec4 values[] = {value, value, value};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(values), values, GL_STATIC_DRAW);
  gl.VertexAttribPointer(location, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.EnableVertexAttribArray(location);
}

// Each location has another tag: 1, 2, 3, 0, 1, ...
void check_wide_locations(Test& t, const WideInput& input, bool from_arrays) {
  use_wide_program(t, input);
  upload(one_triangle(), false);
  refine_by_tags(3);
  for (GLuint i = 0; i < input.locations; ++i) {
    // An attribute keeps its values when it becomes that of the tags, but for the current tag.
    gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, static_cast<GLint>(first_wide + i));
    for (GLuint k = 0; k < input.locations; ++k)
      set_wide_location(first_wide + k, static_cast<float>((k + 1) % 4), from_arrays);
    const GLuint expected = GLuint{1} << (2 * ((i + 1) % 4));
    for (int again = 0; again < 2; ++again)
      t.expect_equal(count_generated([] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }), expected,
                     fmt::format("triangles with the tag in location {} of {}", i, input.declaration));
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases tags_in_wide_inputs_cases() {
  Cases cases;
  for (const bool has_arrays : {false, true})
    for (const bool from_arrays : {true, false})
      cases.push_back({.name = std::string("ark.tag.attribute.wide.") + (has_arrays ? "arrays." : "matrices.") +
                               (from_arrays ? "array" : "current"),
                       .clauses = {"10.R.1-2", "10.R.1-3", "10.R.1-8"},
                       .plan = "Make each location of one input the attribute of the depth tags in turn. Each location "
                               "has a tag of its own.",
                       .wrong = "The tag of the input's first location, or of another component.",
                       .apis = has_arrays ? desktop_apis : every_api,
                       .check = [has_arrays, from_arrays](Test& t) {
                         for (const WideInput& input : wide_inputs)
                           if (is_array(input) == has_arrays) check_wide_locations(t, input, from_arrays);
                       }});
  return cases;
}

}  // namespace glark::conformance
