// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Uniform matrices of every size, set by UniformMatrix* and ProgramUniformMatrix*, with transpose FALSE and TRUE, alone or
// several elements of an array, directly and by a display list.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <span>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

constexpr int matrix_elements = 3;  // of each array
using MatrixNumbers = std::array<double, std::size_t{16} * matrix_elements>;

struct MatrixSetter {
  const char* type;
  int columns;
  int rows;
  void (*of_current)(GLint location, GLsizei count, GLboolean transpose, const MatrixNumbers& numbers);
  void (*of_program)(GLuint program, GLint location, GLsizei count, GLboolean transpose, const MatrixNumbers& numbers);
};

template <typename Number>
std::array<Number, std::size_t{16} * matrix_elements> as(const MatrixNumbers& numbers) {
  std::array<Number, std::size_t{16} * matrix_elements> converted{};
  std::transform(numbers.begin(), numbers.end(), converted.begin(), [](double n) { return static_cast<Number>(n); });
  return converted;
}

#define MATRIX_SETTER(type, suffix, number, columns, rows)                                            \
  {                                                                                                   \
#type, columns, rows,                                                                               \
        [](GLint location, GLsizei count, GLboolean transpose, const MatrixNumbers& numbers) {                \
          gl.UniformMatrix##suffix(location, count, transpose, as<number>(numbers).data());             \
        },                                                                                              \
        [](GLuint program, GLint location, GLsizei count, GLboolean transpose, const MatrixNumbers& numbers) { \
          gl.ProgramUniformMatrix##suffix(program, location, count, transpose, as<number>(numbers).data()); \
        } \
  }
#define MATRIX_SETTERS(type, suffix, number)                                                                    \
  MATRIX_SETTER(type##2, 2##suffix, number, 2, 2), MATRIX_SETTER(type##3, 3##suffix, number, 3, 3),             \
      MATRIX_SETTER(type##4, 4##suffix, number, 4, 4), MATRIX_SETTER(type##2x3, 2x3##suffix, number, 2, 3),     \
      MATRIX_SETTER(type##3x2, 3x2##suffix, number, 3, 2), MATRIX_SETTER(type##2x4, 2x4##suffix, number, 2, 4), \
      MATRIX_SETTER(type##4x2, 4x2##suffix, number, 4, 2), MATRIX_SETTER(type##3x4, 3x4##suffix, number, 3, 4), \
      MATRIX_SETTER(type##4x3, 4x3##suffix, number, 4, 3)

constexpr MatrixSetter singles[] = {MATRIX_SETTERS(mat, fv, GLfloat)};
constexpr MatrixSetter doubles[] = {MATRIX_SETTERS(dmat, dv, GLdouble)};

// Each component of each element has a weight of its own.
std::string matrix_sum_of(std::span<const MatrixSetter> setters) {
  std::string sum = "0.0";
  int weight = 1;
  for (const MatrixSetter& setter : setters)
    for (int element = 0; element < matrix_elements; ++element)
      for (int column = 0; column < setter.columns; ++column)
        for (int row = 0; row < setter.rows; ++row)
          sum +=
              fmt::format(" + {}.0 * float(of_{}[{}][{}][{}])", 1 + weight++ % 23, setter.type, element, column, row);
  return sum;
}

std::string declarations_of(std::span<const MatrixSetter> setters) {
  std::string text;
  for (const MatrixSetter& setter : setters)
    text += fmt::format("uniform {0} of_{0}[{1}];\n", setter.type, matrix_elements);
  return text;
}

// The sum in 256ths, as a colour.
std::string matrix_colour_of(const std::string& sum) {
  return "vec4(fract(" + sum + "), fract(0.37 * (" + sum + ")), 1.0, 1.0)";
}

std::string stage_of(std::span<const MatrixSetter> setters, bool is_separable = false) {
  return "layout(location = 0) in vec4 position;\n" + declarations_of(setters) +
         (is_separable ? "layout(location = 0) " : "") + "out vec4 colour;\nvoid main() { float sum = (" +
         matrix_sum_of(setters) + ") / 16.0;\n  colour = " + matrix_colour_of("sum") + "; gl_Position = position; }\n";
}

MatrixNumbers numbers_from(int turn) {
  MatrixNumbers numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = 0.125 * static_cast<double>((static_cast<std::size_t>(turn) * 5 + i * i + 3 * i) % 13);
  return numbers;
}

struct MatrixWay {
  const char* leaf;
  bool is_named = false;   // ProgramUniformMatrix*
  bool is_listed = false;  // by a display list
  bool is_pipeline = false;
};

constexpr MatrixWay matrix_ways[] = {{"current"},
                                     {"named", true},
                                     {"current.listed", false, true},
                                     {"named.listed", true, true},
                                     {"pipeline.current", false, false, true},
                                     {"pipeline.named", true, false, true}};

void draw_matrices() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

// Sets one element, or the last two, of each matrix in turn. A draw without refinement shows what GL made of it.
void check_setters(Test& t, std::span<const MatrixSetter> setters, const MatrixWay& way, GLuint program) {
  upload(one_triangle());
  refine_uniformly(2);
  Picture before = picture_of(draw_matrices);
  int turn = 0;
  for (const MatrixSetter& setter : setters)
    for (const GLboolean transpose : {GLboolean{GL_TRUE}, GLboolean{GL_FALSE}})
      for (const GLsizei count : {1, 2}) {
        const std::string what = fmt::format("{} elements of {}, {}", count, setter.type,
                                             transpose == GL_TRUE ? "transposed" : "as they are");
        const GLint location = gl.GetUniformLocation(program, fmt::format("of_{}[1]", setter.type).c_str());
        const MatrixNumbers numbers = numbers_from(++turn);
        if (way.is_listed) gl.NewList(1, GL_COMPILE);
        if (way.is_named)
          setter.of_program(program, location, count, transpose, numbers);
        else
          setter.of_current(location, count, transpose, numbers);
        if (way.is_listed) {
          gl.EndList();
          gl.CallList(1);
        }
        const Picture refined = picture_of(draw_matrices);
        gl.Disable(GL_ARK);
        const Picture plain = picture_of(draw_matrices);
        gl.Enable(GL_ARK);
        t.expect(count_different(before, plain, 2) > 300, what + ": the matrix shows");
        t.expect_same_picture(refined, plain, what, 2, 40);
        before = plain;
      }
  t.expect_no_error("the matrices");
}

void check_matrices(Test& t, std::span<const MatrixSetter> setters, const MatrixWay& way) {
  if (!way.is_pipeline) {
    const GLuint program = build_program(t, {.vertex = stage_of(setters)});
    gl.UseProgram(program);
    check_setters(t, setters, way, program);
    return;
  }
  const Pipeline pipeline =
      bind_pipeline(t, stage_of(setters, true),
                    "layout(location = 0) in vec4 colour; out vec4 pixel; void main() { pixel = colour; }\n");
  gl.UseProgram(0);
  gl.ActiveShaderProgram(pipeline.name, pipeline.vertex_program);
  check_setters(t, setters, way, pipeline.vertex_program);
}

// The same matrices in the refinement shader of one program and in the vertex stage of another one.
void check_shader_matrices(Test& t, bool is_named) {
  const GLuint plain = build_program(t, {.vertex = stage_of(singles)});
  const GLuint refined = colour_program(t);
  gl.UseProgram(refined);
  upload(one_triangle());
  refine_uniformly(2);
  set_refinement_shader(t, refined,
                        declarations_of(singles) + "void refine() { float sum = (" + matrix_sum_of(singles) +
                            ") / 16.0; vertex_colour = " + matrix_colour_of("sum") + "; }\n");
  Picture before = picture_of(draw_matrices);
  int turn = 0;
  for (const MatrixSetter& setter : singles)
    for (const GLboolean transpose : {GLboolean{GL_TRUE}, GLboolean{GL_FALSE}})
      for (const GLsizei count : {1, 2}) {
        const MatrixNumbers numbers = numbers_from(++turn);
        const auto set = [&](GLuint program) {
          const GLint location = gl.GetUniformLocation(program, fmt::format("of_{}[1]", setter.type).c_str());
          gl.UseProgram(program);
          if (is_named)
            setter.of_program(program, location, count, transpose, numbers);
          else
            setter.of_current(location, count, transpose, numbers);
        };
        const std::string what = fmt::format("{} elements of {}, {}", count, setter.type,
                                             transpose == GL_TRUE ? "transposed" : "as they are");
        set(refined);
        const Picture actual = picture_of(draw_matrices);
        gl.Disable(GL_ARK);
        set(plain);
        const Picture expected = picture_of(draw_matrices);
        gl.Enable(GL_ARK);
        gl.UseProgram(refined);
        t.expect(count_different(before, expected, 2) > 300, what + ": the matrix shows");
        t.expect_same_picture(actual, expected, what, 2, 40);
        before = expected;
      }
  t.expect_no_error("the matrices");
}

}  // namespace

Cases matrix_uniforms_cases() {
  Cases cases;
  const char* const wrong = "The transposed matrix; the earlier one; another element.";
  for (const bool is_double : {false, true})
    for (const MatrixWay& way : matrix_ways) {
      const std::span<const MatrixSetter> setters = is_double ? std::span<const MatrixSetter>(doubles) : singles;
      cases.push_back({.name = std::string("ark.program.matrices.") + (is_double ? "doubles." : "singles.") + way.leaf,
                       .clauses = {"11.R.10-1"},
                       .plan = "Set uniform matrices of all sizes between refined draws, transposed or not, and "
                               "compare with draws without refinement.",
                       .wrong = wrong,
                       .apis = way.is_listed ? compat_only
                               : is_double   ? desktop_apis
                                             : every_api,
                       .check = [setters, &way](Test& t) { check_matrices(t, setters, way); }});
    }
  for (const bool is_named : {false, true})
    cases.push_back({.name = std::string("ark.shader.matrices.") + (is_named ? "named" : "current"),
                     .clauses = {"11.R.9-22"},
                     .plan = "Set uniform matrices of all sizes in a refinement shader, transposed or not, and compare "
                             "with a vertex stage that has the same ones.",
                     .wrong = wrong,
                     .check = [is_named](Test& t) { check_shader_matrices(t, is_named); }});
  return cases;
}

}  // namespace glark::conformance
