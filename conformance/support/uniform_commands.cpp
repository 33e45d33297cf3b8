// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/support/uniform_commands.h"

#include <fmt/core.h>

#include <algorithm>

namespace glark::conformance {
namespace {

template <typename Number>
std::array<Number, elements_of_array * numbers_of_element> as(const double* numbers, std::size_t count) {
  std::array<Number, elements_of_array * numbers_of_element> converted{};
  std::transform(numbers, numbers + count, converted.begin(), [](double n) { return static_cast<Number>(n); });
  return converted;
}

#define COMPONENTS_1 v[0]
#define COMPONENTS_2 v[0], v[1]
#define COMPONENTS_3 v[0], v[1], v[2]
#define COMPONENTS_4 v[0], v[1], v[2], v[3]

// Uniform3f, Uniform3fv, ProgramUniform3f and ProgramUniform3fv of a type with n components.
#define VECTOR_COMMANDS(n, suffix, number, type)                                                        \
  {"Uniform" #n #suffix,                                                                                \
   type,                                                                                                \
   1,                                                                                                   \
   n,                                                                                                   \
   false,                                                                                               \
   [](GLuint, GLint location, GLsizei, const double* numbers) {                                         \
     const auto v = as<number>(numbers, n);                                                             \
     gl.Uniform##n##suffix(location, COMPONENTS_##n);                                                   \
   }},                                                                                                  \
      {"Uniform" #n #suffix "v",                                                                        \
       type,                                                                                            \
       1,                                                                                               \
       n,                                                                                               \
       true,                                                                                            \
       [](GLuint, GLint location, GLsizei count, const double* numbers) {                               \
         gl.Uniform##n##suffix##v(location, count, as<number>(numbers, n * std::size_t(count)).data()); \
       }},                                                                                              \
      {"ProgramUniform" #n #suffix,                                                                     \
       type,                                                                                            \
       1,                                                                                               \
       n,                                                                                               \
       false,                                                                                           \
       [](GLuint program, GLint location, GLsizei, const double* numbers) {                             \
         const auto v = as<number>(numbers, n);                                                         \
         gl.ProgramUniform##n##suffix(program, location, COMPONENTS_##n);                               \
       }},                                                                                              \
  {                                                                                                     \
    "ProgramUniform" #n #suffix "v", type, 1, n, true,                                                  \
        [](GLuint program, GLint location, GLsizei count, const double* numbers) {                      \
          gl.ProgramUniform##n##suffix##v(program, location, count,                                     \
                                          as<number>(numbers, n * std::size_t(count)).data());          \
        }                                                                                               \
  }
#define VECTORS(suffix, number, scalar, vector)                                               \
  VECTOR_COMMANDS(1, suffix, number, scalar), VECTOR_COMMANDS(2, suffix, number, vector "2"), \
      VECTOR_COMMANDS(3, suffix, number, vector "3"), VECTOR_COMMANDS(4, suffix, number, vector "4")

#define MATRIX_COMMANDS(type, size, suffix, number, columns, rows)                                                \
  {"UniformMatrix" #size #suffix,                                                                                 \
   type #size,                                                                                                    \
   columns,                                                                                                       \
   rows,                                                                                                          \
   true,                                                                                                          \
   [](GLuint, GLint location, GLsizei count, const double* numbers) {                                             \
     gl.UniformMatrix##size##suffix(location, count, GL_FALSE,                                                    \
                                    as<number>(numbers, columns * rows * std::size_t(count)).data());             \
   }},                                                                                                            \
  {                                                                                                               \
    "ProgramUniformMatrix" #size #suffix, type #size, columns, rows, true,                                        \
        [](GLuint program, GLint location, GLsizei count, const double* numbers) {                                \
          gl.ProgramUniformMatrix##size##suffix(program, location, count, GL_FALSE,                               \
                                                as<number>(numbers, columns * rows * std::size_t(count)).data()); \
        }                                                                                                         \
  }
#define MATRICES(type, suffix, number)                                                                    \
  MATRIX_COMMANDS(type, 2, suffix, number, 2, 2), MATRIX_COMMANDS(type, 3, suffix, number, 3, 3),         \
      MATRIX_COMMANDS(type, 4, suffix, number, 4, 4), MATRIX_COMMANDS(type, 2x3, suffix, number, 2, 3),   \
      MATRIX_COMMANDS(type, 3x2, suffix, number, 3, 2), MATRIX_COMMANDS(type, 2x4, suffix, number, 2, 4), \
      MATRIX_COMMANDS(type, 4x2, suffix, number, 4, 2), MATRIX_COMMANDS(type, 3x4, suffix, number, 3, 4), \
      MATRIX_COMMANDS(type, 4x3, suffix, number, 4, 3)

}  // namespace

const std::vector<UniformCommand>& uniform_commands() {
  static const std::vector<UniformCommand> all = {
      VECTORS(f, GLfloat, "float", "vec"),    VECTORS(i, GLint, "int", "ivec"),    VECTORS(ui, GLuint, "uint", "uvec"),
      VECTORS(d, GLdouble, "double", "dvec"), VECTORS(f, GLfloat, "bool", "bvec"), VECTORS(i, GLint, "bool", "bvec"),
      VECTORS(ui, GLuint, "bool", "bvec"),    MATRICES("mat", fv, GLfloat),        MATRICES("dmat", dv, GLdouble)};
  return all;
}

std::vector<std::string> types_of_uniforms() {
  std::vector<std::string> types;
  for (const UniformCommand& command : uniform_commands())
    if (std::find(types.begin(), types.end(), command.type) == types.end()) types.push_back(command.type);
  return types;
}

bool is_double_type(const std::string& type) { return type.starts_with('d'); }

std::string UniformCommand::component(const std::string& element, int number) const {
  return element + (columns > 1 ? fmt::format("[{}]", number / rows) : "") +
         (rows > 1 ? fmt::format("[{}]", number % rows) : "");
}

}  // namespace glark::conformance
