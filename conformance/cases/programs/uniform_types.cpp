// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Uniforms of every type in a refined vertex stage, set before its first refined draw and after it (11.R.10).
#include <fmt/core.h>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

using Values = std::array<GLfloat, 64>;

struct Type {
  const char* name;
  int columns;  // 1 if it is no matrix
  int rows;
  char scalar;  // f, i, u, b
};

constexpr Type types[] = {
    {"float", 1, 1, 'f'},  {"vec2", 1, 2, 'f'},   {"vec3", 1, 3, 'f'},   {"vec4", 1, 4, 'f'},   {"int", 1, 1, 'i'},
    {"ivec2", 1, 2, 'i'},  {"ivec3", 1, 3, 'i'},  {"ivec4", 1, 4, 'i'},  {"uint", 1, 1, 'u'},   {"uvec2", 1, 2, 'u'},
    {"uvec3", 1, 3, 'u'},  {"uvec4", 1, 4, 'u'},  {"bool", 1, 1, 'b'},   {"bvec2", 1, 2, 'b'},  {"bvec3", 1, 3, 'b'},
    {"bvec4", 1, 4, 'b'},  {"mat2", 2, 2, 'f'},   {"mat3", 3, 3, 'f'},   {"mat4", 4, 4, 'f'},   {"mat2x3", 2, 3, 'f'},
    {"mat2x4", 2, 4, 'f'}, {"mat3x2", 3, 2, 'f'}, {"mat3x4", 3, 4, 'f'}, {"mat4x2", 4, 2, 'f'}, {"mat4x3", 4, 3, 'f'}};

// A number that each component of the uniform changes. It shifts a triangle and its colours.
std::string sum_of(const Type& type, const std::string& name, int first_weight) {
  std::string sum;
  for (int column = 0; column < type.columns; ++column)
    for (int row = 0; row < type.rows; ++row) {
      const std::string element = name + (type.columns > 1 ? fmt::format("[{}]", column) : "") +
                                  (type.rows > 1 ? fmt::format("[{}]", row) : "");
      const int weight = first_weight + type.rows * column + row;
      sum += fmt::format("{}{}) * {}.0", (sum.empty() ? "float(" : " + float("), element, weight);
    }
  return sum;
}

GLuint program_of(Test& t, const Type& type, int elements) {
  std::string sum = sum_of(type, elements == 1 ? "value" : "value[0]", 1);
  for (int i = 1; i < elements; ++i) sum += " + " + sum_of(type, fmt::format("value[{}]", i), 1 + 16 * i);
  const std::string array = elements == 1 ? "" : fmt::format("[{}]", elements);
  return build_program(t, {.vertex = std::string("layout(location = 0) in vec4 position; out vec4 colour; uniform ") +
                                     std::string(type.scalar == 'b' ? "" : "highp ") + type.name + " value" + array +
                                     ";\nvoid main() { float sum = (" + sum +
                                     ") / 64.0;\n  colour = vec4(fract(sum), fract(sum * 0.37), 1.0, 1.0);\n"
                                     "  gl_Position = position; }\n"});
}

void set_matrices(const Type& type, GLint location, GLsizei count, const GLfloat* values) {
  switch (10 * type.columns + type.rows) {
    case 22: gl.UniformMatrix2fv(location, count, GL_FALSE, values); break;
    case 33: gl.UniformMatrix3fv(location, count, GL_FALSE, values); break;
    case 44: gl.UniformMatrix4fv(location, count, GL_FALSE, values); break;
    case 23: gl.UniformMatrix2x3fv(location, count, GL_FALSE, values); break;
    case 24: gl.UniformMatrix2x4fv(location, count, GL_FALSE, values); break;
    case 32: gl.UniformMatrix3x2fv(location, count, GL_FALSE, values); break;
    case 34: gl.UniformMatrix3x4fv(location, count, GL_FALSE, values); break;
    case 42: gl.UniformMatrix4x2fv(location, count, GL_FALSE, values); break;
    default: gl.UniformMatrix4x3fv(location, count, GL_FALSE, values); break;
  }
}

void set_vectors(const Type& type, GLint location, GLsizei count, const Values& values) {
  std::array<GLint, 64> whole{};
  std::array<GLuint, 64> natural{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    whole[i] = static_cast<GLint>(values[i]);
    natural[i] = static_cast<GLuint>(values[i]);
  }
  using Floats = void (*)(GLint, GLsizei, const GLfloat*);
  using Whole = void (*)(GLint, GLsizei, const GLint*);
  using Natural = void (*)(GLint, GLsizei, const GLuint*);
  const Floats floats[] = {gl.Uniform1fv, gl.Uniform2fv, gl.Uniform3fv, gl.Uniform4fv};
  const Whole integers[] = {gl.Uniform1iv, gl.Uniform2iv, gl.Uniform3iv, gl.Uniform4iv};
  const Natural unsigned_integers[] = {gl.Uniform1uiv, gl.Uniform2uiv, gl.Uniform3uiv, gl.Uniform4uiv};
  if (type.scalar == 'f') floats[type.rows - 1](location, count, values.data());
  if (type.scalar == 'i' || type.scalar == 'b') integers[type.rows - 1](location, count, whole.data());
  if (type.scalar == 'u') unsigned_integers[type.rows - 1](location, count, natural.data());
}

void set_uniform(const Type& type, GLuint program, GLsizei count, int round) {
  Values values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const int number = (static_cast<int>(i) * 7 + 3 + 5 * round) % 11;
    values[i] = static_cast<GLfloat>(type.scalar == 'b' ? (static_cast<int>(i) + round) % 2 : number);
  }
  const GLint location = gl.GetUniformLocation(program, "value");
  type.columns > 1 ? set_matrices(type, location, count, values.data()) : set_vectors(type, location, count, values);
}

Picture picture_of_triangle() {
  clear_surface();
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  return read_picture(surface_size, surface_size);
}

void check_type(Test& t, const Type& type, int elements) {
  const GLuint program = program_of(t, type, elements);
  upload(one_triangle());
  refine_uniformly(2);
  // The first value is set before the program's first refined draw, the others after it.
  Picture last(surface_size, surface_size);
  gl.UseProgram(program);
  for (int round = 0; round < 3; ++round) {
    set_uniform(type, program, elements, round);
    const Picture refined = picture_of_triangle();
    gl.Disable(GL_ARK);
    const Picture plain = picture_of_triangle();
    gl.Enable(GL_ARK);
    t.expect_same_picture(refined, plain, "value " + as_text(round), 2, 30);
    t.expect(count_different(plain, last, 0) > 1000, "the value shows");
    last = plain;
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases uniform_types_cases() {
  Cases cases;
  for (const Type& type : types)
    for (const int elements : {1, 3})
      cases.push_back(
          {.name = std::string("ark.stage.uniform.") + type.name + (elements == 1 ? ".single" : ".array"),
           .clauses = {"11.R.10-1"},
           .plan = "Colours follow from a uniform that is set before the first refined draw, and twice after.",
           .wrong = "The value of another type, element or component; only the first or the last value.",
           .check = [&type, elements](Test& t) { check_type(t, type, elements); }});
  return cases;
}

}  // namespace glark::conformance
